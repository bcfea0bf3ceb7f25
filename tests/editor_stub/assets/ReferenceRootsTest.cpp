#include "Mentions.h"
#include "SceneFolder.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/editor_stub/Overrides.h>
#include <limn/volume/AssetParameters.h>
#include <sys/stat.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

/// Matches the refusal of a path, which the value at this place has.
auto Outside(const std::string& place, const std::string& path)
{
    return Mentions(place, "'" + path + "'", "outside", "--root");
}

struct Picture : VolumeComponent
{
    Texture2DParameter ramp{this, "m_Ramp", {}};
};

/// A scene in outer/project; outer has files that are none of its business.
class ReferenceRoots : public testing::Test
{
protected:
    ReferenceRoots()
    {
        std::filesystem::create_directory(outer / "project");
        std::filesystem::create_directories(outer / "unity/Assets/Settings");
        const Image image{1, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(4)};
        outer.Write("secret.yaml", "password: hunter2\n");
        outer.Write("on.profile.yaml", "ScreenSpaceOutline: {m_Enable: true}\n");
        outer.Write("a.shader", "Shader \"A\" { SubShader { Pass { } Pass { } Pass { } } }\n");
        WritePng(outer / "a.png", image);
        WritePng(outer / "unity/Assets/a.png", image);
    }

    std::filesystem::path Scene(const std::string& lines) const
    {
        return outer.Write("project/s.scene.yaml", "camera: {}\n" + lines);
    }

    std::vector<std::string> ProblemsOf(const std::string& lines) const
    {
        AssetContext assets;
        return Problems([&] { LoadScene(Scene(lines), assets); });
    }

    TemporaryFolder outer;
};

} // namespace

TEST_F(ReferenceRoots, AreNotLeftByAnyKindOfReference)
{
    const std::string above = (outer / "").string();
    for (const std::string& folder : {std::string("../"), above})
    {
        EXPECT_THAT(ProblemsOf("volumes: [{profile: '" + folder + "secret.yaml'}]\n"),
                    ElementsAre(Outside("2:21: volumes[0].profile", folder + "secret.yaml")));
        EXPECT_THAT(ProblemsOf("renderer: {rendererData: '" + folder + "r.asset'}\n"),
                    ElementsAre(Outside("2:26: renderer.rendererData", folder + "r.asset")));
        EXPECT_THAT(ProblemsOf("objects: [{name: A, mesh: '" + folder + "a.gltf'}]\n"),
                    ElementsAre(Outside("2:27: object 'A'.mesh", folder + "a.gltf")));
        EXPECT_THAT(ProblemsOf("materials: {m: {shader: '" + folder + "a.shader'}}\n"),
                    ElementsAre(Outside("2:25: material 'm'.shader", folder + "a.shader")));
        EXPECT_THAT(ProblemsOf("materials: {m: {_BaseMap: '" + folder + "a.png'}}\n"),
                    ElementsAre(Outside("2:27: material 'm'._BaseMap", folder + "a.png")));
    }
}

TEST_F(ReferenceRoots, AreNotLeftByALink)
{
    std::filesystem::create_symlink("../secret.yaml", outer / "project/p.profile.yaml");
    std::filesystem::create_symlink("..", outer / "project/up");
    EXPECT_THAT(ProblemsOf("volumes: [{profile: p.profile.yaml}]\n"),
                ElementsAre(Outside("2:21: volumes[0].profile", "p.profile.yaml")));
    EXPECT_THAT(ProblemsOf("volumes: [{profile: up/secret.yaml}]\n"),
                ElementsAre(Outside("2:21: volumes[0].profile", "up/secret.yaml")));
}

TEST_F(ReferenceRoots, AreNotLeftByAMeshsBuffer)
{
    outer.Write("project/a.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{\"uri\": "
                                  "\"../secret.yaml\", \"byteLength\": 18}]}");
    EXPECT_THAT(
        ProblemsOf("objects: [{name: A, mesh: a.gltf}]\n"),
        ElementsAre(HasSubstr("cannot be used"), Mentions("buffer 'secret.yaml'", "outside")));
}

