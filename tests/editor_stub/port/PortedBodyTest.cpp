#include "port/Ported.h"

#include <gmock/gmock.h>

// These tests show the C++ that `limn port` makes of statements. The tests of port_corpus and
// porting show that it compiles, and that it draws what a port by hand draws.

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using testing::Not;

/// A pass with these members and statements of its Execute, which has `cmd` and `data`.
Ported PortBody(const std::string& statements, const std::string& members = "",
                const std::string& ofFeature = "")
{
    const WorkingFolder working;
    working.folder.Write(
        "F.cs", "public class F : ScriptableRendererFeature {\n"
                "  public enum Mode { Off, On }\n"
                "  public class Settings { public Mode mode; public Material material;\n"
                "    public int count = 2; public float width = 1f; public Color color; }\n"
                "  public Settings settings = new Settings(); P pass;\n" +
                    ofFeature +
                    "  public override void Create() { pass = new P(settings); }\n"
                    "  public override void AddRenderPasses(ScriptableRenderer renderer, ref "
                    "RenderingData data) { renderer.EnqueuePass(pass); }\n"
                    "  class P : ScriptableRenderPass {\n"
                    "    Settings settings; Material material; RTHandle handle; int count; float "
                    "width; int[] sizes;\n" +
                    members +
                    "    public P(Settings settings) { this.settings = settings; }\n"
                    "    public override void Execute(ScriptableRenderContext context, ref "
                    "RenderingData data) {\n"
                    "      CommandBuffer cmd = CommandBufferPool.Get();\n" +
                    statements + "\n    }\n  }\n}\n");
    return Port({"F.cs"}, "F");
}

/// A statement of C# and the C++ that it becomes.
struct Line
{
    const char* csharp;
    const char* cpp;
};

void ExpectLines(const std::vector<Line>& lines, const std::string& members = "")
{
    std::string statements;
    for (const Line& line : lines)
    {
        statements += std::string("      ") + line.csharp + "\n";
    }
    const Ported ported = PortBody(statements, members);
    for (const Line& line : lines)
    {
        EXPECT_THAT(ported.source, HasSubstr(line.cpp)) << line.csharp;
    }
    EXPECT_THAT(ported.source, Not(HasSubstr("TODO")));
}

} // namespace

TEST(PortedBody, HasTheValuesOfCSharp)
{
    ExpectLines({{"float a = count;", "float a = static_cast<float>(count);"},
                 {"float b = 1;", "float b = 1.0f;"},
                 {"int c = (int)width;", "int c = static_cast<int>(width);"},
                 {"var d = count / 2 * (count + 1);", "auto d = count / 2 * (count + 1);"},
                 {"var e = (count - 1) - (count - 2);", "auto e = count - 1 - (count - 2);"},
                 {"var f = count > 1 && width < 2f || material;",
                  "auto f = (count > 1 && width < 2.0f) || material;"},
                 {"var g = !(count == 1);", "auto g = !(count == 1);"},
                 {"var h = count > 0 ? width : 1;", "auto h = count > 0 ? width : 1.0f;"},
                 {"var i = 1 << count;", "auto i = 1 << count;"},
                 {"var j = \"_Level\" + count;",
                  "auto j = std::string(\"_Level\") + std::to_string(count);"},
                 {"var k = $\"Blur {count} of {sizes.Length}\";",
                  "std::string(\"Blur \") + std::to_string(count) + std::string(\" of \") + "
                  "std::to_string(static_cast<int>(sizes.size()))"},
                 {"var l = width % 2f;", "auto l = std::fmod(width, 2.0f);"},
                 {"width %= 3;", "width = std::fmod(width, 3.0f);"},
                 {"Vector4 m = new Vector3(1, width, 0) * count;",
                  "Vector4 m = Vector4(Vector3(1.0f, width, 0.0f) * "
                  "static_cast<float>(count), 0.0f);"},
                 {"var n = sizes[count];", "auto n = sizes.at(static_cast<std::size_t>(count));"},
                 {"var o = GetType().Name;", "auto o = std::string(\"P\");"},
                 {"var p = (SortingCriteria)6;", "static_cast<SortingCriteria>(6);"},
                 {"float r = Mathf.Max(0, width);", "float r = Mathf::Max(0.0f, width);"},
                 {"LayerMask q = count;", "LayerMask(static_cast<std::uint32_t>(count));"}});
}

