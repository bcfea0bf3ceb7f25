#include "unity/TextureImporter.h"
#include "Mentions.h"
#include "SceneFolder.h"

#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/Material.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A picture "wood.png" and what Unity keeps beside it.
class TextureImporter : public testing::Test
{
protected:
    TextureImporter() { WritePicture("wood.png"); }

    void WritePicture(const std::string& name) const
    {
        WritePng(m_Scene / name,
                 {8, 2, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(8 * 2 * 4)});
    }
    /// As Unity writes it, with these lines in it.
    void WriteMeta(const std::string& lines, const std::string& name = "wood.png") const
    {
        m_Scene.Write(name + ".meta", "fileFormatVersion: 2\n"
                                      "guid: 1e5a11f2b3c4d5e6f708192a3b4c5d6e\n"
                                      "TextureImporter:\n"
                                      "  internalIDToNameTable: []\n" +
                                          lines);
    }
    std::shared_ptr<const Texture2D> Load()
    {
        return m_Scene.assets.LoadTexture(m_Scene / "wood.png");
    }
    std::shared_ptr<const Texture2D> LoadWith(const std::string& lines)
    {
        WriteMeta(lines);
        m_Scene.assets.Forget(m_Scene / "wood.png");
        return Load();
    }
    std::vector<std::string> ProblemsWith(const std::string& lines)
    {
        std::vector<std::string> problems = Problems([&] { LoadWith(lines); });
        EXPECT_EQ(diagnosticFile(lines), (m_Scene / "wood.png.meta").generic_string());
        return problems;
    }
    std::string diagnosticFile(const std::string& lines)
    {
        try
        {
            LoadWith(lines);
        }
        catch (const AssetError& error)
        {
            return error.diagnostics().front().file;
        }
        return "";
    }

    SceneFolder m_Scene;
};

TEST_F(TextureImporter, HasUnitysDefaultsWithoutAMetaFileOrWithNoneOfItsKeys)
{
    const auto expectDefaults = [](const Texture2D& texture)
    {
        EXPECT_EQ(texture.mipmapCount(), 4); // 8x2, 4x1, 2x1, 1x1
        EXPECT_EQ(texture.graphicsFormat(), GraphicsFormat::R8G8B8A8_SRGB);
        EXPECT_EQ(texture.sampler(), SamplerState());
    };
    expectDefaults(*Load());
    expectDefaults(*LoadWith("  mipmaps:\n    mipMapMode: 0\n  isReadable: 0\n"));
    expectDefaults(*LoadWith("  textureSettings:\n    filterMode: -1\n    aniso: -1\n"
                             "    mipBias: -100\n    wrapU: -1\n    wrapV: -1\n    wrapW: -1\n"));
    m_Scene.Write("wood.png.meta", "fileFormatVersion: 2\nguid: aa\n");
    m_Scene.assets.Forget(m_Scene / "wood.png.meta");
    expectDefaults(*Load());
}

TEST_F(TextureImporter, SwitchesMipMapsOff)
{
    EXPECT_EQ(LoadWith("  mipmaps:\n    enableMipMap: 0\n")->mipmapCount(), 1);
    EXPECT_EQ(LoadWith("  mipmaps:\n    enableMipMap: 1\n")->mipmapCount(), 4);
}