TEST_F(ReferenceRoots, AreWidenedByTheOption)
{
    const std::string scene = Scene("volumes: [{profile: ../on.profile.yaml}]\n").string();
    const CommandRun refused = RunCommand({"explain", scene});
    EXPECT_EQ(1, refused.exitCode);
    EXPECT_THAT(refused.err, Outside("volumes[0].profile", "../on.profile.yaml"));
    for (const char* verb : {"explain", "inspect"})
    {
        const CommandRun run = RunCommand({verb, scene, "--root", (outer / "").string()});
        EXPECT_EQ(0, run.exitCode) << run.err;
    }
    const CommandRun other = RunCommand({"explain", scene, "--root", (outer / "project").string()});
    EXPECT_EQ(1, other.exitCode);
}

TEST_F(ReferenceRoots, AreWholeUnityProjects)
{
    std::filesystem::create_directories(outer / "unity/Assets/Art");
    std::filesystem::create_directories(outer / "unity/limn");
    outer.Write("unity/Assets/Art/on.profile.yaml", "ScreenSpaceOutline: {m_Enable: true}\n");
    const auto scene = outer.Write("unity/limn/s.scene.yaml",
                                   "camera: {}\n"
                                   "volumes: [{profile: ../Assets/Art/on.profile.yaml}]\n");
    AssetContext assets;
    EXPECT_EQ(1u, LoadScene(scene, assets).volumes.size());
}

TEST_F(ReferenceRoots, HoldForBareNames)
{
    Scene("volumes: [{profile: ../on.profile.yaml}, {profile: in.profile.yaml}]\n");
    outer.Write("project/in.profile.yaml", "ScreenSpaceOutline: {m_Enable: true}\n");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(outer / "project");
    AssetContext assets;
    const std::vector<std::string> problems = Problems([&] { LoadScene("s.scene.yaml", assets); });
    std::filesystem::current_path(before);
    EXPECT_THAT(problems, ElementsAre(Outside("2:21: volumes[0].profile", "../on.profile.yaml")));
}

TEST_F(ReferenceRoots, DoNotBindWhatAPersonTypes)
{
    const std::string scene = Scene("volumes: []\n").string();
    AssetContext assets;
    SceneAsset asset = LoadScene(scene, assets);
    EXPECT_NO_THROW(ReplaceProfile(asset, (outer / "on.profile.yaml").string(), assets));
}

TEST_F(ReferenceRoots, AreNotWidenedForTheSceneByWhatAPersonTypes)
{
    outer.Write("unity/Assets/Settings/typed.profile.yaml", "Picture: {ramp: ../a.png}\n");
    const std::string scene = "renderer: {features: [{type: ScreenSpaceOutlineRenderFeature}]}\n";
    AssetContext assets;
    assets.volumeComponents().Register<Picture>("Picture");
    SceneAsset asset = LoadScene(Scene(scene), assets);
    ReplaceProfile(asset, (outer / "unity/Assets/Settings/typed.profile.yaml").string(), assets);
    EXPECT_NE(nullptr, asset.volumes.at(0).sharedProfile->TryGet<Picture>()->ramp.value().asset)
        << "of the typed file's own project";
    const std::string overrides[] = {"ScreenSpaceOutlineRenderFeature.m_ScreenSpaceOutlineShader=" +
                                     (outer / "a.shader").string()};
    ApplyOverrides(asset, overrides, assets);
    for (const char* path : {"unity/Assets/Settings/on.profile.yaml", "on.profile.yaml"})
    {
        const std::string lines = "volumes: [{profile: ../" + std::string(path) + "}]\n";
        EXPECT_THAT(Problems([&] { LoadScene(Scene(lines), assets); }),
                    ElementsAre(Outside("2:21: volumes[0].profile", "../" + std::string(path))));
    }
}

