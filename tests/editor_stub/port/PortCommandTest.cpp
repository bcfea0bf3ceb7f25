#include "Mentions.h"
#include "port/Ported.h"

#include <cstdlib>
#include <gmock/gmock.h>

// What is written is built by tests/consumer.

namespace limn::test
{

namespace
{

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

/// Expects that the C# has one problem, which mentions these parts.
void ExpectProblem(const std::string& text, const std::vector<std::string>& parts)
{
    const WorkingFolder working;
    working.folder.Write("a.cs", text);
    const CommandRun run = RunCommand({"port", "a.cs", "-o", "out"});
    EXPECT_EQ(1, run.exitCode) << text;
    EXPECT_FALSE(std::filesystem::exists("out")) << text;
    EXPECT_THAT(LinesOf(run.err), testing::ElementsAre(MentionsInOrder(parts))) << text;
}

} // namespace

TEST(PortCommand, CarriesOverABlurOfIdentifiers)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("BlurOld.cs")}, "BlurOld");
    ExpectAll(ported.header,
              {"Low = 1,", "High = 1 << 2,", "Both = Low | High,", "int passes = 2;",
               "float radius = 1.5f;", "quality = BlurOld::Quality::High;",
               "when = RenderPassEvent::AfterRenderingTransparents - 1;",
               "Color tint = Color{1.0f, 0.5f, 0.0f, 1.0f};", "layers = LayerMask::Everything();",
               "Shared<const Shader> shader = {};", "targetName = \"_Blurred\";",
               "inspector.Header(\"Blur\");",
               "Field(\"passes\", passes, {1, 8}, \"How often it is blurred.\");",
               "Field(\"radius\", radius, {.min = 0.5}, \"\");", "Field(\"quality\", quality, k_",
               "// AnimationCurve curve;", "settings.Describe(inspector);",
               "Owned<BlurOld::BlurPass> m_Pass;"});
    EXPECT_THAT(ported.header, Not(HasSubstr("Field(\"frame\""))); // [NonSerialized]
    EXPECT_THAT(ported.header, Not(HasSubstr("Field(\"m_Hidden\"")));
    ExpectAll(
        ported.source,
        {"class BlurOld::BlurPass final : public ScriptableRenderPass",
         "k_Tag = \"Blur \\\"old\\\"\";", "s_Tint = Shader::PropertyToID(\"_Tint\");",
         "tags = {ShaderTagId(\"UniversalForward\"), ShaderTagId(\"SRPDefaultUnlit\")};",
         "const Shared<Material>& material_, int passes_)", "material = material_;",
         "profilingSampler = ProfilingSampler(k_Tag);", "RenderTargetIdentifier source{};",
         "void Setup(const RenderTargetIdentifier& source_)",
         "cmd.GetTemporaryRT(temporary.id, cameraTextureDescriptor.width / downsample, -1, 0, "
         "FilterMode::Bilinear, RenderTextureFormat::ARGB32);",
         "// TODO BlurOld.cs:60: a text with values in it\n        // CommandBuffer cmd",
         "for (int i = 0; i < passes; ++i)", "// cmd.Blit(temporary.Identifier(), source);",
         "void FrameCleanup(CommandBuffer& cmd) override", "cmd.ReleaseTemporaryRT(temporary.id);",
         "Shared<Material> material = CoreUtils::CreateEngineMaterial(settings.shader);",
         "m_Pass->Setup(renderer.cameraColorTarget());", "renderer.EnqueuePass(*m_Pass);"});
    ExpectAll(ported.report,
              {"| event | `BlurPass.renderPassEvent` | `settings.when` | BlurOld.cs:87 | done |",
               "| setting | `BlurSettings.curve` | `AnimationCurve curve` | BlurOld.cs:25 | TODO |",
               "| `CommandBuffer.GetTemporaryRT` | BlurOld.cs:52:21 | same |",
               "| `CommandBuffer.Blit` | BlurOld.cs:64:25, 65:25 | same |",
               "| `CameraData.isSceneViewCamera` | BlurOld.cs:59:46 | differs |",
               "| `Camera.orthographicSize` | BlurOld.cs:60:102 | same |"}); // in a text
}

