#include "SceneFolder.h"
#include "scene/ProfileContext.h"

#include <gmock/gmock.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/Image.h>
#include <limn/volume/AssetParameters.h>
#include <limn/volume/ValueParameters.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

struct Paint : VolumeComponent
{
    Texture2DParameter ramp{this, "m_Ramp", {}};
    MaterialParameter material{this, "m_Material", {}};
    LayerMaskParameter layers{this, "m_Layers", {}};
};

/// A profile in a folder, of a component with references.
class ProfileReference : public testing::Test
{
protected:
    ProfileReference()
    {
        m_Registry.Register<Paint>("Paint");
        std::filesystem::create_directory(folder / "art");
        WritePng(folder / "art/ramp.png",
                 Image{2, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(8)});
    }

    VolumeProfileLoadResult Load(const std::string& text, const std::string& name = "p.yaml")
    {
        const std::filesystem::path path = folder.Write(name, text);
        const SceneProfileContext context(folder.assets, path, m_Layers);
        return LoadVolumeProfile(path, m_Registry, context);
    }

    const Paint& Read(const std::string& text, const std::string& name = "p.yaml")
    {
        m_Result = Load(text, name);
        return *m_Result.profile->TryGet<Paint>();
    }

    /// The folder's own path taken out.
    std::vector<std::string> ProblemsOf(const std::string& text)
    {
        std::vector<std::string> problems = Problems([&] { Load(text); });
        const std::string path = (folder / "").generic_string();
        for (std::string& problem : problems)
        {
            const std::size_t at = problem.find(path);
            problem = at == std::string::npos ? problem : problem.erase(at, path.size());
        }
        return problems;
    }

    SceneFolder folder;
    LayerNames m_Layers;

private:
    VolumeComponentRegistry m_Registry;
    VolumeProfileLoadResult m_Result;
};

TEST_F(ProfileReference, LoadsATextureBesideTheProfileOnce)
{
    const std::shared_ptr<const Texture> ramp =
        Read("Paint: {ramp: art/ramp.png}\n").ramp.value().asset;
    ASSERT_NE(nullptr, ramp);
    EXPECT_EQ("ramp.png", ramp->name());
    EXPECT_EQ(ramp, Read("Paint: {ramp: art/ramp.png}\n").ramp.value().asset);
    EXPECT_EQ(1u, folder.assets.reachedFiles().count(folder / "art/ramp.png"));
}

TEST_F(ProfileReference, LoadsAMaterialFile)
{
    folder.Write("red.material.yaml", "renderQueue: 2999\n_BaseMap: art/ramp.png\n");
    const std::shared_ptr<const Material> red =
        Read("Paint: {material: red.material.yaml}\n").material.value().asset;
    ASSERT_NE(nullptr, red);
    EXPECT_EQ("red", red->name());
    EXPECT_EQ(2999, red->renderQueue());
    EXPECT_EQ(red, folder.assets.LoadMaterial(folder / "red.material.yaml"));
}

TEST_F(ProfileReference, RefusesAMissingFileAndOneOfAnotherKind)
{
    folder.Write("bad.material.yaml", "renderQueue: 9999\nshader: None/Such\n");
    EXPECT_THAT(ProblemsOf("Paint:\n  ramp: none.png\n  material: art/ramp.png\n"),
                ElementsAre(HasSubstr("2:9: Paint.m_Ramp: none.png: "),
                            "3:13: Paint.m_Material: art/ramp.png: the file is no material; a "
                            ".material.yaml file is expected"));
    EXPECT_THAT(
        ProblemsOf("Paint: {ramp: on.profile.yaml}\n"),
        ElementsAre("1:15: Paint.m_Ramp: on.profile.yaml: the file is no texture; a .png file is "
                    "expected"));
    EXPECT_THAT(ProblemsOf("Paint: {material: bad.material.yaml}\n"),
                ElementsAre(HasSubstr("1:19: Paint.m_Material: bad.material.yaml:2:9: material "
                                      "'bad'.shader: unknown shader 'None/Such'")));
}

TEST_F(ProfileReference, FollowsUnitysGuidsThroughTheProject)
{
    std::filesystem::create_directory(folder / "Assets");
    std::filesystem::rename(folder / "art/ramp.png", folder / "Assets/ramp.png");
    folder.Write("Assets/ramp.png.meta", "fileFormatVersion: 2\nguid: abc123\n");
    folder.Write("Assets/red.mat.meta", "fileFormatVersion: 2\nguid: def456\n");
    const auto text = [](const std::string& ramp, const std::string& material)
    {
        return "Paint:\n  ramp: {fileID: 2800000, guid: " + ramp +
               ", type: 3}\n  material: {fileID: 2100000, guid: " + material + ", type: 2}\n";
    };
    EXPECT_NE(nullptr, Read(text("abc123", "def456"), "Assets/p.yaml").ramp.value().asset);
    EXPECT_THAT(Texts(Load(text("0000", "def456"), "Assets/p.yaml").notes),
                ElementsAre("2:9: Paint.m_Ramp: it stays without a texture: no .meta file of the "
                            "project has the guid '0000'",
                            "3:13: Paint.m_Material: it stays without a material: 'red.mat' is "
                            "Unity's and is not read; a .material.yaml file can be"));
}

TEST_F(ProfileReference, KnowsTheLayersOfTheScene)
{
    m_Layers.SetName(6, "Furniture");
    m_Layers.SetName(5, "Panels");
    EXPECT_EQ(LayerMask(65 | 16),
              Read("Paint: {layers: [Default, Furniture, Water]}\n").layers.value());
    EXPECT_THAT(ProblemsOf("Paint: {layers: [UI]}\n"), // the scene calls 5 something else
                ElementsAre("1:18: Paint.m_Layers: unknown layer 'UI' (known: Default, Panels, "
                            "Furniture)"));
}

TEST_F(ProfileReference, IsLoadedAnewWithOtherLayersAndAfterAChangeOfWhatItRefersTo)
{
    const auto path = folder / "on.profile.yaml";
    const auto first = folder.assets.LoadProfile(path).profile;
    EXPECT_EQ(first, folder.assets.LoadProfile(path).profile);
    m_Layers.SetName(6, "Furniture");
    EXPECT_NE(first, folder.assets.LoadProfile(path, m_Layers).profile);
    folder.Write("red.material.yaml", "renderQueue: 2000\n");
    const auto old = folder.assets.LoadMaterial(folder / "red.material.yaml");
    folder.Write("red.material.yaml", "renderQueue: 2001\n");
    EXPECT_EQ(old, folder.assets.LoadMaterial(folder / "red.material.yaml"));
    folder.assets.Forget(folder / "red.material.yaml");
    EXPECT_EQ(2001, folder.assets.LoadMaterial(folder / "red.material.yaml")->renderQueue());
}

} // namespace

} // namespace limn::test
