#include "Mentions.h"
#include "Paths.h"
#include "commands/CommandRun.h"
#include "limits/Lowered.h"
#include "vulkan/GpuTestDevice.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

/// A selected cube in the middle, half hidden by another one.
constexpr const char* k_Scene =
    "size: [64, 48]\n"
    "layers: {6: Furniture}\n"
    "renderingLayers: {8: Selected}\n"
    "camera: {position: [0, 0, -4], backgroundColor: \"#000000\"}\n"
    "renderer:\n"
    "  features:\n"
    "    - type: ScreenSpaceOutlineRenderFeature\n"
    "      name: Outline\n"
    "      m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline\n"
    "      m_LayerMask: [Furniture]\n"
    "      m_RenderingLayerMask: Selected\n"
    "materials: {black: {_BaseColor: \"#000000\"}}\n"
    "objects:\n"
    "  - {name: Piece, mesh: cube, material: black, layer: Furniture,\n"
    "     renderingLayerMask: [Default, Selected]}\n"
    "  - {name: Front, mesh: cube, material: black, position: [1, 0, -1]}\n";

class Render : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        folder.Write("s.scene.yaml", k_Scene);
        folder.Write("on.profile.yaml", "ScreenSpaceOutline:\n"
                                        "  m_Enable: true\n"
                                        "  m_OutlineColor: \"#00ff00\"\n"
                                        "  m_OutlineWidth: 4\n");
        folder.Write("off.profile.yaml", "ScreenSpaceOutline: {m_Enable: false}\n");
    }

    std::string Path(const std::string& name) const { return (folder / name).string(); }

    CommandRun Draw(const std::vector<std::string>& more, const std::string& picture = "out.png")
    {
        std::vector<std::string> args{"render", Path("s.scene.yaml"), "--validate", "-o",
                                      Path(picture)};
        args.insert(args.end(), more.begin(), more.end());
        return RunCommand(args);
    }

    /// The command on the device that the tests share, asked for as they ask for it.
    static std::vector<std::string> OnSharedDevice(std::vector<std::string> args)
    {
        if (const char* device = std::getenv("LIMN_TEST_DEVICE"))
        {
            args.insert(args.end(), {"--device", device});
        }
        return args;
    }

    /// How many pixels are greener than a black scene can be.
    int GreenPixels(const std::string& picture) const
    {
        const Image image = ReadPng(folder / picture);
        int count = 0;
        for (std::size_t i = 0; i < image.texels.size(); i += 4)
        {
            count += std::to_integer<int>(image.texels[i + 1]) > 200 ? 1 : 0;
        }
        return count;
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(Render, WritesThePictureAndNamesPathAndSize)
{
    const CommandRun run = Draw({"--profile", "on.profile.yaml"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ(Path("out.png") + " 64x48\n", run.out);
    EXPECT_EQ("", run.err);
    const Image image = ReadPng(folder / "out.png");
    EXPECT_EQ(64, image.width);
    EXPECT_EQ(48, image.height);
    EXPECT_EQ(std::byte{255}, image.texels.at(3)) << "opaque, though the background's alpha is not";
    EXPECT_GT(GreenPixels("out.png"), 40);
}

TEST_F(Render, NamesTheDeviceIfAskedToSayMoreAndNoNotesIfAskedToSayLess)
{
    EXPECT_THAT(Draw(OnSharedDevice({"-v"})).err,
                testing::StartsWith(SharedDevice().ChoiceSentence() + "\nnote: "));
    const CommandRun quiet = Draw({"-q"});
    EXPECT_EQ(Path("out.png") + " 64x48\n", quiet.out);
    EXPECT_EQ("", quiet.err);
}

TEST_F(Render, WritesThePictureToStdoutAndNothingBesides)
{
    ASSERT_EQ(0, Draw({"--profile", "on.profile.yaml"}).exitCode);
    const CommandRun run =
        RunCommand({"render", Path("s.scene.yaml"), "--profile", "on.profile.yaml", "-o", "-"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ(ReadText(folder / "out.png"), run.out);
    EXPECT_EQ("", run.err);
    EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(Render, DrawsASceneThatAsksForNoShader)
{
    folder.Write("s.scene.yaml", "size: [8, 8]\ncamera: {backgroundColor: \"#ff0000\"}\n");
    const CommandRun run = Draw({});
    ASSERT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ(std::byte{255}, ReadPng(folder / "out.png").texels.at(0));
}

TEST_F(Render, RefusesWhatCannotBeDrawnAsBadInput)
{
    folder.Write("cube.shader", "Shader \"C\" { Properties { _T (\"T\", 2D) = \"white\" {} }\n"
                                "SubShader { Pass {\nHLSLPROGRAM\n#pragma vertex V\n"
                                "#pragma fragment F\nTextureCube _T; SamplerState sampler_T;\n"
                                "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                                "float4 F() : SV_Target { return _T.Sample(sampler_T, 1); }\n"
                                "ENDHLSL\n} } }\n");
    folder.Write("s.scene.yaml", "size: [64, 48]\ncamera: {position: [0, 0, -4]}\n"
                                 "materials: {m: {shader: cube.shader, _T: t.png}}\n"
                                 "objects: [{name: A, mesh: cube, material: m}]\n");
    WritePng(folder / "t.png", {1, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(4)});
    const CommandRun run = Draw({});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ("", run.out);
    EXPECT_THAT(run.err, testing::Not(HasSubstr("bug")));
    EXPECT_THAT(run.err, HasSubstr("error: "));
}

// No device has barycentrics for limn, which does not ask for the extension.
TEST_F(Render, ASubShaderThatRequiresWhatTheDeviceLacksIsPassedOver)
{
    const auto subShader = [](const std::string& pragma, const std::string& color)
    {
        return "SubShader { Pass { Cull Off\nHLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n" +
               pragma +
               "\nfloat4 V(float4 p : POSITION) : SV_POSITION { return float4(p.xy, 0.5, 1); }\n"
               "float4 F() : SV_Target { return float4(" +
               color + ", 1); }\nENDHLSL } }\n";
    };
    folder.Write("two.shader", "Shader \"Two\" {\n" +
                                   subShader("#pragma require barycentrics", "1, 0, 0") +
                                   subShader("", "0, 1, 0") + "}");
    folder.Write("s.scene.yaml", "size: [64, 48]\ncamera: {backgroundColor: \"#000000\"}\n"
                                 "materials: {m: {shader: two.shader}}\n"
                                 "objects: [{name: a, mesh: cube, material: m, "
                                 "position: [0, 0, 3]}]\n");
    const CommandRun run = Draw({});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_GT(GreenPixels("out.png"), 40);
}

TEST_F(Render, NotesWhatAShaderUsesThatLimnDoesNotHave)
{
    folder.Write("baked.shader",
                 "Shader \"My/Baked\" { SubShader { Pass { HLSLPROGRAM\n"
                 "#pragma vertex V\n#pragma fragment F\n#include "
                 "\"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl\"\n"
                 "Texture2D _Map;\n"
                 "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                 "float4 F(float4 p : SV_POSITION) : SV_Target\n"
                 "{ return _Map.Load(0) * float4(SampleLightmap(p.xy, p.xyz), 1); }\n"
                 "ENDHLSL } } }");
    folder.Write("s.scene.yaml",
                 "size: [8, 8]\ncamera: {}\nmaterials: {m: {shader: baked.shader}}\n"
                 "objects: [{name: a, mesh: cube, material: m, "
                 "position: [0, 0, 3]}]\n");
    const CommandRun run = Draw({"--frames", "2"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ(
        "note: shader 'My/Baked': it uses light maps, which limn does not have: they are white\n"
        "note: shader 'My/Baked' in pass 'Draw Opaque Objects': texture '_Map' is gray: it "
        "is no property of the shader, "
        "and neither material 'm' nor anything global sets it\n",
        run.err);
}

// URP binds an empty map then, whose texels are as far as can be.
TEST_F(Render, GivesShadersAnEmptyShadowMapWhereNothingThrowsAShadow)
{
    folder.Write(
        "map.shader",
        "Shader \"My/Map\" { SubShader { Pass { HLSLPROGRAM\n"
        "#pragma vertex V\n#pragma fragment F\n#include "
        "\"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "Texture2D _MainLightShadowmapTexture;\n"
        "float4 V(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }"
        "\nfloat4 F() : SV_Target { return float4(0, "
        "_MainLightShadowmapTexture.Load(0).r == UNITY_RAW_FAR_CLIP_VALUE, 0, 1); }\n"
        "ENDHLSL } } }");
    folder.Write("s.scene.yaml",
                 "size: [8, 8]\ncamera: {}\nmaterials: {m: {shader: map.shader}}\n"
                 "objects: [{name: a, mesh: cube, material: m, position: [0, 0, 2]}]\n");
    const CommandRun run = Draw({});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(
                    Mentions("'_MainLightShadowmapTexture'", "far everywhere", "throws a shadow")));
    EXPECT_GT(GreenPixels("out.png"), 4);
}

TEST_F(Render, NotesThatTessellationAddsNoVertices)
{
    folder.Write(
        "fine.shader",
        "Shader \"My/Fine\" { SubShader { Pass { HLSLPROGRAM\n"
        "#pragma vertex V\n#pragma hull H\n#pragma domain D\n#pragma fragment F\n"
        "struct Point { float4 at : INTERNALTESSPOS; };\n"
        "struct Cuts { float edge[3] : SV_TessFactor; float inside : SV_InsideTessFactor; "
        "};\n"
        "Point V(float4 p : POSITION) { Point a; a.at = p; return a; }\n"
        "Cuts C(InputPatch<Point, 3> p) { return (Cuts)1; }\n"
        "[domain(\"tri\")] [partitioning(\"integer\")] [outputcontrolpoints(3)]\n"
        "[outputtopology(\"triangle_cw\")] [patchconstantfunc(\"C\")]\n"
        "Point H(InputPatch<Point, 3> p, uint i : SV_OutputControlPointID) { return p[i]; }\n"
        "[domain(\"tri\")] float4 D(Cuts c, OutputPatch<Point, 3> p, float3 b : "
        "SV_DomainLocation) : SV_POSITION { return p[0].at * b.x + p[1].at * b.y + "
        "p[2].at * b.z; }\n"
        "half4 F() : SV_Target { return 1; }\nENDHLSL } } }");
    folder.Write("s.scene.yaml", "size: [8, 8]\ncamera: {}\nmaterials: {m: {shader: fine.shader}}\n"
                                 "objects: [{name: a, mesh: cube, material: m, "
                                 "position: [0, 0, 3]}]\n");
    const CommandRun run = Draw({});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ(
        "note: shader 'My/Fine': it uses tessellation, which limn does not have: it moves the "
        "mesh's own vertices as the domain function does, and adds none\n",
        run.err);
}

TEST_F(Render, AShaderThatBindsMoreThanTheDeviceIsAnErrorOrIsDrawn)
{
    const auto shaderOf = [](const std::string& declarations, const std::string& sum)
    {
        return "Shader \"S\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex V\n"
               "#pragma fragment F\n" +
               declarations +
               "\nfloat4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
               "float4 F() : SV_Target { return " +
               sum + "; }\nENDHLSL } } }";
    };
    std::string buffers;
    std::string sum = "0";
    for (int i = 0; i < 40; ++i)
    {
        const std::string name = std::to_string(i);
        buffers += "cbuffer B" + name + " { float4 _A" + name + "; };\n";
        sum += " + _A" + name;
    }
    folder.Write("s.scene.yaml", "size: [8, 8]\ncamera: {}\nmaterials: {m: {shader: s.shader}}\n"
                                 "objects: [{name: a, mesh: cube, material: m, "
                                 "position: [0, 0, 3]}]\n");
    const std::pair<std::string, std::vector<std::string>> cases[] = {
        {shaderOf(buffers, sum), {"40 uniform buffers", "at most"}},
        {shaderOf("cbuffer B { float4 _A[70000]; };", "_A[5]"),
         {"s.shader:1:", "constant buffer 'B'", "65536 bytes", "StructuredBuffer"}}};
    for (const auto& [shader, parts] : cases)
    {
        folder.Write("s.shader", shader);
        const CommandRun run = Draw({});
        EXPECT_EQ(run.err.empty() ? 0 : 1, run.exitCode);
        EXPECT_THAT(run.err, testing::AnyOf("", MentionsInOrder(parts)));
    }
}

TEST_F(Render, TheSizeOptionWinsOverTheScene)
{
    const CommandRun run = Draw({"--size", "20x10"});
    EXPECT_EQ(Path("out.png") + " 20x10\n", run.out);
    EXPECT_EQ(20, ReadPng(folder / "out.png").width);
}

TEST_F(Render, RefusesASizeThatIsTooLargeOnceItIsScaled)
{
    folder.Write("s.scene.yaml", std::string("renderScale: 2\n") + k_Scene);
    const CommandRun run = Draw({"--size", "16384x10"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, Mentions("s.scene.yaml:", "renderScale:", "32768x20", "16384x10"));
}

TEST_F(Render, WithoutAVolumeSaysWhyThereIsNoOutline)
{
    const CommandRun run = Draw({});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions("note: Outline:", "not drawn", "no volume",
                                              "ScreenSpaceOutline.m_Enable", "false by default")));
    EXPECT_EQ(0, GreenPixels("out.png"));
}

TEST_F(Render, WithADisabledVolumeComponentSaysSo)
{
    const CommandRun run = Draw({"--profile", "off.profile.yaml"});
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions("note: Outline:", "not drawn", "a volume",
                                              "ScreenSpaceOutline.m_Enable to false")));
    EXPECT_EQ(0, GreenPixels("out.png"));
}

TEST_F(Render, WithAnInactiveFeatureSaysSo)
{
    const CommandRun run = Draw({"--profile", "on.profile.yaml", "--set", "Outline.active=false"});
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions("note: Outline:", "not drawn", "inactive")));
    EXPECT_EQ(0, GreenPixels("out.png"));
}

TEST_F(Render, CountsPerRuleWhenNothingPassesTheFilter)
{
    const CommandRun run =
        Draw({"--profile", "on.profile.yaml", "--set", "Outline.m_RenderingLayerMask=9"});
    EXPECT_THAT(LinesOf(run.err), testing::ElementsAre(Mentions(
                                      "note: Outline:", "0 of 2", "the layer mask leaves out 1",
                                      "rendering layer mask leaves out 1")));
    EXPECT_EQ(0, GreenPixels("out.png"));
}

TEST_F(Render, SaysSoWhereNoPassDrawsAnObject)
{
    folder.Write("other.shader", "Shader \"Other\" { SubShader { Pass {\n"
                                 "Tags { \"LightMode\" = \"OtherPipeline\" }\n"
                                 "HLSLPROGRAM\n#pragma vertex vert\n#pragma fragment frag\n"
                                 "float4 vert() : SV_Position { return 0; }\n"
                                 "float4 frag() : SV_Target { return 1; }\nENDHLSL } } }\n");
    folder.Write("other.scene.yaml", "materials: {other: {shader: other.shader}}\n"
                                     "objects: [{name: Piece, mesh: cube, material: other}]\n"
                                     "camera: {position: [0, 0, -4]}\n");
    const CommandRun run = RunCommand({"render", Path("other.scene.yaml"), "-o", Path("out.png")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.err, Mentions("no pass draws any of the objects", "LightMode", "limn explain"));
    // A shadow is no picture of the object.
    folder.Write("r.asset", "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &11400000\n"
                            "MonoBehaviour:\n  m_Name: R\n"
                            "  m_OpaqueLayerMask:\n    serializedVersion: 2\n    m_Bits: 0\n"
                            "  m_RendererFeatures: []\n");
    folder.Write("masked.scene.yaml",
                 "size: [8, 8]\nlight: {shadows: Hard}\nrenderer: {rendererData: r.asset}\n"
                 "objects: [{name: Piece, mesh: cube}]\ncamera: {position: [0, 0, -4]}\n");
    const CommandRun masked =
        RunCommand({"render", Path("masked.scene.yaml"), "-o", Path("out.png")});
    EXPECT_EQ(masked.exitCode, 0) << masked.err;
    EXPECT_THAT(masked.err, Mentions("no pass draws any of the objects", "layer masks"));
    const CommandRun shadows = RunCommand({"explain", Path("masked.scene.yaml")});
    EXPECT_THAT(shadows.out, HasSubstr("MainLightShadow: 1 of 1 drawn"));
    const CommandRun drawn = Draw({});
    EXPECT_THAT(drawn.err, testing::Not(HasSubstr("no pass draws")));
}

TEST_F(Render, SetChangesAVolumesColour)
{
    const CommandRun run = Draw(
        {"--profile", "on.profile.yaml", "--set", "ScreenSpaceOutline.m_OutlineColor=#ff0000"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ(0, GreenPixels("out.png"));
}

TEST_F(Render, ACachedShaderGivesTheSamePicture)
{
    const std::vector<std::string> cached{"--profile",   "on.profile.yaml", "--cache-dir",
                                          Path("cache"), "--stats",         Path("stats.json")};
    ASSERT_EQ(0, Draw(cached, "cold.png").exitCode);
    const auto cold = nlohmann::json::parse(ReadText(folder / "stats.json"));
    ASSERT_EQ(0, Draw(cached, "warm.png").exitCode);
    const auto warm = nlohmann::json::parse(ReadText(folder / "stats.json"));
    EXPECT_EQ(cold["shaderPasses"]["compiled"], warm["shaderPasses"]["loadedFromCache"]);
    EXPECT_EQ(0, warm["shaderPasses"]["compiled"]);
    EXPECT_EQ(ReadPng(folder / "cold.png"), ReadPng(folder / "warm.png"));
}

TEST_F(Render, StatsTellPassesCountsAndTextures)
{
    ASSERT_EQ(0, Draw({"--profile", "on.profile.yaml", "--stats", Path("stats.json")}).exitCode);
    const auto stats = nlohmann::json::parse(ReadText(folder / "stats.json"));
    EXPECT_EQ(64, stats["width"]);
    EXPECT_EQ(SharedDevice().deviceName(), stats["device"]);
    const auto& passes = stats["passes"];
    const auto outline = std::find_if(passes.begin(), passes.end(),
                                      [](const auto& pass) { return pass["name"] == "Outline"; });
    ASSERT_NE(passes.end(), outline);
    EXPECT_EQ(500, (*outline)["event"]);
    EXPECT_GE((*outline)["gpuMilliseconds"], 0.0) << "mask and edges";
    EXPECT_EQ(nlohmann::json::parse(R"(["Draw Opaque Objects + Outline"])"), (*outline)["partOf"])
        << "its composite";
    EXPECT_EQ("Draw Opaque Objects + Outline", stats["gpuPasses"][2]["name"]);
    const auto& draws = stats["drawRenderers"];
    const auto draw = std::find_if(draws.begin(), draws.end(),
                                   [](const auto& entry) { return entry["pass"] == "Outline"; });
    ASSERT_NE(draws.end(), draw);
    EXPECT_EQ(1, (*draw)["counts"]["drawn"]);
    EXPECT_EQ(1, (*draw)["counts"]["layer mask"]);
    const auto& textures = stats["attachments"];
    const auto mask = std::find_if(textures.begin(), textures.end(),
                                   [](const auto& texture)
                                   { return texture["name"] == "_RendererDrawingTexture"; });
    ASSERT_NE(textures.end(), mask);
    EXPECT_EQ(32, (*mask)["width"]);
    EXPECT_EQ(24, (*mask)["height"]);
    EXPECT_EQ("R8_UNorm", (*mask)["format"]);
    EXPECT_GT(stats["cpuMilliseconds"]["record"], 0.0);
}

TEST_F(Render, StatsTellThePhasesOfTheCpuAndWhatTheLastFrameTakes)
{
    ASSERT_EQ(0, Draw({"--profile", "on.profile.yaml", "--stats", Path("stats.json")}).exitCode);
    const auto stats = nlohmann::json::parse(ReadText(folder / "stats.json"));
    const auto& cpu = stats["cpuMilliseconds"];
    double parts = 0.0;
    for (const char* phase : {"volumes", "cull", "record", "compile", "execute"})
    {
        EXPECT_GT(cpu[phase], 0.0) << phase;
        parts += cpu[phase].get<double>();
    }
    EXPECT_LE(parts, cpu["frame"].get<double>());
    const double device = cpu["waitForSlot"].get<double>() + cpu["prepare"].get<double>() +
                          cpu["recordCommands"].get<double>() + cpu["submit"].get<double>();
    EXPECT_LE(device, cpu["execute"].get<double>());
    EXPECT_GT(cpu["wait"], 0.0);
    const auto& frame = stats["lastFrame"];
    EXPECT_EQ(stats["gpuPasses"].size(), frame["passes"]);
    EXPECT_GE(frame["drawsBeforeInstancing"], frame["draws"]);
    EXPECT_GT(frame["draws"], 3) << "objects, mask, edges, composite";
    EXPECT_GE(frame["bytes"]["texturesDrawnInto"], 64 * 48 * 4);
    EXPECT_GT(frame["bytes"]["uniforms"], 0);
    EXPECT_GE(frame["bytes"]["deviceAllocated"], frame["bytes"]["deviceInUse"]);
}

TEST_F(Render, StatsTellTheAllocationsOfEachPhaseWhereTheProgramCountsThem)
{
    ASSERT_EQ(0, Draw({"--stats", Path("stats.json")}).exitCode);
    EXPECT_TRUE(nlohmann::json::parse(ReadText(folder / "stats.json"))["allocations"].is_null())
        << "this test program does not count";

    const std::string command = "'" + LimnExecutable() + "' render '" + Path("s.scene.yaml") +
                                "' -o - --frames 3 --stats '" + Path("counted.json") + "'";
    ASSERT_FALSE(RunInPipe(command).empty());
    const auto stats = nlohmann::json::parse(ReadText(folder / "counted.json"));
    const auto& all = stats["allocations"];
    const auto& last = stats["lastFrame"]["allocations"];
    if (LimnHasSanitizers())
    {
        EXPECT_TRUE(all.is_null() && last.is_null());
        return;
    }
    EXPECT_GT(all["load"], 100) << "a scene, its shaders";
    EXPECT_FALSE(last.contains("load"));
    EXPECT_GT(last["frame"], 0);
    for (const char* phase : {"cull", "record", "compile", "execute"})
    {
        EXPECT_GE(all[phase], last[phase]) << phase;
        EXPECT_GE(last["frame"], last[phase]) << phase;
    }
}

TEST_F(Render, ATraceHasPhasesAndGpuPasses)
{
    ASSERT_EQ(0, Draw({"--profile", "on.profile.yaml", "--trace", Path("trace.json")}).exitCode);
    const auto trace = nlohmann::json::parse(ReadText(folder / "trace.json"));
    std::vector<std::string> names;
    double submitted = 0.0;
    double gpuEnd = 0.0;
    for (const auto& event : trace["traceEvents"])
    {
        names.push_back(event["name"]);
        EXPECT_TRUE(event["ph"] == "M" || event["dur"] >= 0.0);
        submitted = event["name"] == "submit" ? event["ts"].get<double>() : submitted;
        if (event["ph"] == "X" && event["tid"] == 2)
        {
            EXPECT_GE(event["ts"].get<double>() + 0.01, std::max(submitted, gpuEnd))
                << "passes run one by one";
            gpuEnd = event["ts"].get<double>() + event["dur"].get<double>();
        }
    }
    EXPECT_THAT(names, testing::IsSupersetOf({"load", "compile shaders", "device", "frame", "cull",
                                              "record", "compile", "execute", "record commands",
                                              "submit", "wait", "write", "Outline"}));
}

TEST_F(Render, SeveralFramesGiveThePictureOfTheLast)
{
    ASSERT_EQ(0, Draw({"--frames", "3", "--time", "1"}, "last.png").exitCode);
    ASSERT_EQ(0, Draw({"--time", "1"}, "first.png").exitCode);
    EXPECT_EQ(ReadPng(folder / "first.png"), ReadPng(folder / "last.png"))
        << "nothing in the scene moves";
}

// 1e7 s are a whole number of turns; the next float is 1 s away.
TEST_F(Render, AnObjectTurnsAsSmoothlyAfterMonthsAsAtFirst)
{
    folder.Write("s.scene.yaml", "size: [64, 48]\n"
                                 "camera: {position: [0, 0, -4], backgroundColor: \"#000000\"}\n"
                                 "objects: [{name: a, mesh: cube, turn: [0, 90, 0]}]\n");
    ASSERT_EQ(0, Draw({"--time", "0"}, "begin.png").exitCode);
    ASSERT_EQ(0, Draw({"--time", "0", "--frames", "16"}, "first.png").exitCode);
    ASSERT_EQ(0, Draw({"--time", "1e7", "--frames", "16"}, "later.png").exitCode);
    EXPECT_FALSE(ReadPng(folder / "begin.png") == ReadPng(folder / "first.png"));
    EXPECT_EQ(ReadPng(folder / "first.png"), ReadPng(folder / "later.png"));
}

TEST_F(Render, AnUnwritablePathIsNamedAndNothingIsLeft)
{
    const int before = folder.fileCount();
    const CommandRun run = Draw({}, "no/out.png");
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, Mentions(Path("no/out.png") + ":", "written", "No such file"));
    EXPECT_EQ("", run.out);
    EXPECT_EQ(before, folder.fileCount());
}

TEST_F(Render, RefusesToWriteOverWhatItReads)
{
    std::filesystem::create_symlink("s.scene.yaml", folder / "link.png");
    std::filesystem::create_hard_link(folder / "on.profile.yaml", folder / "name.png");
    for (const auto& [output, input] :
         {std::pair("link.png", "s.scene.yaml"), std::pair("name.png", "on.profile.yaml")})
    {
        const std::string before = ReadText(folder / output);
        const CommandRun run = Draw({"--profile", "on.profile.yaml"}, output);
        EXPECT_EQ(1, run.exitCode);
        EXPECT_THAT(run.err,
                    Mentions(Path(output) + ":", "drawn from " + Path(input), "another name"));
        EXPECT_EQ(before, ReadText(folder / output));
    }
    const CommandRun stats = Draw({"--stats", Path("s.scene.yaml")});
    EXPECT_EQ(1, stats.exitCode);
    EXPECT_EQ(k_Scene, ReadText(folder / "s.scene.yaml"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
}

TEST_F(Render, RefusesToWriteOneFileTwice)
{
    const CommandRun run = Draw({"--stats", Path("o.json"), "--trace", Path("./o.json")});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, Mentions(Path("o.json") + ":", "twice"));
    EXPECT_FALSE(std::filesystem::exists(folder / "o.json"));
    EXPECT_EQ(0, Draw({"--stats", "/dev/null", "--trace", "/dev/null"}).exitCode);
}

TEST_F(Render, WritesThroughALinkAndToADevice)
{
    std::filesystem::create_symlink("real.png", folder / "link.png");
    std::filesystem::create_symlink("/dev/null", folder / "null.png");
    EXPECT_EQ(0, Draw({}, "link.png").exitCode);
    EXPECT_EQ(0, Draw({}, "null.png").exitCode);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "null.png"));
    EXPECT_EQ(64, ReadPng(folder / "real.png").width);
}

TEST_F(Render, AFolderInPlaceOfItsCachedPipelinesDoesNoHarm)
{
    const std::vector<std::string> cached{"--cache-dir", Path("cache")};
    ASSERT_EQ(0, Draw(cached).exitCode);
    int replaced = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "cache"))
    {
        const std::filesystem::path path = entry.path();
        std::filesystem::remove(path);
        std::filesystem::create_directories(path / "full");
        ++replaced;
    }
    EXPECT_GT(replaced, 1) << "passes and pipelines";
    const CommandRun run = Draw(cached);
    EXPECT_EQ(0, run.exitCode) << run.err;
}

TEST_F(Render, AnUnknownDeviceEndsWith3)
{
    const CommandRun run = Draw({"--device", "no such device"});
    EXPECT_EQ(3, run.exitCode);
    EXPECT_THAT(run.err, Mentions("no usable Vulkan device", "'no such device'", "there are"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
}

TEST_F(Render, DoctorNamesTheChosenDevice)
{
    const CommandRun run = RunCommand(OnSharedDevice({"doctor"}));
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(run.out,
                HasSubstr("chosen device       " + SharedDevice().ChoiceSentence() + "\n"));
    EXPECT_THAT(run.out, HasSubstr("validation layer    present\n"));
    EXPECT_EQ("", run.err);
}

TEST_F(Render, DoctorSaysWhatTheDeviceLacksAndWhatThatCosts)
{
    const Lowered lowered("geometryShader=0,maxPerStageDescriptorSamplers=9");
    const CommandRun run = RunCommand(OnSharedDevice({"doctor"}));
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(run.out, HasSubstr("usable; what it lacks, and what that costs:\n"));
    EXPECT_THAT(LinesOf(run.out),
                testing::Contains(Mentions("no geometryShader", "SV_PrimitiveID")));
    EXPECT_THAT(LinesOf(run.out),
                testing::Contains(Mentions("maxPerStageDescriptorSamplers is 9", "9 samplers")));
}

} // namespace limn::test