TEST(PortedBody, TellsWhatIsNull)
{
    ExpectLines(
        {{"if (material == null) return;", "if (material == nullptr)"},
         {"if (handle != null) return;", "if (handle != nullptr)"},
         {"if (settings is null) return;", "if (settings == nullptr)"},
         {"if (settings.material is not null) return;", "if (settings->material != nullptr)"},
         {"material = null;", "material = {};"},
         {"handle?.Release();", "        handle.Release();"},
         {"other?.Hide();", "if (other)\n        {\n            other->Hide();"},
         {"settings = null;", "settings = nullptr;"}},
        "    class Shown { public bool on; public void Hide() { on = false; } }\n"
        "    Shown other;\n");
}

TEST(PortedBody, HasTheStatementsOfCSharp)
{
    ExpectLines({{"for (int i = 0; i < count; i++) width += i;",
                  "for (int i = 0; i < count; ++i)\n        {\n            width += "
                  "static_cast<float>(i);"},
                 {"foreach (var size in sizes) { count += size; if (count > 9) break; }",
                  "for (auto& size : sizes)"},
                 {"while (count > 3) { count >>= 1; count--; }",
                  "            count >>= 1;\n            --count;"},
                 {"switch (settings.mode) { case Mode.On: count = 1; break; default: return; }",
                  "switch (settings->mode)\n        {\n            case F::Mode::On:"},
                 {"// A comment stays.\n count *= 2;", "// A comment stays.\n        count *= 2;"},
                 {"using (new ProfilingScope(cmd, profilingSampler)) { cmd.Clear(); }",
                  "const ProfilingScope profilingScope{*cmd, profilingSampler};\n"
                  "            cmd->Clear();"},
                 {"int x = 1, y = 2; count = x + y;", "        int y = 2;"},
                 {"if (count == 1) count = 2; else if (count == 2) count = 3; else count = 4;",
                  "        else\n        {\n            if (count == 2)"}});
}

TEST(PortedBody, CallsWhatUnityCalls)
{
    ExpectLines(
        {{"var camera = data.cameraData.camera;", "auto camera = data.cameraData.camera;"},
         {"float far = camera.farClipPlane;", "float far = camera->farClipPlane;"},
         {"RenderTextureDescriptor desc = data.cameraData.cameraTargetDescriptor;",
          "RenderTextureDescriptor desc = data.cameraData.cameraTargetDescriptor;"},
         {"desc.colorFormat = RenderTextureFormat.R8;",
          "desc.SetColorFormat(RenderTextureFormat::R8);"},
         {"RenderingUtils.ReAllocateIfNeeded(ref handle, desc, name: \"_A\", wrapMode: "
          "TextureWrapMode.Clamp);",
          "ReAllocateIfNeeded(handle, desc, {.wrapMode = TextureWrapMode::Clamp, .name = "
          "\"_A\"});"},
         {"Blitter.BlitCameraTexture(cmd, handle, handle, material, 0);",
          "Blitter::BlitCameraTexture(*cmd, handle, handle, material, 0);"},
         {"material.SetMatrix(\"_V\", camera.worldToCameraMatrix.inverse);",
          "material->SetMatrix(\"_V\", glm::mat4(glm::inverse(camera->worldToCameraMatrix())));"},
         {"cmd.SetGlobalVector(s_Size, new Vector4(desc.width, desc.height));",
          "cmd->SetGlobalVector(s_Size, Vector4(static_cast<float>(desc.width), "
          "static_cast<float>(desc.height), 0.0f, 0.0f));"},
         {"int made = Shader.PropertyToID(\"_Made\"); cmd.GetTemporaryRT(made, desc);",
          "auto made = Shader::PropertyToID(\"_Made\");"},
         {"var state = new RenderStateBlock(RenderStateMask.Stencil) { stencilReference = 2 };",
          "        state.stencilReference = 2;"},
         {"context.ExecuteCommandBuffer(cmd);", "context.ExecuteCommandBuffer(*cmd);"},
         {"CommandBufferPool.Release(cmd);", "CommandBufferPool::Release(cmd);"}},
        "    static readonly int s_Size = Shader.PropertyToID(\"_Size\");\n");
}

