#include "Mentions.h"
#include "SceneFolder.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/Material.h>

namespace limn::test
{

namespace
{

using testing::Contains;
using testing::ElementsAre;
using Lines = std::vector<std::string>;

constexpr const char* k_Files[] = {"px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"};

/// A picture whose texels' red is `first`, `first` + 1 ... in the order of the file, from the top.
void WritePicture(const std::filesystem::path& path, int width, int height, int first)
{
    Image image{width, height, GraphicsFormat::R8G8B8A8_SRGB, {}};
    for (int i = 0; i < width * height; ++i)
    {
        image.texels.push_back(static_cast<std::byte>(first + i));
        image.texels.insert(image.texels.end(), 3, std::byte{255});
    }
    WritePng(path, image);
}

class TextureProperty : public testing::Test
{
protected:
    /// A file whose header says that 256 MiB of texels would come.
    void WriteVastPicture(const std::string& name) const
    {
        WritePicture(folder / name, 1, 1, 0);
        std::fstream file(folder / name, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(16); // its width and height: 16384x4096
        file.write("\0\0\x40\0\0\0\x10\0", 8);
    }

    void SetUp() override
    {
        folder.Write("own.shader",
                     "Shader \"Own\" { Properties { _Map (\"\", 2D) = \"\" {}\n"
                     "_Sky (\"\", Cube) = \"\" {} _Skies (\"\", CubeArray) = \"\" {}\n"
                     "_Fog (\"\", 3D) = \"\" {} _Sheets (\"\", 2DArray) = \"\" {} }\n"
                     "SubShader { Pass { } } }");
        for (int i = 0; i < 6; ++i)
        {
            WritePicture(folder / k_Files[i], 2, 2, 10 * i); // 0 1 above 2 3, and so on
        }
        WritePicture(folder / "wide.png", 2, 1, 0);
        WritePicture(folder / "large.png", 4, 4, 0);
    }

    static std::string SceneWith(const std::string& property)
    {
        return "camera: {}\nmaterials:\n  m:\n    shader: own.shader\n    " + property +
               "\nobjects: [{name: a, mesh: cube, material: m}]\n";
    }

    std::shared_ptr<const Texture> Read(const std::string& name, const std::string& value)
    {
        m_Asset = folder.Load(SceneWith(name + ": " + value));
        const Material& material = *m_Asset.scene.Find("a")->renderer->sharedMaterials.at(0);
        const ShaderPropertyValue* found = material.Find(ShaderPropertyId(name));
        return found ? std::get<std::shared_ptr<const Texture>>(*found) : nullptr;
    }

    /// The red of every texel.
    std::vector<int> Reds(const std::string& name, const std::string& value)
    {
        const auto texture = std::dynamic_pointer_cast<const TexelTexture>(Read(name, value));
        std::vector<int> reds;
        for (std::size_t i = 0; texture && i < texture->texels().size(); i += 4)
        {
            reds.push_back(std::to_integer<int>(texture->texels()[i]));
        }
        return reds;
    }

    Lines ProblemsOf(const std::string& property) { return folder.ProblemsOf(SceneWith(property)); }

    SceneFolder folder;

private:
    SceneAsset m_Asset;
};

const std::string k_SixFaces = "{faces: [px.png, nx.png, py.png, ny.png, pz.png, nz.png]}";

} // namespace

TEST_F(TextureProperty, MakesACubeOfSixFacesTheTopRowFirst)
{
    EXPECT_EQ((std::vector{0,  1,  2,  3,  10, 11, 12, 13, 20, 21, 22, 23,
                           30, 31, 32, 33, 40, 41, 42, 43, 50, 51, 52, 53}),
              Reds("_Sky", k_SixFaces));
    const auto sky = Read("_Sky", k_SixFaces);
    EXPECT_EQ(TextureDimension::Cube, sky->dimension());
    EXPECT_EQ("px.png", sky->name());
    EXPECT_EQ(GraphicsFormat::R8G8B8A8_SRGB, sky->graphicsFormat());
    EXPECT_EQ(1u, folder.assets.reachedFiles().count(folder / "nz.png"));
}

TEST_F(TextureProperty, MakesACubeOfOnePictureThatItsMetaFileMakesOne)
{
    WritePicture(folder / "strip.png", 6, 1, 0);
    EXPECT_THAT(ProblemsOf("_Sky: strip.png"),
                ElementsAre(Mentions("5:11: material 'm'._Sky:", "'strip.png'", "its .meta file")));
    folder.Write("strip.png.meta", "TextureImporter:\n  textureShape: 2\n");
    folder.assets.Forget(folder / "strip.png.meta");
    EXPECT_EQ((std::vector{0, 1, 2, 3, 4, 5}), Reds("_Sky", "strip.png"));
    EXPECT_THAT(ProblemsOf("_Sky: nosuch.hdr"),
                Contains(Mentions("5:11: material 'm'._Sky:", "'nosuch.hdr'", "cannot be used")));
}

TEST_F(TextureProperty, MakesAnArrayOfCubes)
{
    const auto skies = Read("_Skies", "{faces: [px.png, nx.png, py.png, ny.png, pz.png, nz.png, "
                                      "nz.png, pz.png, ny.png, py.png, nx.png, px.png]}");
    ASSERT_NE(nullptr, skies);
    EXPECT_EQ(TextureDimension::CubeArray, skies->dimension());
    EXPECT_EQ(12, skies->slices());
    const auto& texels = dynamic_cast<const TexelTexture&>(*skies).texels();
    EXPECT_EQ(std::byte{50}, texels.at(6 * 4 * 4)) << "the second cube begins with nz.png";
}

TEST_F(TextureProperty, StacksSlicesTheBottomRowFirst)
{
    EXPECT_EQ((std::vector{2, 3, 0, 1, 12, 13, 10, 11}),
              Reds("_Fog", "{slices: [px.png, nx.png]}"));
    EXPECT_EQ(TextureDimension::Tex3D, Read("_Fog", "{slices: [px.png]}")->dimension());
    EXPECT_EQ((std::vector{12, 13, 10, 11, 2, 3, 0, 1}),
              Reds("_Sheets", "{slices: [nx.png, px.png]}"));
    EXPECT_EQ(TextureDimension::Tex2DArray, Read("_Sheets", "{slices: [px.png]}")->dimension());
}

TEST_F(TextureProperty, TakesADefaultInItsOwnDimension)
{
    for (const auto& [name, dimension] :
         {std::pair{"_Map", TextureDimension::Tex2D}, std::pair{"_Fog", TextureDimension::Tex3D},
          std::pair{"_Sky", TextureDimension::Cube},
          std::pair{"_Sheets", TextureDimension::Tex2DArray},
          std::pair{"_Skies", TextureDimension::CubeArray}})
    {
        const auto texture = Read(name, "red");
        ASSERT_NE(nullptr, texture) << name;
        EXPECT_EQ("red", texture->name());
        EXPECT_EQ(dimension, texture->dimension()) << name;
    }
}

TEST_F(TextureProperty, SaysWhatATextureOfItsDimensionLooksLike)
{
    const std::string names = "white, black, gray, linearGray, bump, red, green, blue, clear";
    EXPECT_THAT(ProblemsOf("_Map: {slices: [px.png]}"),
                ElementsAre(Mentions("5:11: material 'm'._Map:", "a map", ".png", names)));
    EXPECT_THAT(
        ProblemsOf("_Sky: px.png"),
        ElementsAre(Mentions("5:11: material 'm'._Sky:", "'px.png'", "{faces: [six .png", names)));
    EXPECT_THAT(
        ProblemsOf("_Fog: [px.png]"),
        ElementsAre(Mentions("5:11: material 'm'._Fog:", "sequence", "{slices: [.png", names)));
    EXPECT_THAT(
        ProblemsOf("_Sheets: mauve"),
        ElementsAre(Mentions("5:14: material 'm'._Sheets:", "'mauve'", "{slices: [.png", names)));
}

TEST_F(TextureProperty, CountsFacesAndSlices)
{
    EXPECT_THAT(ProblemsOf("_Sky: {faces: [px.png, nx.png]}"),
                ElementsAre(Mentions("5:19: material 'm'._Sky.faces:", "2 files",
                                     ".meta file makes a cube", "{faces: [six .png")));
    EXPECT_THAT(
        ProblemsOf("_Skies: {faces: [px.png]}"),
        ElementsAre(Mentions("5:21: material 'm'._Skies.faces:", "1 file;", "six .png", "a cube")));
    EXPECT_THAT(
        ProblemsOf("_Fog: {slices: []}"),
        ElementsAre(Mentions("5:20: material 'm'._Fog.slices:", "0 files", "{slices: [.png")));
    EXPECT_THAT(
        ProblemsOf("_Fog: {slices: px.png}"),
        ElementsAre(Mentions("5:20: material 'm'._Fog.slices:", "'px.png'", "{slices: [.png")));
}

TEST_F(TextureProperty, NamesAKeyOfAnotherDimension)
{
    EXPECT_THAT(
        ProblemsOf("_Sky: {slices: [px.png]}"),
        ElementsAre(Mentions("5:11: material 'm'._Sky:", "'faces'", "missing"),
                    Mentions("5:12: material 'm'._Sky:", "unknown key", "'slices'", "faces")));
}

TEST_F(TextureProperty, NamesThePictureThatDoesNotFit)
{
    EXPECT_THAT(ProblemsOf("_Fog: {slices: [px.png, wide.png, large.png]}"),
                ElementsAre(Mentions("5:29: material 'm'._Fog.slices[1]:", "'wide.png'", "2x1",
                                     "2x2", "'px.png'"),
                            Mentions("5:39: material 'm'._Fog.slices[2]:", "'large.png'", "4x4",
                                     "2x2", "'px.png'")));
    EXPECT_THAT(
        ProblemsOf("_Sky: {faces: [wide.png, wide.png, wide.png, wide.png, wide.png, "
                   "wide.png]}"),
        ElementsAre(Mentions("5:20: material 'm'._Sky.faces[0]:", "'wide.png'", "2x1", "square")));
}

TEST_F(TextureProperty, NamesAPictureThatCannotBeRead)
{
    const Lines problems = ProblemsOf("_Fog: {slices: [px.png, none.png]}");
    ASSERT_FALSE(problems.empty());
    EXPECT_THAT(problems.front(),
                Mentions("5:29: material 'm'._Fog.slices[1]:", "'none.png'", "cannot be used"));
}

TEST_F(TextureProperty, OfSlicesThatTakeTooMuchMemoryIsRefusedBeforeTheyAreDecoded)
{
    WriteVastPicture("vast.png");
    std::string slices = "vast.png";
    for (int i = 1; i < 9; ++i)
    {
        slices += ", vast.png";
    }
    EXPECT_THAT(ProblemsOf("_Sheets: {slices: [" + slices + "]}"),
                ElementsAre(Mentions("5:23: material 'm'._Sheets.slices:", "9 pictures", "2304 MiB",
                                     "2048 MiB")));
}

TEST_F(TextureProperty, ThatMakesAllPicturesTakeTooMuchMemoryIsRefusedBeforeItIsDecoded)
{
    std::string materials;
    std::string objects;
    for (int i = 0; i < 17; ++i)
    {
        const std::string name = "vast" + std::to_string(10 + i);
        WriteVastPicture(name + ".png");
        materials += "  " + name + ": {shader: own.shader, _Map: " + name + ".png}\n";
        objects += "  - {name: " + name + ", mesh: cube, material: " + name + "}\n";
    }
    const Lines problems =
        folder.ProblemsOf("camera: {}\nmaterials:\n" + materials + "objects:\n" + objects);
    const auto tooMuch = Mentions("256 MiB", "4352 MiB", "at most 4096 MiB");
    EXPECT_THAT(problems, testing::Contains(tooMuch).Times(1));
    EXPECT_THAT(problems.back(), tooMuch); // the last one's
}

TEST_F(TextureProperty, OfAMaterialThatNothingNamesIsCheckedAndNotDecoded)
{
    folder.Write("torn.png", "\x89PNG\r\n\x1A\n and no more");
    folder.Write("text.png", "no picture");
    const auto problems = [&](const std::string& property, const std::string& used)
    {
        std::vector<std::string> found;
        try
        {
            folder.Load("camera: {}\nmaterials:\n  plain: {}\n  other: {shader: own.shader, " +
                        property + "}\nobjects: [{name: a, mesh: cube, material: " + used + "}]\n");
        }
        catch (const AssetError& error)
        {
            found = Texts(error.diagnostics());
        }
        return found;
    };
    EXPECT_EQ(Lines(), problems("_Map: torn.png", "plain"));
    EXPECT_EQ(Lines(), problems("_Sky: {faces: [torn.png, torn.png, torn.png, torn.png, torn.png, "
                                "torn.png]}",
                                "plain"));
    EXPECT_NE(Lines(), problems("_Map: torn.png", "other"));
    EXPECT_NE(Lines(), problems("_Map: text.png", "plain"));
    EXPECT_NE(Lines(), problems("_Map: none.png", "plain"));
    EXPECT_NE(Lines(), problems("_Mop: white", "plain"));
}

} // namespace limn::test