TEST(PortCommand, NamesWhatItDoesNotKnowWithItsPlace)
{
    const WorkingFolder working;
    const std::string file = Sample("BlurOld.cs");
    const Ported ported = Port({file}, "BlurOld");
    ExpectAll(ported.run.err,
              {file + ":68:21: warning: unknown: 'CommandBuffer.FrobnicateTwice': a member",
               file + ":71:17: warning: unknown: 'Wobble': a name", " 2 unknown; "});
    ExpectAll(ported.report,
              {"| `CommandBuffer.FrobnicateTwice` | BlurOld.cs:68:21 | **unknown** |",
               "| `CommandBuffer.SetRandomWriteTarget` | BlurOld.cs:67:21 | refused |"});
}

TEST(PortCommand, CarriesOverAVolumeComponentAndRTHandles)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("HeightFogFeature.cs")}, "HeightFogFeature");
    ExpectAll(
        ported.header,
        {"ClampedFloatParameter density{this, \"density\", 0.0f, 0.0f, 1.0f, {.tooltip = \"How "
         "thick.\"}};",
         "FloatParameter height{this, \"height\", 10.0f};",
         "ColorParameter color{this, \"color\", Color::grey, true, false, true};",
         "EnumParameter<FogMode> mode{this, \"mode\", FogMode::Exponential, {{\"Linear\", "
         "FogMode::Linear}, {\"Exponential\", FogMode::Exponential}}};",
         "MinIntParameter steps{this, \"steps\", 4, 1, true};",
         "TextureParameter noise{this, \"noise\", {}};",
         "return density.value() > 0.0f && (height.value() != 0.0f || !active);",
         "m_Event = RenderPassEvent::BeforeRenderingPostProcessing;", "m_Strength = .5f;",
         "Field(\"m_Strength\", m_Strength, {0.0, 1.0}, \"\");",
         "std::vector<std::string> m_Tags = {\"UniversalForward\"};",
         "Shared<Material> m_Material{};"});
    ExpectAll(ported.source,
              {"renderPassEvent = renderPassEvent_ + 1;", "strength = strength_ * 2.0f;",
               "profilingSampler = ProfilingSampler(\"HeightFogPass\");",
               "m_FogPass = std::make_unique<HeightFogPass>(m_Event, m_Strength, \"Height Fog\");",
               "// TODO HeightFogFeature.cs:111: limn has nothing of this kind: class "
               "FogVolumeGizmo\n// class FogVolumeGizmo : MonoBehaviour",
               "components.Register<HeightFogPlugin::HeightFog>(\"HeightFog\");"});
    ExpectAll(ported.report,
              {"| condition | `#if UNITY_6000_0_OR_NEWER` | left out | HeightFogFeature.cs:43:1 |",
               "| condition | `#if WITH_FOG && UNITY_2021_2_OR_NEWER` | read |",
               "| `MeshTopology.Quads` | HeightFogFeature.cs:102:80 | same |  |",
               "| setting | `HeightFogFeature.m_Wind` | `Vector3 m_Wind = new Vector3(1, 0, 0)` | "
               "HeightFogFeature.cs:37 | done |"});
    EXPECT_EQ("HeightFog: {}\n", ReadText("out/HeightFog.profile.yaml"));
}

TEST(PortCommand, CarriesOverARenderGraph)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("EdgeGlowFeature.cs")}, "EdgeGlowFeature");
    ExpectAll(ported.header, {"float width{};", "RenderPassEvent injection{};"});
    ExpectAll(ported.source,
              {"struct PassData", "TextureHandle source{};", "RendererListHandle objects{};",
               "void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) "
               "override",
               "m_Pass = std::make_unique<EdgeGlowFeature::EdgeGlowPass>(settings);",
               "m_Pass->renderPassEvent = RenderPassEvent::AfterRenderingOpaques;"});
    EXPECT_THAT(ported.source, Not(HasSubstr("void Execute("))); // limn would run it instead
    ExpectAll(
        ported.report,
        {"| event | `EdgeGlowPass.renderPassEvent` | `RenderPassEvent.AfterRenderingOpaques` |",
         "| graph pass | `EdgeGlowPass.AddRasterRenderPass` | `\"Edge Glow Mask\"` |",
         "| graph pass | `EdgeGlowPass.AddUnsafePass` | `\"Edge Glow\"` |",
         "| `RasterCommandBuffer.DrawRendererList` | EdgeGlowFeature.cs:53:25 | same |",
         "| `UnsafeGraphContext.cmd` |", "| `CommandBufferHelpers.GetNativeCommandBuffer` |"});
    EXPECT_THAT(ported.report, Not(HasSubstr("unknown")));
}