TEST(PortedBody, LeavesALineThatIsNotKnownWithTheReason)
{
    const Ported ported = PortBody("      var screen = Camera.main;\n"
                                   "      cmd.Shout(screen);\n"
                                   "      count = 4;\n"
                                   "      if (Application.isMobilePlatform) { count = 5; }\n");
    ExpectAll(ported.source,
              {"// TODO F.cs:13: limn has no 'Camera.main'", "// var screen = Camera.main;",
               "// TODO F.cs:14: 'CommandBuffer.Shout' is not known", "        count = 4;\n",
               "// if (Application.isMobilePlatform) { count = 5; }"});
    EXPECT_THAT(ported.source, Not(HasSubstr("        count = 5;")));
    EXPECT_THAT(ported.source,
                HasSubstr("void F::Create()\n{\n    // Delete this line with the last TODO.\n"
                          "    Debug::LogWarning(\"F: the port still has 3 TODOs, so its picture "
                          "may lack something\");"));
}

TEST(PortedBody, LeavesStatementsThatItDoesNotKnowAsAWhole)
{
    const Ported ported = PortBody("      do { count = 1; } while (count > 2);\n"
                                   "      try { count = 3; } catch (Exception e) { count = 4; } "
                                   "finally { count = 5; }\n"
                                   "      count = 6;\n"
                                   "      throw;\n");
    ExpectAll(ported.source, {"// do { count = 1; } while (count > 2);", "finally { count = 5; }",
                              "        count = 6;\n", "// throw;"});
    EXPECT_THAT(ported.source, Not(HasSubstr("        while (")));
    EXPECT_THAT(ported.source, Not(HasSubstr("        count = 5;")));
}

TEST(PortedBody, EndsWhereStatementsAreBrokenOrNested)
{
    std::string nested;
    for (int i = 0; i < 5000; ++i)
    {
        nested += "if (count == 1) ";
    }
    const Ported ported = PortBody("      " + nested + "count = 2;\n      return");
    EXPECT_THAT(ported.source, HasSubstr("statements in statements, too many of them"));
    for (const char* broken : {"if", "for", "switch (count)", "using", "using var a", "foreach (",
                               "return count", "var b = new {", "int c =", "a ? b :", "$\"{\"",
                               "x.SetRenderFunc(", "do", "else", "try", "case 1:", "while ()"})
    {
        const WorkingFolder working;
        working.folder.Write("F.cs", std::string("class F : ScriptableRendererFeature { public "
                                                 "override void Create() { ") +
                                         broken + " } }");
        const CommandRun run = RunCommand({"port", "F.cs", "-o", "out"});
        if (run.exitCode == 0)
        {
            EXPECT_THAT(ReadText("out/F.cpp"), HasSubstr("void F::Create()\n{\n")) << broken;
        }
        else
        {
            EXPECT_THAT(run.err, HasSubstr("F.cs:1:")) << broken;
        }
    }
}

TEST(PortedBody, UsesNoPassThatItCannotMake)
{
    const WorkingFolder working;
    working.folder.Write(
        "F.cs", "public class F : ScriptableRendererFeature {\n"
                "  P pass; P second;\n"
                "  public override void Create() { pass = new P(new Unknown()); second = new P(); "
                "}\n"
                "  public override void AddRenderPasses(ScriptableRenderer renderer, ref "
                "RenderingData data) { pass.Setup(2); renderer.EnqueuePass(pass); "
                "renderer.EnqueuePass(second); }\n"
                "  class P : ScriptableRenderPass { public P() { } public P(Unknown what) { }\n"
                "    public void Setup(int count) { }\n"
                "    public override void Execute(ScriptableRenderContext context, ref "
                "RenderingData data) { } }\n"
                "}\n");
    const Ported ported = Port({"F.cs"}, "F");
    ExpectAll(ported.source,
              {"// pass = new P(new Unknown());", "// pass.Setup(2);",
               "Debug::LogWarning(\"F: 'pass' is not drawn; the C++ does not make it\");",
               "second = std::make_unique<F::P>();", "renderer.EnqueuePass(*second);"});
    EXPECT_THAT(ported.source, Not(HasSubstr("EnqueuePass(*pass)")));
}

TEST(PortedBody, MakesAPassThatIsThereFromTheBeginning)
{
    const Ported ported =
        PortBody("", "",
                 "  Q early = new Q();\n  class Q : ScriptableRenderPass {\n"
                 "    public override void Execute(ScriptableRenderContext context, ref "
                 "RenderingData data) { } }\n");
    ExpectAll(ported.source, {"F::F()\n{\n    early = std::make_unique<F::Q>();\n}"});
}

