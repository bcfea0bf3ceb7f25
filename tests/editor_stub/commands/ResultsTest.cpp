#include "Paths.h"
#include "commands/CommandRun.h"

#include <cstdlib>
#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

/// The exit code of `limn ARGUMENTS` with its output where the shell sends it.
int ExitCodeOf(const std::string& arguments)
{
    const int status = std::system(("'" + LimnExecutable() + "' " + arguments).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

TEST(Results, ThatDoNotGoOutEndWith3)
{
    const TemporaryFolder folder;
    const std::string profile =
        folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_Enable: true}\n").string();
    const std::string shader =
        folder.Write("a.shader", "Shader \"A\" { SubShader { Pass { } } }").string();
    const std::string errors = (folder / "err").string();
    for (const std::string& verb :
         {std::string("schema scene"), "inspect '" + profile + "'",
          "inspect --json '" + profile + "'", "shader --json --parse-only '" + shader + "'",
          std::string("--version"), std::string("render --help")})
    {
        EXPECT_EQ(0, ExitCodeOf(verb + " > /dev/null")) << verb;
        EXPECT_EQ(3, ExitCodeOf(verb + " > /dev/full 2> '" + errors + "'")) << verb;
        EXPECT_EQ("error: the results cannot be written to standard output: its disk is full, or "
                  "nobody reads it\n",
                  ReadText(errors))
            << verb;
    }
}

TEST(RawMessages, AreSentencesWithAPlace)
{
    const TemporaryFolder folder;
    const auto errorOf = [&folder](const std::string& scene)
    {
        const std::string path = folder.Write("s.scene.yaml", scene).string();
        const std::string error = RunCommand({"explain", path}).err;
        return error.substr(std::min(error.size(), path.size()));
    };
    EXPECT_EQ(":1:39: error: camera.lookAt: this is the camera's own position; a point in front of "
              "it is expected\n",
              errorOf("camera: {position: [0, 0, 0], lookAt: [1.0e-30, 0, 0]}\n"));
    EXPECT_EQ(":2:10: error: the key here is longer than 1024 characters, which is the most that "
              "YAML allows\n",
              errorOf("camera: {}\nlayers: {" + std::string(1100, 'a') + ": 3}\n"));
    EXPECT_EQ(":2:10: error: the key here is longer than 1024 characters, which is the most that "
              "YAML allows\n",
              errorOf("camera: {}\nlayers: {'" + std::string(1100, 'a') + "': 3}\n"));
    std::filesystem::create_symlink("circle.scene.yaml", folder / "circle.scene.yaml");
    std::filesystem::create_symlink("circle.shader", folder / "circle.shader");
    const std::string circle = ": error: this is a link that leads back to itself\n";
    EXPECT_EQ((folder / "circle.scene.yaml").string() + circle,
              RunCommand({"explain", (folder / "circle.scene.yaml").string()}).err);
    EXPECT_EQ((folder / "circle.shader").string() + circle,
              RunCommand({"shader", (folder / "circle.shader").string()}).err);
}

TEST(RawMessages, AreNoneForNamesThatAreNotUtf8)
{
    const TemporaryFolder folder;
    folder.Write("a.shader", "Shader \"a\xff\" { SubShader { Pass { Name \"\xfe\"\n"
                             "HLSLPROGRAM\n#pragma vertex v\n#pragma fragment f\n"
                             "float4 v(float4 p : POSITION) : SV_POSITION { return p; }\n"
                             "float4 f() : SV_Target { return 1; }\nENDHLSL\n} } }");
    const std::string scene =
        folder
            .Write("s.scene.yaml", "camera: {position: [0, 0, -3]}\n"
                                   "materials: {m: {shader: a.shader}}\n"
                                   "objects: [{name: A, mesh: cube, material: m}]\n")
            .string();
    const CommandRun run = RunCommand({"explain", "--json", scene});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, testing::HasSubstr("\"a\xef\xbf\xbd\""));
}

// Each of these ended with 70, "this is a bug in limn".
TEST(Input, ThatCannotBeDrawnIsNoBugOfLimns)
{
    const TemporaryFolder folder;
    folder.Write("one.shader", "Shader \"One\" { SubShader { Pass { } } }");
    std::string names = "a";
    for (int i = 1; i < 17; ++i)
    {
        names += ", a";
    }
    const auto feature = [](const std::string& type, const std::string& settings)
    {
        return "renderer: {features: [{type: " + type + ", name: F, " + settings + "}]}\n";
    };
    const std::string outline =
        feature("ScreenSpaceOutlineRenderFeature",
                "m_LayerMask: Everything, m_ScreenSpaceOutlineShader: one.shader");
    const std::string camera = "camera: {position: [0, 0, -4]}\n";
    const std::string ortho = "camera: {orthographic: true, nearClipPlane: -20}\n";
    const std::string range = " is outside [-1000000000, 1000000000]\n";
    const std::pair<std::string, std::string> cases[] = {
        {"camera: {position: [3e38, 0, 0]}\n", ":1:21: error: camera.position[0]: 3e38" + range},
        {"camera: {lookAt: [0, 1e30, 0]}\n", ":1:22: error: camera.lookAt[1]: 1e30" + range},
        {"camera: {backgroundColor: [1e30, 0, 0]}\n",
         ":1:28: error: camera.backgroundColor[0]: 1e30" + range},
        {camera + "ambientLight: {r: 0, g: 0, b: -1e30}\n",
         ":2:31: error: scene.ambientLight.b: -1e30" + range},
        {camera + feature("RenderObjects", "filterSettings: {PassNames: [" + names + "]}"),
         ":2:23: error: renderer.features[0]: F: filterSettings.PassNames has 17 names; at most 16 "
         "are drawn\n"},
        {camera + feature("RenderObjects", "cameraSettings: {offset: [0, 0, 3e38, 0]}"),
         ":2:23: error: renderer.features[0]: F: cameraSettings.offset is more than 1e9 m; no "
         "picture shows objects so far away\n"},
        {camera + outline,
         ":2:23: error: renderer.features[0]: F: m_ScreenSpaceOutlineShader: the shader 'One' has "
         "1 of the three passes for mask, edge and composite; Hidden/ScreenSpaceOutline has "
         "them\n"},
        {ortho + feature("RenderObjects", "passTag: P, cameraSettings: {overrideCamera: true}"),
         "error: P: cameraSettings.overrideCamera: its own camera has perspective, but the scene's "
         "has the nearClipPlane -20; more than 0 is needed\n"}};
    for (const auto& [text, error] : cases)
    {
        const std::string scene = folder.Write("s.scene.yaml", text).string();
        const CommandRun run = RunCommand({"explain", scene});
        EXPECT_EQ(1, run.exitCode) << text;
        EXPECT_EQ((error[0] == ':' ? scene : "") + error, run.err);
    }
}

TEST(Input, OfOnePixelHasAnOutlineAsWell)
{
    const TemporaryFolder folder;
    folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_Enable: true}\n");
    const std::string scene =
        folder
            .Write("s.scene.yaml",
                   "size: [1, 1]\ncamera: {position: [0, 0, -4]}\n"
                   "renderer: {features: [{type: ScreenSpaceOutlineRenderFeature, m_LayerMask: "
                   "Everything, m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline}]}\n"
                   "volumes: [{name: v, profile: p.profile.yaml}]\n")
            .string();
    const CommandRun run = RunCommand({"explain", scene});
    EXPECT_EQ(0, run.exitCode) << run.err;
}

} // namespace limn::test