// The C# of the article lies beside the corpus' folder.
TEST(PortCommand, CarriesOverTheArticle)
{
    const char* corpus = std::getenv("LIMN_CORPUS_DIR");
    const std::filesystem::path article =
        std::filesystem::path(corpus ? corpus : "") / ".." / "000_1a6d56bafd10579e.txt";
    if (corpus == nullptr || !std::filesystem::exists(article))
    {
        GTEST_SKIP() << "LIMN_CORPUS_DIR names no folder beside the article";
    }
    const std::string text = ReadText(article);
    const WorkingFolder working;
    std::vector<std::string> files;
    for (std::size_t at = text.find("```c#\n"); at != std::string::npos;
         at = text.find("```c#\n", at + 1))
    {
        const std::size_t end = text.find("\n```", at);
        files.push_back(std::to_string(files.size()) + ".cs");
        working.folder.Write(files.back(), text.substr(at + 6, end - at - 5));
    }
    ASSERT_EQ(3u, files.size());
    const Ported ported = Port(files, "ScreenSpaceOutlineRenderFeature");
    ExpectAll(ported.header,
              {"m_RenderPassEvent = RenderPassEvent::AfterRenderingTransparents;",
               "Field(\"m_ScreenSpaceOutlineShader\",", "Field(\"m_LayerMask\", m_LayerMask",
               "m_RenderQueueRange = ScreenSpaceOutlineSettings::RenderQueueRange::Opaque;",
               "Field(\"m_RenderingLayerMask\", m_RenderingLayerMask, {0, 32}, \"\");",
               "inspector.Header(\"Filtering Settings\");",
               "BoolParameter m_Enable{this, \"m_Enable\", false};",
               "ColorParameter m_OutlineColor{this, \"m_OutlineColor\", Color::white};",
               "m_OutlineWidth{this, \"m_OutlineWidth\", 3.0f, 1.0f, 10.0f};",
               "return m_Enable.value();"});
    ExpectAll(ported.source,
              {"mPass = std::make_unique<OutlineDrawingRenderPass>(name, m_Settings);",
               "renderPassEvent = settings.m_RenderPassEvent;",
               "mProfilingSampler = ProfilingSampler(featureName);",
               "void Setup(const ScreenSpaceOutline& volumeComponent)",
               "kEdgeDetectionPassIndex = 1;", "ShaderTagId(\"UniversalForwardOnly\")",
               // limn has the article's feature
               "(\"ScreenSpaceOutlineRenderFeaturePort\")"});
    EXPECT_THAT(ported.run.err, Not(HasSubstr("unknown")));
    EXPECT_THAT(ported.report, Not(HasSubstr("| missing |")));
    EXPECT_THAT(ported.report, Not(HasSubstr("TODO |")));
}

TEST(PortCommand, ReadsTheFilesOfTheProjectThatDeclareWhatTheFeatureUses)
{
    const WorkingFolder working;
    const auto write = [&](const std::string& path, const std::string& text)
    {
        std::filesystem::create_directories(std::filesystem::path(path).parent_path());
        working.folder.Write(path, text);
    };
    write("ProjectSettings/ProjectSettings.asset", "");
    write("Assets/Glow/GlowFeature.cs",
          "class GlowFeature : ScriptableRendererFeature {\n"
          "  public GlowMode mode; public Lamp lamp; GlowPass m_Pass;\n"
          "  public override void Create() { m_Pass = new GlowPass(); }\n"
          "  public override void AddRenderPasses(ScriptableRenderer renderer,\n"
          "      ref RenderingData data) { renderer.EnqueuePass(m_Pass); } }\n");
    write("Assets/Passes/GlowPass.cs",
          "class GlowPass : DrawingPass<GlowMode> {\n"
          "  static readonly int Tint = UnityEngine.Shader.PropertyToID(\"_Tint\"); }\n");
    write("Assets/Passes/Modes.cs", "enum GlowModes { }\nenum GlowMode { Soft, Hard }\n");
    write("Packages/mine/DrawingPass.cs",
          "class DrawingPass<T> : ScriptableRenderPass { protected T what; }\n");
    // The following files have no place in the port.
    write("Assets/Lamp.cs", "class Lamp : MonoBehaviour { public int watts; }\n");
    write("Assets/Editor/GlowMode.cs", "enum GlowMode { OfTheEditor }\n");
    write("Packages/com.unity.passes/GlowPass.cs", "class GlowPass { int unitys; }\n");
    write("Assets/Broken.cs", "class Broken { class GlowMode {\n");

    const Ported ported = Port({"Assets/Glow/GlowFeature.cs"}, "GlowFeature");
    ExpectAll(ported.run.err, {"note: these files are read, too: "
                               "Assets/Passes/Modes.cs for GlowMode, "
                               "Assets/Passes/GlowPass.cs for GlowPass, "
                               "Packages/mine/DrawingPass.cs for DrawingPass\n",
                               "unknown: 'Lamp': a type"});
    ExpectAll(ported.header, {"Soft,", "GlowMode mode", "Owned<GlowPass> m_Pass;"});
    ExpectAll(ported.source,
              {"class GlowPass final : public ScriptableRenderPass",
               "// TODO GlowPass.cs:1: what 'DrawingPass<GlowMode>' has goes in here, too",
               "Tint = Shader::PropertyToID(\"_Tint\");", "// class DrawingPass<T>",
               "m_Pass = std::make_unique<GlowPass>();"});
    EXPECT_THAT(ported.source + ported.header,
                Not(AnyOf(HasSubstr("watts"), HasSubstr("OfTheEditor"), HasSubstr("unitys"))));
}

