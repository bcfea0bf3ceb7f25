#include "port/Ported.h"

#include <cstdlib>
#include <gmock/gmock.h>

// What is written is built by tests/consumer.

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using testing::Not;

/// What is wrong with the C#, as it is printed.
std::string ProblemOf(const std::string& text)
{
    const WorkingFolder working;
    working.folder.Write("a.cs", text);
    const CommandRun run = RunCommand({"port", "a.cs", "-o", "out"});
    EXPECT_EQ(1, run.exitCode) << text;
    EXPECT_FALSE(std::filesystem::exists("out")) << text;
    return run.err;
}

} // namespace

TEST(PortCommand, CarriesOverABlurOfIdentifiers)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("BlurOld.cs")}, "BlurOld");
    ExpectAll(ported.header,
              {"Low = 1,", "High = 1 << 2,", "Both = Low | High,", "int passes = 2;",
               "float radius = 1.5f;", "quality = BlurOld::Quality::High;",
               "when = (RenderPassEvent::AfterRenderingTransparents - 1);",
               "Color tint = Color{1.0f, 0.5f, 0.0f, 1.0f};", "layers = LayerMask::Everything();",
               "std::shared_ptr<const Shader> shader = {};", "targetName = \"_Blurred\";",
               "inspector.Header(\"Blur\");",
               "Field(\"passes\", passes, {1, 8}, \"How often it is blurred.\");",
               "Field(\"radius\", radius, {.min = 0.5}, \"\");", "Field(\"quality\", quality, k_",
               "// AnimationCurve curve;", "settings.Describe(inspector);",
               "std::unique_ptr<BlurOld::BlurPass> m_Pass;"});
    EXPECT_THAT(ported.header, Not(HasSubstr("Field(\"frame\""))); // [NonSerialized]
    EXPECT_THAT(ported.header, Not(HasSubstr("Field(\"m_Hidden\"")));
    ExpectAll(ported.source,
              {"class BlurOld::BlurPass final : public ScriptableRenderPass",
               "k_Tag = \"Blur \\\"old\\\"\";", "s_Tint = Shader::PropertyToID(\"_Tint\");",
               "tags = {ShaderTagId(\"UniversalForward\"), ShaderTagId(\"SRPDefaultUnlit\")};",
               "const std::shared_ptr<Material>& material_, [[maybe_unused]] int passes_)",
               "material = material_;", "profilingSampler = ProfilingSampler(k_Tag);",
               "RenderTargetIdentifier source{};",
               "void Setup([[maybe_unused]] const RenderTargetIdentifier& source_)",
               "//     cmd.Blit(temporary.Identifier(), source);",
               "void FrameCleanup([[maybe_unused]] CommandBuffer& cmd) override",
               "// TODO: make 'm_Pass', which is nothing so far",
               "renderer.EnqueuePass(*m_Pass);"});
    ExpectAll(ported.report,
              {"| event | `BlurPass.renderPassEvent` | `settings.when` | BlurOld.cs:87 | TODO |",
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
              {file +
                   ":68:21: warning: unknown: 'CommandBuffer.FrobnicateTwice': a member that the "
                   "table does not have\n",
               file + ":71:17: warning: unknown: 'Wobble': a name that neither the files nor the "
                      "table have\n",
               " 2 unknown; "});
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
         "// TextureParameter noise = new TextureParameter(null);",
         "return ((density.value() > 0.0f) && ((height.value() != 0.0f) || !active));",
         "m_Event = RenderPassEvent::BeforeRenderingPostProcessing;", "m_Strength = .5f;",
         "Field(\"m_Strength\", m_Strength, {0.0, 1.0}, \"\");",
         "std::vector<std::string> m_Tags = {\"UniversalForward\"};",
         "std::shared_ptr<Material> m_Material{};"});
    ExpectAll(ported.source,
              {"renderPassEvent = (renderPassEvent_ + 1);", "strength = (strength_ * 2.0f);",
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
               "HeightFogFeature.cs:37 | TODO |"});
    EXPECT_EQ("HeightFog: {}\n", ReadText("out/HeightFog.profile.yaml"));
}