TEST_F(ReferenceRoots, AreNotWidenedByARendererOfUnitys)
{
    outer.Write("unity/Assets/Settings/r.asset",
                "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &11400000\nMonoBehaviour:\n"
                "  m_Name: R\n  m_RendererFeatures: []\n");
    const std::string scene = Scene("renderer: {rendererData: ../unity/Assets/Settings/r.asset}\n"
                                    "volumes: [{profile: ../unity/Assets/on.profile.yaml}]\n")
                                  .string();
    const CommandRun run =
        RunCommand({"explain", scene, "--root", (outer / "unity/Assets/Settings").string()});
    EXPECT_THAT(LinesOf(run.err), ElementsAre(Outside(scene + ":3:21: error: volumes[0].profile",
                                                      "../unity/Assets/on.profile.yaml")));
}

TEST_F(ReferenceRoots, HoldForALinkThatTakesTheProfilesPlace)
{
    const auto profile = outer.Write("project/p.profile.yaml", "ScreenSpaceOutline: {}\n");
    AssetContext assets;
    LoadScene(Scene("volumes: [{profile: p.profile.yaml}]\n"), assets);
    EXPECT_NE(nullptr, assets.ReloadProfile(profile));
    std::filesystem::remove(profile);
    std::filesystem::create_symlink("../on.profile.yaml", profile);
    EXPECT_EQ(nullptr, assets.ReloadProfile(profile));
}

TEST_F(ReferenceRoots, LetNoOtherKindOfFileBeShown)
{
    outer.Write("project/notes.txt", "root:x:0:0\nsecret line\n");
    const std::vector<std::string> profile = ProblemsOf("volumes: [{profile: notes.txt}]\n");
    EXPECT_THAT(profile, ElementsAre(Mentions("2:21: volumes[0].profile", "'notes.txt'",
                                              "no profile", ".profile.yaml", ".asset")));
    EXPECT_THAT(ProblemsOf("renderer: {rendererData: notes.txt}\n"),
                ElementsAre(Mentions("2:26: renderer.rendererData", "'notes.txt'", "no renderer",
                                     ".asset")));
    EXPECT_THAT(ProblemsOf("volumes: [{profile: /etc/shadow}]\n"),
                ElementsAre(HasSubstr("'/etc/shadow' is no profile")));
}

TEST_F(ReferenceRoots, DoNotWaitForAPipe)
{
    for (const char* name : {"p.profile.yaml", "a.gltf", "a.png", "a.shader", "r.asset"})
    {
        ASSERT_EQ(0, mkfifo((outer / ("project/" + std::string(name))).c_str(), 0600));
    }
    const auto isPipe = HasSubstr("is a named pipe; a file is expected");
    EXPECT_THAT(ProblemsOf("volumes: [{profile: p.profile.yaml}]\n"), testing::Contains(isPipe));
    EXPECT_THAT(ProblemsOf("objects: [{name: A, mesh: a.gltf}]\n"), testing::Contains(isPipe));
    EXPECT_THAT(ProblemsOf("materials: {m: {_BaseMap: a.png}}\n"), testing::Contains(isPipe));
    EXPECT_THAT(ProblemsOf("materials: {m: {shader: a.shader}}\n"), testing::Contains(isPipe));
    EXPECT_THAT(ProblemsOf("renderer: {rendererData: r.asset}\n"), testing::Contains(isPipe));
}

TEST_F(ReferenceRoots, DoNotWaitForAPipeAmongUnitysMetaFiles)
{
    std::filesystem::create_directories(outer / "project/Assets");
    ASSERT_EQ(0, mkfifo((outer / "project/Assets/a.shader.meta").c_str(), 0600));
    std::filesystem::create_symlink("/dev/zero", outer / "project/Assets/b.shader.meta");
    outer.Write("project/Assets/p.asset",
                "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &11400000\nMonoBehaviour:\n"
                "  m_Name: R\n  m_RendererFeatures: []\n");
    AssetContext assets;
    EXPECT_NO_THROW(LoadScene(Scene("renderer: {rendererData: Assets/p.asset}\n"), assets));
}

} // namespace limn::test