TEST(PortedBody, CopiesADescriptorThatItChanges)
{
    const Ported ported =
        PortBody("", "    public override void Configure(CommandBuffer cmd, "
                     "RenderTextureDescriptor desc) { desc.width = 2; Use(sizes); }\n"
                     "    void Use(int[] list) { list[0] = 1; }\n");
    ExpectAll(ported.source, {"const RenderTextureDescriptor& descGiven) override",
                              "RenderTextureDescriptor desc = descGiven;\n        desc.width = 2;",
                              "void Use(std::vector<int>& list)"});
}

TEST(PortedBody, WritesWhatOtherFeaturesBeginWith)
{
    ExpectLines(
        {{"if (Application.isPlaying && mask != 0) { }",
          "if (true && mask != LayerMask::Nothing())"},
         {"cmd.SetViewport(data.cameraData.camera.pixelRect);",
          "cmd->SetViewport(ViewportRect{0, 0, Screen::width(), Screen::height()});"},
         {"width = data.cameraData.camera.pixelRect.width;",
          "width = static_cast<float>(ViewportRect{0, 0, Screen::width(), "
          "Screen::height()}.width);"},
         {"count <<= 1;", "count <<= 1;"},
         {"for (; count > 1; count >>= 1) { width += 1f; }", "for (; count > 1; count >>= 1)"},
         {"cmd.SetGlobalDepthBias(1, 0);", "cmd->SetGlobalDepthBias(1, 0);"},
         {"(front, back) = (back, front);", "std::swap(front, back);"},
         {"Wanted = count;", "SetWanted(count);"},
         {"this.Wanted = 3;", "SetWanted(3);"},
         {"other.Wanted = 4;", "other.SetWanted(4);"},
         {"count = Wanted + Twice;", "count = Wanted() + Twice();"},
         {"if (string.IsNullOrEmpty(title)) throw new System.ArgumentException(\"no title\");",
          "throw ContractError(\"no title\");"},
         {"using (new ProfilingSample(cmd, \"Old\")) { count = 5; }",
          "const ProfilingScope profilingScope{*cmd, ProfilingSampler(\"Old\")};"}},
        "    LayerMask mask; RTHandle front, back; string title;\n"
        "    struct Other { int wanted; public int Wanted { get => wanted; set => wanted = value; "
        "} "
        "}\n    Other other;\n"
        "    int wanted; int Wanted { get { return wanted; } private set { wanted = value; } }\n"
        "    int Twice { get { return 2 * wanted; } }\n");
}

TEST(PortedBody, TellsASettingFromTheTypeOfItsNameWhereItBegins)
{
    const Ported ported = PortBody(
        "", "", "  public RenderPassEvent RenderPassEvent = RenderPassEvent.AfterRendering;\n");
    ExpectAll(ported.header,
              {"RenderPassEvent RenderPassEvent_ = RenderPassEvent::AfterRendering"});
}

TEST(PortedBody, FollowsThePropertyIdsThatCSharpKeepsInInts)
{
    ExpectLines({{"int[] levels = new int[4];", "std::vector<ShaderPropertyId>(4);"},
                 {"levels[0] = Shader.PropertyToID(\"_Level\");",
                  "levels.at(0) = Shader::PropertyToID(\"_Level\");"},
                 {"cmd.ReleaseTemporaryRT(levels[0]);", "cmd->ReleaseTemporaryRT(levels.at(0));"},
                 {"Ids.Levels[1] = NameOf(\"_L\");", "F::P::Ids::Levels.at(1) = NameOf(\"_L\");"},
                 {"Data passed = new Data();", "F::P::Data passed"},
                 {"passed.target = Ids.Main;", "passed.target = F::P::Ids::Main;"},
                 {"cmd.SetGlobalTexture(passed.target, handle);",
                  "cmd->SetGlobalTexture(passed.target, handle);"},
                 {"int kernel = passed.kernel;", "int kernel = passed.kernel;"}},
                "    static class Ids { public static int Main = Shader.PropertyToID(\"_Main\");\n"
                "      public static int[] Levels = new int[2]; }\n"
                "    class Data { public int target; public int kernel; }\n"
                "    int NameOf(string name) { return Shader.PropertyToID(name); }\n");
}