TEST(PortCommand, CarriesOverARenderGraph)
{
    const WorkingFolder working;
    const Ported ported = Port({Sample("EdgeGlowFeature.cs")}, "EdgeGlowFeature");
    ExpectAll(ported.header, {"float width{};", "RenderPassEvent injection{};"});
    ExpectAll(ported.source,
              {"struct PassData", "TextureHandle source{};", "RendererListHandle objects{};",
               "void RecordRenderGraph([[maybe_unused]] RenderGraph& renderGraph, [[maybe_unused]] "
               "ContextContainer& frameData) override",
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
               "void Setup([[maybe_unused]] const ScreenSpaceOutline& volumeComponent)",
               "kEdgeDetectionPassIndex = 1;", "ShaderTagId(\"UniversalForwardOnly\")",
               // limn has the article's feature
               "(\"ScreenSpaceOutlineRenderFeaturePort\")"});
    EXPECT_THAT(ported.run.err, Not(HasSubstr("unknown")));
    EXPECT_THAT(ported.report, Not(HasSubstr("| missing |")));
    EXPECT_THAT(ported.report, Not(HasSubstr("TODO |")));
}

TEST(PortCommand, SaysWhatIsWrongWithAFile)
{
    EXPECT_EQ("a.cs: error: no class derives from ScriptableRendererFeature; there is no class at "
              "all\n",
              ProblemOf("using UnityEngine;\n"));
    EXPECT_EQ("a.cs: error: no class derives from ScriptableRendererFeature; there are only P, D: "
              "name the feature's file, too\n",
              ProblemOf("class P : ScriptableRenderPass { class D { } }"));
    EXPECT_EQ("a.cs:2:3: error: '{' is never closed\n", ProblemOf("class A\n  {\n { }\n"));
    EXPECT_EQ("a.cs:1:13: error: '}' closes nothing\n", ProblemOf("class A { } }"));
    EXPECT_EQ("a.cs:1:14: error: ')' closes nothing; '{' of line 1 is still open\n",
              ProblemOf("class A { int)\n}"));
    EXPECT_EQ("a.cs:2:6: error: this text has no end; '\"' is expected\n",
              ProblemOf("class A {\n s = \"abc\n}"));
    EXPECT_EQ("a.cs:1:3: error: this comment has no end; '*/' is expected\n",
              ProblemOf("  /* class"));
    EXPECT_EQ("a.cs:2:1: error: '#if' has no #endif\n", ProblemOf("class A { }\n#if X\n"));
    EXPECT_EQ("a.cs:1:1: error: 'A +' is no condition; symbols with !, &&, || and () are "
              "expected\n",
              ProblemOf("#if A +\n#endif\n"));
    EXPECT_EQ("a.cs:1:1: error: a class is expected here: 'class Name : ScriptableRendererFeature "
              "{ ... }', not 'Shader'\n",
              ProblemOf("Shader \"X\" { }"));
    EXPECT_EQ("a.cs:1:17: error: a member of 'A' is expected here, not ';'\n",
              ProblemOf("class A { public; }"));
    EXPECT_EQ("a.cs:2:2: error: the file is not text: here is a byte of 0; a C# file is expected\n",
              ProblemOf(std::string("a\nb\0c", 5)));
}

TEST(PortCommand, SaysWhatAFileOfAnotherKindIs)
{
    const WorkingFolder working;
    working.folder.Write("README.md", "It isn't C#.");
    working.folder.Write("Glow.shader", "Shader \"Glow\" { }");
    const CommandRun text = RunCommand({"port", "README.md", "-o", "out"});
    EXPECT_EQ(1, text.exitCode);
    EXPECT_EQ("README.md: error: 'port' cannot take it: this is no C# file; a *.cs file is "
              "expected\n",
              text.err);
    const CommandRun shader = RunCommand({"port", "Glow.shader", "-o", "out"});
    EXPECT_EQ(1, shader.exitCode);
    EXPECT_THAT(shader.err, HasSubstr("this is a shader; 'limn shader Glow.shader'"));
    EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST(PortCommand, LeavesAFolderWithFilesAlone)
{
    const WorkingFolder working;
    working.folder.Write("mine.txt", "mine");
    const CommandRun run = RunCommand({"port", Sample("BlurOld.cs"), "-o", "."});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ(".: error: the folder holds files already, and limn does not overwrite them; name a "
              "new folder\n",
              run.err);
}

} // namespace limn::test
