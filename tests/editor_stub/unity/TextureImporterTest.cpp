#include "unity/TextureImporter.h"
#include "Mentions.h"
#include "SceneFolder.h"

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

} // namespace
} // namespace limn::test