TEST(PortedBody, TellsAMemberFromTheTypeOfItsName)
{
    ExpectLines({{"Material.SetFloat(\"_A\", 1f);", "Material_->SetFloat(\"_A\", 1.0f);"},
                 {"FilterMode = FilterMode.Point;", "FilterMode_ = FilterMode::Point;"}},
                "    Material Material; FilterMode FilterMode;\n");
}

TEST(PortedBody, HasTheNewerOperatorsOfCSharp)
{
    ExpectLines(
        {{"material ?\?= settings.material;",
          "if (material == nullptr)\n        {\n            material = settings->material;"},
         {"var a = material ?? settings.material;",
          "Shared<Material> a = material ? material : settings->material;"},
         {"var b = material?.shader;",
          "Shared<const Shader> b = material ? material->shader() : nullptr;"},
         {"Mode c = Mode.On | Mode.Off;",
          "F::Mode c = static_cast<F::Mode>(static_cast<int>(F::Mode::On) | "
          "static_cast<int>(F::Mode::Off));"},
         {"bool d = (c & Mode.On) != 0;", "!= 0;"},
         {"bool e = (data.cameraData.cameraType & CameraType.Game) == 0;",
          "static_cast<int>(data.cameraData.cameraType & CameraType::Game) == 0"},
         {"uint f = (uint)1 << count;", "static_cast<std::uint32_t>(1) << count"},
         {"context.Submit(); count = 1;", "count = 1;"}});
}

TEST(PortedBody, GivesParametersTheirDefaults)
{
    const Ported ported =
        PortBody("      width = Far(2f);\n",
                 "    float Far(float a, float b = 0.5f, int c = 3) => a * b * c;\n");
    EXPECT_THAT(ported.source, HasSubstr("width = Far(2.0f, 0.5f, 3);"));
}

TEST(PortedBody, LeavesOutTheHalfThatOnlyTheCompatibilityModeRuns)
{
    const Ported ported = PortBody("      unknown.Call();\n",
                                   "    public override void RecordRenderGraph(RenderGraph graph, "
                                   "ContextContainer data) { }\n");
    EXPECT_THAT(ported.source,
                HasSubstr("// Only Unity 6's compatibility mode runs 'Execute' of F.cs:"));
    EXPECT_THAT(ported.source, Not(HasSubstr("unknown")));
    EXPECT_THAT(ported.source, Not(HasSubstr("TODO")));
}

TEST(PortedBody, HasMatricesAndTurns)
{
    ExpectLines({{"var turn = Quaternion.AngleAxis(90, Vector3.up);",
                  "glm::angleAxis(glm::radians(90.0f), Vector3(0.0f, 1.0f, 0.0f))"},
                 {"Vector3 ahead = turn * Vector3.forward;", "turn * Vector3(0.0f, 0.0f, 1.0f)"},
                 {"var m = Matrix4x4.TRS(ahead, turn, Vector3.one);",
                  "glm::translate(glm::mat4(1.0f), ahead) * glm::mat4_cast(turn) * "},
                 {"m.SetRow(1, new Vector4(0, 1, 0, 0));", "m = glm::row(m, 1, Vector4("},
                 {"width = m.m03;", "width = m[3][0];"},
                 {"m = Matrix4x4.Inverse(m);", "m = glm::inverse(m);"}});
}

TEST(PortedBody, DescribesSettingsOfUnitysEnumsAndOfSetsOfFlags)
{
    const Ported ported = PortBody("", "",
                                   "  [System.Flags] public enum Bits { A = 1, B = 2 }\n"
                                   "  public Bits bits = Bits.A | Bits.B;\n"
                                   "  public FilterMode filter = FilterMode.Bilinear;\n"
                                   "  public RenderQueueRange range = RenderQueueRange.all;\n");
    ExpectAll(ported.header, {"{\"Everything\", -1},",
                              "inspector.Field(\"filter\", filter, FilterModeEntries(), \"\");",
                              "RenderQueueRange range = RenderQueueRange::all"});
    EXPECT_THAT(ported.header, Not(HasSubstr("TODO"))) << "Unity's serializer knows no ranges";
    EXPECT_THAT(ported.header, Not(HasSubstr("\"range\"")));
}