TEST(PortCommand, ReadsTheFilesBesideAFeatureThatLiesInNoProject)
{
    const WorkingFolder working;
    working.folder.Write("GlowFeature.cs",
                         "class GlowFeature : ScriptableRendererFeature {\n"
                         "  GlowPass m_Pass;\n"
                         "  public override void Create() { m_Pass = new GlowPass(); } }\n");
    working.folder.Write("GlowPass.cs", "class GlowPass : ScriptableRenderPass { }\n");
    std::filesystem::create_directory("Old");
    working.folder.Write("Old/GlowPass.cs", "class GlowPass { int old; }\n");
    const Ported ported = Port({"GlowFeature.cs"}, "GlowFeature");
    ExpectAll(ported.run.err, {"note: these files are read, too: GlowPass.cs for GlowPass\n"});
    ExpectAll(ported.source, {"class GlowPass final : public ScriptableRenderPass"});
}

TEST(PortCommand, SaysWhatIsWrongWithAFile)
{
    ExpectProblem("using UnityEngine;\n",
                  {"a.cs:", "ScriptableRendererFeature", "no class at all"});
    ExpectProblem("class P : ScriptableRenderPass { class D { } }",
                  {"a.cs:", "ScriptableRendererFeature", "only P, D", "feature's file"});
    ExpectProblem("class A\n  {\n { }\n", {"a.cs:2:3:", "'{'", "never closed"});
    ExpectProblem("class A { } }", {"a.cs:1:13:", "'}'", "closes nothing"});
    ExpectProblem("class A { int)\n}", {"a.cs:1:14:", "')'", "closes nothing", "'{'", "line 1"});
    ExpectProblem("class A {\n s = \"abc\n}", {"a.cs:2:6:", "text", "no end", "'\"'"});
    ExpectProblem("  /* class", {"a.cs:1:3:", "comment", "no end", "'*/'"});
    ExpectProblem("class A { }\n#if X\n", {"a.cs:2:1:", "'#if'", "#endif"});
    ExpectProblem("#if A +\n#endif\n", {"a.cs:1:1:", "'A +'", "no condition", "!, &&, ||"});
    ExpectProblem("Shader \"X\" { }", {"a.cs:1:1:", "a class", "'class Name", "'Shader'"});
    ExpectProblem("class A { public; }", {"a.cs:1:17:", "member of 'A'", "';'"});
    ExpectProblem(std::string("a\nb\0c", 5), {"a.cs:2:2:", "not text", "byte of 0", "C#"});
}

TEST(PortCommand, SaysWhatAFileOfAnotherKindIs)
{
    const WorkingFolder working;
    working.folder.Write("README.md", "It isn't C#.");
    working.folder.Write("Glow.shader", "Shader \"Glow\" { }");
    const CommandRun text = RunCommand({"port", "README.md", "-o", "out"});
    EXPECT_EQ(1, text.exitCode);
    EXPECT_THAT(LinesOf(text.err),
                testing::ElementsAre(Mentions("README.md:", "no C# file", "*.cs")));
    const CommandRun shader = RunCommand({"port", "Glow.shader", "-o", "out"});
    EXPECT_EQ(1, shader.exitCode);
    EXPECT_THAT(shader.err, HasSubstr("'limn shader Glow.shader'"));
    EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST(PortCommand, LeavesAFolderWithFilesAlone)
{
    const WorkingFolder working;
    working.folder.Write("mine.txt", "mine");
    const CommandRun run = RunCommand({"port", Sample("BlurOld.cs"), "-o", "."});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions(".:", "files already", "new folder")));
}

} // namespace limn::test