TEST_F(TextureImporter, SaysWhetherColoursAreSrgb)
{
    EXPECT_EQ(LoadWith("  mipmaps:\n    sRGBTexture: 0\n")->graphicsFormat(),
              GraphicsFormat::R8G8B8A8_UNorm);
    EXPECT_EQ(LoadWith("  mipmaps:\n    sRGBTexture: 1\n  textureType: 0\n")->graphicsFormat(),
              GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_EQ(LoadWith("  mipmaps:\n    sRGBTexture: 1\n  textureType: 1\n")->graphicsFormat(),
              GraphicsFormat::R8G8B8A8_UNorm)
        << "a normal map";
}

TEST_F(TextureImporter, SaysHowTheTextureIsSampled)
{
    const auto texture =
        LoadWith("  textureSettings:\n    serializedVersion: 2\n    filterMode: 2\n    aniso: 8\n"
                 "    mipBias: 0.5\n    wrapU: 1\n    wrapV: 2\n    wrapW: 3\n");
    const SamplerState& sampler = texture->sampler();
    EXPECT_EQ(sampler.filterMode, FilterMode::Trilinear);
    EXPECT_EQ(sampler.anisoLevel, 8);
    EXPECT_EQ(sampler.mipMapBias, 0.5f);
    EXPECT_EQ(sampler.wrapModeU, TextureWrapMode::Clamp);
    EXPECT_EQ(sampler.wrapModeV, TextureWrapMode::Mirror);
    EXPECT_EQ(sampler.wrapModeW, TextureWrapMode::MirrorOnce);
    // Before Unity 2017 there was one for all.
    EXPECT_EQ(LoadWith("  textureSettings:\n    wrapMode: 1\n    aniso: 0\n")->sampler().wrapModeV,
              TextureWrapMode::Clamp);
    EXPECT_EQ(Load()->sampler().anisoLevel, 1);
    EXPECT_EQ(LoadWith("  textureSettings:\n    filterMode: 0\n")->sampler().filterMode,
              FilterMode::Point);
}

TEST_F(TextureImporter, SaysWhereAWrongValueStands)
{
    EXPECT_THAT(ProblemsWith("  mipmaps:\n    enableMipMap: off\n    sRGBTexture: 2\n"
                             "  textureSettings:\n    filterMode: 3\n    aniso: 17\n    wrapU: 4\n"
                             "    mipBias: .nan\n  textureType: normal\n"),
                ElementsAre(HasSubstr("6:19: TextureImporter.mipmaps.enableMipMap: "),
                            HasSubstr("7:18: TextureImporter.mipmaps.sRGBTexture: "),
                            HasSubstr("9:17: TextureImporter.textureSettings.filterMode: "),
                            HasSubstr("10:12: TextureImporter.textureSettings.aniso: "),
                            HasSubstr("11:12: TextureImporter.textureSettings.wrapU: "),
                            HasSubstr("12:14: TextureImporter.textureSettings.mipBias: "),
                            HasSubstr("13:16: TextureImporter.textureType: ")));
    EXPECT_THAT(ProblemsWith("  mipmaps: [1]\n"),
                ElementsAre(HasSubstr("5:12: TextureImporter.mipmaps: ")));
}

TEST_F(TextureImporter, IsReadAgainWhenItsFileChanges)
{
    EXPECT_EQ(Load()->mipmapCount(), 4);
    EXPECT_EQ(m_Scene.assets.reachedFiles().count(m_Scene / "wood.png.meta"), 1u)
        << "so that it is watched, be it there or not";
    WriteMeta("  mipmaps:\n    enableMipMap: 0\n");
    m_Scene.assets.Forget(m_Scene / "wood.png.meta");
    EXPECT_EQ(Load()->mipmapCount(), 1);
}

TEST_F(TextureImporter, IsNotReadThroughALinkThatLeadsElsewhere)
{
    const SceneFolder elsewhere;
    elsewhere.Write("other.meta", "TextureImporter: {textureType: secret}\n");
    std::filesystem::create_symlink(elsewhere / "other.meta", m_Scene / "wood.png.meta");
    m_Scene.assets.AddRootsAround(m_Scene / "s.scene.yaml");
    EXPECT_THAT(Problems([&] { Load(); }), ElementsAre(HasSubstr("lies outside")));
}

TEST_F(TextureImporter, LeavesOfANormalMapRedAndGreenAndNoAlpha)
{
    const std::vector<std::byte> texel = {std::byte{200}, std::byte{90}, std::byte{7},
                                          std::byte{13}};
    WritePng(m_Scene / "wood.png", {1, 1, GraphicsFormat::R8G8B8A8_SRGB, texel});
    const auto texelsWith = [&](const std::string& lines)
    {
        const std::shared_ptr<const Texture2D> texture = LoadWith(lines);
        EXPECT_EQ(texture->graphicsFormat(), GraphicsFormat::R8G8B8A8_UNorm);
        std::vector<int> numbers;
        for (const std::byte value : texture->texels())
        {
            numbers.push_back(std::to_integer<int>(value));
        }
        return numbers;
    };
    EXPECT_THAT(texelsWith("  textureType: 1\n"), ElementsAre(200, 90, 7, 255));
    EXPECT_THAT(texelsWith("  textureType: 1\n  flipGreenChannel: 1\n"),
                ElementsAre(200, 165, 7, 255));
    EXPECT_THAT(texelsWith("  flipGreenChannel: 1\n  mipmaps:\n    sRGBTexture: 0\n"),
                ElementsAre(200, 90, 7, 13))
        << "a picture that is no normal map";
}

TEST_F(TextureImporter, IsThatOfTheTextureOfAScenesMaterial)
{
    WritePicture("b.png");
    m_Scene.Write("volume.shader",
                  "Shader \"V\" {\n"
                  "Properties { _Fog(\"\", 3D) = \"\" {}  _Map(\"\", 2D) = \"\" {} }\n"
                  "SubShader { Pass { } } }\n");
    const std::string scene = "materials:\n"
                              "  m: {shader: volume.shader, _Fog: {slices: [wood.png, b.png]}, "
                              "_Map: wood.png}\n"
                              "objects: [{name: a, mesh: cube, material: m}]\n";
    WriteMeta("  mipmaps:\n    sRGBTexture: 0\n  textureSettings:\n    filterMode: 0\n");
    EXPECT_THAT(m_Scene.ProblemsOf("camera: {}\n" + scene),
                ElementsAre(Mentions("'b.png'", "sRGB", "linear", "'wood.png'")));
    WriteMeta("  mipmaps:\n    sRGBTexture: 0\n", "b.png");
    m_Scene.assets.Forget(m_Scene / "b.png.meta");
    SceneAsset asset = m_Scene.LoadWithCamera(scene);
    const Material& material = *asset.scene.Find("a")->renderer->sharedMaterials.at(0);
    for (const char* name : {"_Fog", "_Map"})
    {
        const auto texture = material.GetTexture(ShaderPropertyId(name));
        ASSERT_NE(texture, nullptr) << name;
        EXPECT_EQ(texture->graphicsFormat(), GraphicsFormat::R8G8B8A8_UNorm) << name;
        EXPECT_EQ(texture->sampler().filterMode, FilterMode::Point) << name;
    }
}

TEST_F(TextureImporter, SaysHowLargeATextureMayBe)
{
    const auto sizeWith = [&](const std::string& lines)
    {
        const auto texture = LoadWith(lines);
        return std::pair(texture->width(), texture->height());
    };
    EXPECT_EQ(sizeWith("  maxTextureSize: 8\n"), std::pair(8, 2));
    EXPECT_EQ(sizeWith("  maxTextureSize: 4\n"), std::pair(4, 1));
    const std::string platforms = "  platformSettings:\n"
                                  "  - serializedVersion: 3\n    buildTarget: Standalone\n"
                                  "    maxTextureSize: 1\n    overridden: 0\n"
                                  "  - buildTarget: DefaultTexturePlatform\n"
                                  "    maxTextureSize: 2\n    overridden: 0\n";
    EXPECT_EQ(sizeWith("  maxTextureSize: 2048\n" + platforms), std::pair(2, 1));
    EXPECT_EQ(sizeWith("  platformSettings:\n  - buildTarget: Standalone\n"
                       "    maxTextureSize: 4\n    overridden: 1\n"),
              std::pair(4, 1));
    EXPECT_THAT(ProblemsWith("  maxTextureSize: 0\n"),
                ElementsAre(HasSubstr("5:19: TextureImporter.maxTextureSize: ")));
}

TEST_F(TextureImporter, SaysWhatItsChannelsAre)
{
    WritePng(m_Scene / "wood.png", {1,
                                    1,
                                    GraphicsFormat::R8G8B8A8_SRGB,
                                    {std::byte{10}, std::byte{20}, std::byte{60}, std::byte{7}}});
    const auto texelWith = [&](const std::string& lines)
    {
        std::vector<int> texel;
        for (const std::byte byte : LoadWith(lines)->texels())
        {
            texel.push_back(std::to_integer<int>(byte));
        }
        return texel;
    };
    EXPECT_THAT(texelWith("  swizzle: 50462976\n"), ElementsAre(10, 20, 60, 7));
    EXPECT_THAT(texelWith("  alphaUsage: 0\n"), ElementsAre(10, 20, 60, 255));
    EXPECT_THAT(texelWith("  alphaUsage: 2\n"), ElementsAre(10, 20, 60, 30));
    // 3 = alpha, 4 = one minus red, 8 = nothing, 9 = one; red's is the lowest byte.
    EXPECT_THAT(texelWith("  swizzle: 151520259\n"), ElementsAre(7, 245, 0, 255));
    EXPECT_THAT(texelWith("  textureType: 1\n"), ElementsAre(10, 20, 60, 255));
    EXPECT_THAT(texelWith("  textureType: 1\n  flipGreenChannel: 1\n"),
                ElementsAre(10, 235, 60, 255));
    EXPECT_THAT(texelWith("  textureType: 1\n  bumpmap:\n    convertToNormalMap: 1\n"),
                ElementsAre(128, 128, 255, 255));
    EXPECT_THAT(texelWith("  alphaIsTransparency: 1\n  nPOTScale: 1\n"),
                ElementsAre(10, 20, 60, 7));
}

TEST_F(TextureImporter, IsImportedFromTheCacheTheSame)
{
    std::vector<std::byte> texels;
    for (int i = 0; i < 8 * 2 * 4; ++i)
    {
        texels.push_back(static_cast<std::byte>(i * 3));
    }
    WritePng(m_Scene / "wood.png", {8, 2, GraphicsFormat::R8G8B8A8_SRGB, texels});
    Importer::Options options;
    options.cacheFolder = m_Scene / "cache";
    const auto fresh = ImportTexture(m_Scene / "wood.png");
    const auto stored = ImportTexture(m_Scene / "wood.png", Importer(options));
    const auto kept = ImportTexture(m_Scene / "wood.png", Importer(options));
    EXPECT_TRUE(std::filesystem::exists(m_Scene / "cache"));
    for (const auto& texture : {stored, kept})
    {
        EXPECT_EQ(texture->texels(), fresh->texels());
        EXPECT_EQ(texture->graphicsFormat(), fresh->graphicsFormat());
        EXPECT_EQ(texture->mipmapCount(), fresh->mipmapCount());
    }
}

TEST_F(TextureImporter, NamesAPointerOfGitLfs)
{
    m_Scene.Write("wood.png", "version https://git-lfs.github.com/spec/v1\noid sha256:0\n");
    EXPECT_THAT(Problems([&] { Load(); }),
                ElementsAre(Mentions("Git LFS", "picture", "'git lfs pull'")));
}

/// The colour that a cube shows in a direction, by the table of cube maps of Direct3D 11's
/// specification: the face is that of the largest coordinate, and its texels begin at the top left.
std::array<int, 3> ColorTowards(const Cubemap& cube, const glm::vec3& d)
{
    const glm::vec3 size = glm::abs(d);
    const bool isX = size.x > size.y && size.x > size.z;
    const bool isY = !isX && size.y > size.z;
    const float away = isX ? size.x : isY ? size.y : size.z;
    const bool isNegative = (isX ? d.x : isY ? d.y : d.z) < 0.0f;
    const float s = isX ? (isNegative ? d.z : -d.z) : isY ? d.x : (isNegative ? -d.x : d.x);
    const float t = isY ? (isNegative ? -d.z : d.z) : -d.y;
    const int face = (isX ? 0 : isY ? 2 : 4) + (isNegative ? 1 : 0);
    const auto texel = [&](float along)
    {
        return static_cast<int>((along / away + 1.0f) / 2.0f * static_cast<float>(cube.width()));
    };
    const int index = (face * cube.width() + texel(t)) * cube.width() + texel(s);
    const std::byte* const first = cube.texels().data() + 4 * index;
    return {std::to_integer<int>(first[0]), std::to_integer<int>(first[1]),
            std::to_integer<int>(first[2])};
}

/// Pictures whose .meta file makes them cubes.
class CubeImporter : public TextureImporter
{
protected:
    /// @param color  of the texel in a column and a row, from the top left
    void WriteSky(int width, int height,
                  const std::function<std::array<int, 3>(int x, int y)>& color) const
    {
        Image image{width, height, GraphicsFormat::R8G8B8A8_SRGB, {}};
        for (int y = 0; y < height; ++y)
        {
            for (int x = 0; x < width; ++x)
            {
                for (const int channel : color(x, y))
                {
                    image.texels.push_back(static_cast<std::byte>(channel));
                }
                image.texels.push_back(std::byte{255});
            }
        }
        WritePng(m_Scene / "sky.png", image);
    }
    std::shared_ptr<const Cubemap> LoadSky(const std::string& lines = "  textureShape: 2\n")
    {
        WriteMeta(lines, "sky.png");
        m_Scene.assets.Forget(m_Scene / "sky.png");
        return m_Scene.assets.LoadCubemap(m_Scene / "sky.png");
    }
};

TEST_F(CubeImporter, CutsCrossesAndStripsSoThatNeighboursInThemAreNeighboursInTheCube)
{
    struct Cell
    {
        const char* name;
        glm::ivec2 columnAndRow;
        glm::vec3 middle, right, up; ///< as the picture shows them
    };
    const std::vector<Cell> wide = {{"+X", {2, 1}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                    {"-X", {0, 1}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                    {"+Y", {1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                                    {"-Y", {1, 2}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                    {"+Z", {1, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                    {"-Z", {3, 1}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}};
    std::vector<Cell> high = wide;
    high[5] = {"-Z below -Y", {1, 3}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
    std::vector<Cell> row = wide;
    std::vector<Cell> column = wide;
    for (int i = 0; i < 6; ++i)
    {
        row[static_cast<std::size_t>(i)].columnAndRow = {i, 0};
        column[static_cast<std::size_t>(i)].columnAndRow = {0, i};
    }
    for (const auto& [cells, size] :
         {std::pair(wide, glm::ivec2(4, 3)), std::pair(high, glm::ivec2(3, 4)),
          std::pair(row, glm::ivec2(6, 1)), std::pair(column, glm::ivec2(1, 6))})
    {
        WriteSky(size.x * 4, size.y * 4, [](int x, int y) { return std::array{9 * x, 9 * y, 0}; });
        const auto cube = LoadSky();
        ASSERT_NE(cube, nullptr);
        EXPECT_EQ(cube->width(), 4);
        EXPECT_EQ(cube->mipmapCount(), 3);
        for (const Cell& cell : cells)
        {
            for (const glm::ivec2 texel : {glm::ivec2(0, 0), glm::ivec2(3, 1), glm::ivec2(1, 3)})
            {
                const glm::vec2 place = (glm::vec2(texel) + 0.5f) / 2.0f - 1.0f;
                const glm::ivec2 there = cell.columnAndRow * 4 + texel;
                EXPECT_EQ(
                    ColorTowards(*cube, cell.middle + place.x * cell.right - place.y * cell.up),
                    (std::array{9 * there.x, 9 * there.y, 0}))
                    << size.x << ":" << size.y << " " << cell.name;
            }
        }
    }
}

TEST_F(CubeImporter, LooksLongitudesAndLatitudesUpFilteredInLinearLight)
{
    // Plus z in the middle of the picture, plus x right of it: as HDRP's functions have it.
    constexpr int k_Width = 256;
    const auto color = [](double longitude, double latitude)
    {
        return std::array{128 + static_cast<int>(std::lround(100 * std::sin(longitude))),
                          128 + static_cast<int>(std::lround(100 * std::cos(longitude))),
                          128 + static_cast<int>(std::lround(70 * latitude))};
    };
    constexpr double k_Pi = 3.141592653589793;
    WriteSky(k_Width, k_Width / 2,
             [&](int x, int y)
             {
                 return color((x + 0.5) / k_Width * 2 * k_Pi - k_Pi,
                              k_Pi / 2 - (y + 0.5) / k_Width * 2 * k_Pi);
             });
    for (const int mapping : {6, 2})
    {
        const auto cube =
            LoadSky("  textureShape: 2\n  generateCubemap: " + std::to_string(mapping) + "\n");
        ASSERT_NE(cube, nullptr);
        EXPECT_EQ(cube->width(), k_Width / 4);
        for (const glm::vec3 direction :
             {glm::vec3(0.1f, 0.2f, 1.0f), glm::vec3(1.0f, -0.3f, 0.2f),
              glm::vec3(-1.0f, 0.5f, 0.4f), glm::vec3(0.02f, 0.1f, -1.0f),
              glm::vec3(-0.02f, 0.1f, -1.0f), glm::vec3(0.5f, 1.0f, 0.4f),
              glm::vec3(0.4f, -1.0f, -0.3f)})
        {
            const std::array<int, 3> seen = ColorTowards(*cube, direction);
            const std::array<int, 3> wanted =
                color(std::atan2(direction.x, direction.z), std::asin(glm::normalize(direction).y));
            for (std::size_t i = 0; i < 3; ++i)
            {
                // A texel of the face is up to 1/32 wide, 100/32 of a colour and its rounding.
                EXPECT_NEAR(seen[i], wanted[i], 4) << direction.x << " " << direction.y;
            }
        }
    }
    // Black and white columns in turn. Weights are of light, not of the bytes for it.
    WriteSky(8, 4, [](int x, int) { return std::array{x % 2 * 255, 0, 0}; });
    const double white = (std::atan2(0.5, 1.0) / (2 * k_Pi) + 0.5) * 8 - 0.5 - 4; // of column 5
    EXPECT_NEAR(ColorTowards(*LoadSky(), {0.5f, 0.5f, 1.0f})[0],
                255 * (1.055 * std::pow(white, 1 / 2.4) - 0.055), 1);
}

TEST_F(CubeImporter, LimitsTheSizeOfAFace)
{
    WriteSky(64, 48, [](int, int) { return std::array{1, 2, 3}; });
    EXPECT_EQ(LoadSky("  textureShape: 2\n  maxTextureSize: 8\n")->width(), 8);
    WriteSky(64, 32, [](int, int) { return std::array{1, 2, 3}; });
    EXPECT_EQ(LoadSky("  textureShape: 2\n  maxTextureSize: 8\n")->width(), 8);
}

TEST_F(CubeImporter, SaysWhatItDoesNotReadAndIsNothingWhereNobodyAskedForACube)
{
    WriteSky(8, 8, [](int, int) { return std::array{1, 2, 3}; });
    EXPECT_THAT(Problems([&] { LoadSky(); }),
                ElementsAre(Mentions("8x8", "mirroring ball", "twice as wide", "4:3")));
    WriteSky(12, 2, [](int, int) { return std::array{1, 2, 3}; });
    EXPECT_THAT(Problems([&] { LoadSky("  textureShape: 2\n  generateCubemap: 1\n"); }),
                ElementsAre(HasSubstr("mirroring ball")));
    EXPECT_EQ(LoadSky("  textureShape: 1\n"), nullptr);
    EXPECT_EQ(m_Scene.assets.LoadCubemap(m_Scene / "wood.png"), nullptr) << "no .meta file";
}

} // namespace
} // namespace limn::test
