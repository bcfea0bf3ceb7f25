#include "Mentions.h"
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
        EXPECT_THAT(LinesOf(ReadText(errors)),
                    testing::ElementsAre(Mentions("results", "standard output", "disk is full")))
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
    EXPECT_THAT(LinesOf(errorOf("camera: {position: [0, 0, 0], lookAt: [1.0e-30, 0, 0]}\n")),
                testing::ElementsAre(Mentions(":1:39:", "camera.lookAt", "own position")));
    EXPECT_THAT(LinesOf(errorOf("camera: {}\nlayers: {" + std::string(1100, 'a') + ": 3}\n")),
                testing::ElementsAre(Mentions(":2:10:", "key", "longer than 1024")));
    EXPECT_THAT(LinesOf(errorOf("camera: {}\nlayers: {'" + std::string(1100, 'a') + "': 3}\n")),
                testing::ElementsAre(Mentions(":2:10:", "key", "longer than 1024")));
    std::filesystem::create_symlink("circle.scene.yaml", folder / "circle.scene.yaml");
    std::filesystem::create_symlink("circle.shader", folder / "circle.shader");
    for (const auto& [verb, name] :
         {std::pair("explain", "circle.scene.yaml"), std::pair("shader", "circle.shader")})
    {
        const std::string path = (folder / name).string();
        EXPECT_THAT(LinesOf(RunCommand({verb, path}).err),
                    testing::ElementsAre(Mentions(path + ":", "link", "itself")));
    }
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
    const std::string range = "[-1000000000, 1000000000]";
    const std::pair<std::string, std::vector<std::string>> cases[] = {
        {"camera: {position: [3e38, 0, 0]}\n",
         {"s.scene.yaml:1:21:", "camera.position[0]", "3e38", "outside", range}},
        {"camera: {lookAt: [0, 1e30, 0]}\n",
         {"s.scene.yaml:1:22:", "camera.lookAt[1]", "1e30", "outside", range}},
        {"camera: {backgroundColor: [1e30, 0, 0]}\n",
         {"s.scene.yaml:1:28:", "camera.backgroundColor[0]", "1e30", "outside", range}},
        {camera + "ambientLight: {r: 0, g: 0, b: -1e30}\n",
         {"s.scene.yaml:2:31:", "scene.ambientLight.b", "-1e30", "outside", range}},
        {camera + feature("RenderObjects", "filterSettings: {PassNames: [" + names + "]}"),
         {"s.scene.yaml:2:23:", "renderer.features[0]", "filterSettings.PassNames", "17", "16"}},
        {camera + feature("RenderObjects", "cameraSettings: {offset: [0, 0, 3e38, 0]}"),
         {"s.scene.yaml:2:23:", "renderer.features[0]", "cameraSettings.offset", "1e9 m"}},
        {camera + outline,
         {"s.scene.yaml:2:23:", "renderer.features[0]", "m_ScreenSpaceOutlineShader", "'One'",
          "1 of the three", "Hidden/ScreenSpaceOutline"}},
        {ortho + feature("RenderObjects", "passTag: P, cameraSettings: {overrideCamera: true}"),
         {"P:", "cameraSettings.overrideCamera", "perspective", "nearClipPlane -20",
          "more than 0"}}};
    for (const auto& [text, parts] : cases)
    {
        const std::string scene = folder.Write("s.scene.yaml", text).string();
        const CommandRun run = RunCommand({"explain", scene});
        EXPECT_EQ(1, run.exitCode) << text;
        EXPECT_THAT(LinesOf(run.err), testing::ElementsAre(MentionsInOrder(parts)));
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