TEST(PortedBody, DeclaresWhatACallGivesBack)
{
    const Ported ported =
        PortBody("      Split(out Vector2 low, out float rest);\n      width = low.x + rest;\n",
                 "    void Split(out Vector2 low, out float rest) { low = Vector2.one; rest = 2f; "
                 "}\n");
    ExpectAll(ported.source,
              {"        Vector2 low{};\n        float rest{};\n        Split(low, rest);\n"
               "        width = low.x + rest;\n",
               "void Split([[maybe_unused]] Vector2& low, [[maybe_unused]] float& rest)"});
}

TEST(PortedBody, GivesTheSizesOfAKernelsGroups)
{
    const Ported ported =
        PortBody("      kernels.GetKernelThreadGroupSizes(count, out uint x, out groups, out _);\n"
                 "      kernels.GetKernelThreadGroupSizes(count, out uint y, out _, out uint _);\n",
                 "    ComputeShader kernels; uint groups;\n");
    ExpectAll(ported.source, {"        std::uint32_t x{};\n        std::uint32_t _{};\n"
                              "        kernels->GetKernelThreadGroupSizes(count, x, groups, _);\n"
                              "        std::uint32_t y{};\n"
                              "        kernels->GetKernelThreadGroupSizes(count, y, _, _);\n"});
    EXPECT_THAT(ported.source, Not(HasSubstr("TODO")));
}

TEST(PortedBody, TakesAlongWhatARenderFunctionUses)
{
    const Ported ported = PortBody(
        "", "    class Data { public float width; }\n"
            "    public void Record(RenderGraph graph) {\n"
            "      float wide = 2f;\n"
            "      using (var one = graph.AddRasterRenderPass<Data>(\"One\", out var data)) {\n"
            "        data.width = width;\n"
            "        one.SetRenderFunc((Data d, RasterGraphContext c) => { "
            "c.cmd.SetGlobalFloat(\"_W\", d.width); });\n"
            "      }\n"
            "      using (var two = graph.AddRasterRenderPass<Data>(\"Two\", out var data)) {\n"
            "        two.SetRenderFunc((Data d, RasterGraphContext c) => "
            "c.cmd.SetGlobalFloat(\"_W\", wide * width));\n"
            "      }\n"
            "    }\n");
    ExpectAll(ported.source,
              {"one.SetRenderFunc([](Data& d, RasterGraphContext& c)",
               "c.cmd.SetGlobalFloat(\"_W\", d.width);", "data->width = width;",
               "two.SetRenderFunc([=, this]([[maybe_unused]] Data& d, RasterGraphContext& c)",
               "c.cmd.SetGlobalFloat(\"_W\", wide * width);"});
}

TEST(PortedBody, HasElementsOfVectorsAndMatrices)
{
    ExpectLines(
        {{"Matrix4x4 a = Matrix4x4.identity;", "glm::mat4 a = glm::mat4(1.0f);"},
         {"a.m03 = 0.5f;", "a[3][0] = 0.5f;"},
         {"a[1, 2] += 1;", "a[2][1] += 1.0f;"},
         {"Vector3 b = a.MultiplyVector(Vector3.up);",
          "Vector3 b = Vector3(a * Vector4(Vector3(0.0f, 1.0f, 0.0f), 0.0f));"},
         {"b[count] = b[0] * 2;", "b[count] = b[0] * 2.0f;"},
         {"Vector4 c = a * b;", "Vector4 c = a * Vector4(b, 0.0f);"},
         {"width = Mathf.Pow(count, 2);", "width = Mathf::Pow(static_cast<float>(count), 2.0f);"},
         {"width = 1f / Mathf.Max(count, 2);",
          "width = 1.0f / static_cast<float>(Mathf::Max(count, 2));"}});
}

TEST(PortedBody, KnowsTheOneDevice)
{
    ExpectLines(
        {{"bool a = SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLES3;",
          "bool a = false;"},
         {"bool b = SystemInfo.graphicsDeviceType != GraphicsDeviceType.Metal;", "bool b = true;"},
         {"bool c = SystemInfo.copyTextureSupport == CopyTextureSupport.None;", "bool c = false;"},
         {"bool d = SystemInfo.usesReversedZBuffer;",
          "bool d = CurrentCamera::Rendered().cameraData.usesReversedZBuffer;"}});
}

TEST(PortedBody, MakesObjectsWithMembersInPlace)
{
    const Ported ported =
        PortBody("      drops.Add(new Drop { size = width });\n"
                 "      if (numbers.Contains(sizeof(float))) drops.RemoveAt(count - 1);\n"
                 "      width += Time.deltaTime * UnityEngine.Random.Range(0, 1f);\n"
                 "      cmd.Release();\n",
                 "    struct Drop { public float size; }\n"
                 "    List<Drop> drops = new List<Drop>(); List<int> numbers = new List<int>();\n");
    ExpectAll(ported.source,
              {"drops.push_back([&] { auto made = F::P::Drop{}; made.size = width; return made; "
               "}());",
               "if (std::ranges::count(numbers, static_cast<int>(sizeof(float))) > 0)",
               "drops.erase(drops.begin() + (count - 1));",
               "width += static_cast<float>(CurrentCamera::Rendered().deltaTime) * "
               "Random::Range(0.0f, 1.0f);",
               "#include <limn/core/Random.h>"});
    EXPECT_THAT(ported.source, Not(HasSubstr("TODO")));
    EXPECT_THAT(ported.source, Not(HasSubstr("Release")));
}

TEST(PortedBody, PutsNamedArgumentsInTheirOrder)
{
    ExpectLines(
        {{"var a = new FilteringSettings(layerMask: -1, renderQueueRange: RenderQueueRange.all);",
          "auto a = FilteringSettings(RenderQueueRange::all, LayerMask::Everything());"},
         {"var b = new FilteringSettings(renderingLayerMask: 2);",
          "auto b = FilteringSettings(RenderQueueRange::all, LayerMask::Everything(), "
          "RenderingLayerMask(2u));"}});
    const Ported ported = PortBody(
        "",
        "    void Make(RenderGraph graph, RenderTextureDescriptor desc) {\n"
        "      var a = UniversalRenderer.CreateRenderGraphTexture(graph, desc, name: \"_A\", "
        "filterMode: FilterMode.Bilinear);\n"
        "      var b = UniversalRenderer.CreateRenderGraphTexture(graph, clear: true);\n    }\n");
    ExpectAll(ported.source, {"UniversalRenderer::CreateRenderGraphTexture(graph, desc, \"_A\", "
                              "false, FilterMode::Bilinear);",
                              "no argument 'desc'"});
}

TEST(PortedBody, KeepsObjectsOfItsOwnWhereAnothersAreKept)
{
    const Ported ported = PortBody("      own = new Settings();\n      own = settings;\n",
                                   "    Settings own = new Settings();\n");
    ExpectAll(ported.source, {"F::Settings ownOwn;", "Borrowed<F::Settings> own = &ownOwn;",
                              "own = &(ownOwn = F::Settings{});\n        own = settings;"});
    EXPECT_THAT(ported.source, Not(HasSubstr("TODO")));
}

TEST(PortedBody, GivesScopesWithinScopesNamesOfTheirOwn)
{
    const Ported ported =
        PortBody("      using (new ProfilingScope(cmd, profilingSampler)) {\n"
                 "        using (new ProfilingScope(cmd, profilingSampler)) { cmd.Clear(); }\n"
                 "      }\n");
    ExpectAll(ported.source, {"const ProfilingScope profilingScope{*cmd, profilingSampler};",
                              "const ProfilingScope profilingScope2{*cmd, profilingSampler};"});
}

TEST(PortedBody, ChangesNoParameterOfAVolume)
{
    const WorkingFolder working;
    working.folder.Write("F.cs",
                         "public class C : VolumeComponent {\n"
                         "  public enum Mode { Off, On }\n"
                         "  public FloatParameter width = new FloatParameter(1f);\n"
                         "  public VolumeParameter<Mode> mode = new VolumeParameter<Mode>();\n"
                         "  public C() { displayName = \"Width\"; }\n}\n"
                         "public class F : ScriptableRendererFeature {\n"
                         "  public override void Create() {\n"
                         "    var c = VolumeManager.instance.stack.GetComponent<C>();\n"
                         "    c.width.value = 2f;\n  }\n"
                         "  public override void AddRenderPasses(ScriptableRenderer renderer, ref "
                         "RenderingData data) {}\n}\n");
    const Ported ported = Port({"F.cs"}, "F");
    ExpectAll(ported.header,
              {"EnumParameter<C::Mode> mode{this, \"mode\", C::Mode{}, {{\"Off\", C::Mode::Off}, "
               "{\"On\", C::Mode::On}}};",
               "    C()\n    {\n        displayName = \"Width\";\n    }"});
    EXPECT_THAT(ported.source,
                HasSubstr("a volume's parameter is not changed by those who read it"));
}

} // namespace limn::test
