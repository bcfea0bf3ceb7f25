#include "Mentions.h"
#include "port/Ported.h"

#include <gmock/gmock.h>

// What `limn port` makes of C# that is written in another way than most.

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using testing::Not;

constexpr const char* k_Frame =
    "public class F : ScriptableRendererFeature {\n"
    "    public override void Create() { }\n"
    "    public override void AddRenderPasses(ScriptableRenderer r, ref RenderingData d) { }\n";

/// A feature F with these members and classes.
Ported PortMembers(const std::string& members, const std::string& classes = "")
{
    const WorkingFolder working;
    working.folder.Write("F.cs", k_Frame + members + "}\n" + classes);
    return Port({"F.cs"}, "F");
}

std::size_t CountOf(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    {
        ++count;
    }
    return count;
}

std::string Repeated(const std::string& text, int times)
{
    std::string all;
    for (int i = 0; i < times; ++i)
    {
        all += text;
    }
    return all;
}

void ExpectTooDeep(const std::string& text, const std::string& place)
{
    const WorkingFolder working;
    working.folder.Write("a.cs", text);
    const CommandRun run = RunCommand({"port", "a.cs", "-o", "out"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions("a.cs:" + place + ":", "nested", "100 deep")));
}

} // namespace

TEST(PortInput, NestedTooDeeplyIsAnErrorWithItsPlace)
{
    ExpectTooDeep("class A : " + Repeated("C<", 50000) + "int" + Repeated(">", 50000) + " { }",
                  "1:212");
    ExpectTooDeep("class A {\n " + Repeated("C<", 50000) + "int" + Repeated(">", 50000) + " f; }",
                  "2:203");
    ExpectTooDeep("class A {\n void M(" + Repeated("C<", 200) + "int" + Repeated(">", 200) +
                      " p) { } }",
                  "2:210");
    ExpectTooDeep("class A {\n int" + Repeated("[]", 50000) + " f; }", "2:205");
    ExpectTooDeep(Repeated("class A { ", 50000) + Repeated("}", 50000), "1:1009");
    ExpectTooDeep("class A {\n string s = $\"{new " + Repeated("C<", 200) + "int" +
                      Repeated(">", 200) + "()}\"; }",
                  "2:221");
}

TEST(PortInput, ClassesThatDeriveFromEachOtherEnd)
{
    const Ported ported =
        PortMembers("", "class A : B { void M() { N(); } }\nclass B : A { void O() { N(); } }\n");
    EXPECT_THAT(ported.run.err, HasSubstr("unknown: 'N'"));
}

TEST(PortInput, APassSharesTheSettingsOfItsFeature)
{
    const Ported ported = PortMembers(
        "    public class Settings { public float width = 2; public RenderPassEvent when; }\n"
        "    public struct Look { public float alpha; }\n"
        "    public Settings settings = new Settings();\n"
        "    class P : ScriptableRenderPass {\n"
        "        Settings settings; Settings later = new Settings(); Settings own = new "
        "Settings();\n"
        "        Look look;\n"
        "        class Data { public Settings s; }\n"
        "        public P(Settings settings, Look look) {\n"
        "            renderPassEvent = this.settings.when;\n"
        "            this.settings = settings;\n"
        "            renderPassEvent = this.settings.when;\n"
        "            this.look = look;\n"
        "        }\n"
        "        void Set(Settings s) { later = s; }\n"
        "    }\n");
    ExpectAll(ported.header, {"F::Settings settings;"});
    ExpectAll(ported.source,
              {"Borrowed<F::Settings> settings;", "Borrowed<F::Settings> later = &laterOwn;",
               "F::Settings own;", "F::Look look;", "Borrowed<F::Settings> s;",
               "F::Settings& settings_, const F::Look& look_)",
               "        settings = &settings_;\n"
               "        renderPassEvent = settings->when;\n"
               "        look = look_;\n"});
    EXPECT_EQ(2u, CountOf(ported.source, "        renderPassEvent = settings->when;"));
    EXPECT_THAT(ported.source, HasSubstr("later = &s;"));
}

TEST(PortInput, NumbersOfPropertiesHaveTheirOwnType)
{
    const Ported ported =
        PortMembers("    class P : ScriptableRenderPass {\n"
                    "        static readonly int s_Tint = Shader.PropertyToID(\"_Tint\");\n"
                    "        readonly int m_Source; int m_Count = 3; int m_Other;\n"
                    "        int[] m_Levels = new int[4];\n"
                    "        public P(int source, int count) {\n"
                    "            m_Source = source;\n"
                    "            m_Other = Shader.PropertyToID(\"_Other\");\n"
                    "            m_Count = count;\n"
                    "            m_Levels[0] = Shader.PropertyToID(\"_Level\" + count);\n"
                    "        }\n"
                    "        void Get(CommandBuffer cmd, int name, int width) { "
                    "cmd.GetTemporaryRT(name, width, 1); }\n"
                    "        void Use(CommandBuffer cmd) { cmd.SetGlobalTexture(m_Source, "
                    "m_Other); Pass(s_Tint); }\n"
                    "        void Pass(int id) { }\n"
                    "    }\n");
    ExpectAll(ported.source,
              {"inline static const ShaderPropertyId s_Tint = Shader::PropertyToID(\"_Tint\");",
               "ShaderPropertyId m_Source{};", "int m_Count = 3;", "ShaderPropertyId m_Other{};",
               "m_Levels = std::vector<ShaderPropertyId>(4);",
               "P(ShaderPropertyId source, int count)",
               "Shader::PropertyToID(std::string(\"_Level\") + std::to_string(count));",
               "m_Source = source;", "m_Other = Shader::PropertyToID(\"_Other\");",
               "ShaderPropertyId name_, int width)", "cmd.GetTemporaryRT(name_, width, 1);",
               "cmd.SetGlobalTexture(m_Source, m_Other);",
               "void Pass([[maybe_unused]] ShaderPropertyId id)"});
}

TEST(PortInput, ReferencesToPartsOfTheFrameAreFollowed)
{
    const Ported ported = PortMembers(
        "    void M(ref RenderingData data) {\n"
        "        ref var a = ref data.cameraData; var b = a.camera.orthographicSize;\n"
        "        ref CameraData c = ref data.cameraData; var d = c.cameraTargetDescriptor.width;\n"
        "    }\n"
        "    void N(ref float amount, out Color color) { color = default; }\n");
    EXPECT_THAT(ported.run.err, Not(HasSubstr("unknown")));
    ExpectAll(ported.report, {"`Camera.orthographicSize`", "`RenderTextureDescriptor.width`"});
    EXPECT_THAT(ported.header, HasSubstr("void N(float& amount, Color& color);"));
    ExpectAll(ported.source, {"auto& a = data.cameraData;", "auto& c = data.cameraData;",
                              "auto d = c.cameraTargetDescriptor.width;", "color = {};"});
}

TEST(PortInput, AContextItemAndConstantsAreClasses)
{
    const Ported ported = PortMembers(
        "    public int pass = Passes.Blur;\n",
        "static class Passes { public const int Copy = 0, Blur = 1;\n"
        "    public static readonly int Id = Shader.PropertyToID(\"_X\");\n"
        "    public static float Half(float x) => x / 2; }\n"
        "class Shared : ContextItem { public TextureHandle mask; public int count = 2;\n"
        "    public override void Reset() { count = 0; } }\n");
    ExpectAll(ported.header,
              {"struct Passes\n", "static constexpr int Copy = 0;",
               "static constexpr int Blur = 1;",
               "inline static const ShaderPropertyId Id = Shader::PropertyToID(\"_X\");",
               "static float Half(float x)", "return x / 2.0f;", "int pass = Passes::Blur;",
               "class Shared final : public ContextItem", "TextureHandle mask{};",
               "void Reset() override", "        count = 0;\n"});
    EXPECT_THAT(ported.source, Not(HasSubstr("limn has nothing of this kind")));
}

TEST(PortInput, AFunctionOfAGraphPassStandsOnce)
{
    const Ported ported = PortMembers(
        "    class P : ScriptableRenderPass {\n"
        "        class Data { public Material material; }\n"
        "        public override void RecordRenderGraph(RenderGraph graph, ContextContainer frame) "
        "{\n"
        "            using (var builder = graph.AddRasterRenderPass<Data>(\"X\", out var data)) {\n"
        "                data.material = null;\n"
        "                builder.SetRenderFunc((Data d, RasterGraphContext c) => { OnlyHere(d); "
        "});\n"
        "            }\n"
        "        }\n"
        "    }\n");
    EXPECT_EQ(1u, CountOf(ported.source, "OnlyHere(d)")) << ported.source;
    ExpectAll(ported.source, {"// OnlyHere(d);", "data->material = {};\n"});
}

TEST(PortInput, AGraphPassMaySayItsDatasTypeBehindOutAndItsNameInAVariable)
{
    const Ported ported = PortMembers(
        "    class P : ScriptableRenderPass {\n"
        "        class Data { public Material material; }\n"
        "        ProfilingSampler mine = new ProfilingSampler(\"Mine\");\n"
        "        public override void RecordRenderGraph(RenderGraph graph, ContextContainer frame) "
        "{\n"
        "            string title = \"Titled\";\n"
        "            using (IRasterRenderGraphBuilder b = graph.AddRasterRenderPass(\"Typed\", out "
        "Data data, this.profilingSampler)) {\n"
        "                b.SetRenderFunc((Data d, RasterGraphContext c) => { });\n"
        "            }\n"
        "            using (var b = graph.AddUnsafePass<Data>(title, out var data, mine)) {\n"
        "                b.SetRenderFunc((Data d, UnsafeGraphContext c) => { });\n"
        "            }\n"
        "            string twice = \"A\";\n"
        "            twice = \"B\";\n"
        "            using (var b = graph.AddUnsafePass<Data>(twice, out var data)) { }\n"
        "            using (var b = graph.AddUnsafePass(\"No type\", out var data)) { }\n"
        "        }\n"
        "    }\n");
    ExpectAll(ported.source,
              {"auto b = graph.AddRasterRenderPass<Data>(\"Typed\", data, profilingSampler);",
               "auto b = graph.AddUnsafePass<Data>(title, data, mine);",
               "auto b = graph.AddUnsafePass<Data>(twice, data);",
               "'var builder = renderGraph.AddUnsafePass<PassData>(name, out var passData)' is "
               "expected"});
}

TEST(PortInput, AComponentThatAClassKeepsIsAPointer)
{
    const Ported ported = PortMembers(
        "    class P : ScriptableRenderPass {\n"
        "        Mist mist;\n"
        "        Mist other = null;\n"
        "        public P(Mist mist) { this.mist = mist; }\n"
        "        public override void Execute(ScriptableRenderContext c, ref RenderingData d) { }\n"
        "    }\n"
        "    private Mist last;\n",
        "class Mist : VolumeComponent { public FloatParameter x = new FloatParameter(1f); }\n");
    ExpectAll(ported.source, {"    Borrowed<const Mist> mist;\n",
                              "    Borrowed<const Mist> other;\n", "        mist = &mist_;\n"});
    EXPECT_THAT(ported.header, HasSubstr("    Borrowed<const Mist> last;\n"));
    EXPECT_THAT(ported.header + ported.source, Not(HasSubstr("a member")));
}

TEST(PortInput, VectorsOfUnitysNamesAreNumbers)
{
    const Ported ported =
        PortMembers("    public Vector4 all = Vector4.one;\n    Vector3 ahead = Vector3.forward;\n"
                    "    Vector3 under = Vector3.down;\n    Vector4 none = Vector4.up;\n",
                    "class V : VolumeComponent {\n"
                    "    public Vector2Parameter a = new Vector2Parameter(Vector2.one);\n"
                    "    public Vector3Parameter b = new Vector3Parameter(Vector3.zero, true);\n"
                    "}\n");
    ExpectAll(ported.header,
              {"Vector2Parameter a{this, \"a\", Vector2(1.0f, 1.0f)};",
               "Vector3Parameter b{this, \"b\", Vector3(0.0f, 0.0f, 0.0f), true};",
               "Vector4 all = Vector4(1.0f, 1.0f, 1.0f, 1.0f);",
               "Vector3 ahead = Vector3(0.0f, 0.0f, 1.0f);",
               "Vector3 under = Vector3(0.0f, -1.0f, 0.0f);", "// Vector4 none = Vector4.up;"});
}

TEST(PortInput, AMaskOfItsOwnIsNoneOfLimns)
{
    const Ported ported =
        PortMembers("    public RenderingLayerMask mine = 2u;\n",
                    "public struct RenderingLayerMask { public uint bits;\n"
                    "    public RenderingLayerMask(uint value) { bits = value; } }\n"
                    "public class BitsParameter : VolumeParameter<uint> { }\n"
                    "class V : VolumeComponent {\n"
                    "    public BitsParameter layers = new BitsParameter(2);\n"
                    "    public BitsParameter noLayers = new BitsParameter();\n"
                    "}\n");
    ExpectAll(
        ported.header,
        {"RenderingLayerMaskParameter layers{this, \"layers\", limn::RenderingLayerMask(2u)};",
         "RenderingLayerMaskParameter noLayers{this, \"noLayers\", "
         "limn::RenderingLayerMask::Nothing()};",
         "// RenderingLayerMask mine = 2u;", "    RenderingLayerMask mine;\n"});
}

TEST(PortInput, HelpersOfColourMasksAndTheFramesResultsGoOver)
{
    const Ported ported = PortMembers("    RenderStateBlock Block(ColorWriteMask mask, "
                                      "CullingResults results, VolumeStack stack) "
                                      "{ return new RenderStateBlock(RenderStateMask.Blend); }\n");
    EXPECT_THAT(ported.header, HasSubstr("RenderStateBlock Block(const ColorWriteMask& mask, const "
                                         "CullingResults& results, const VolumeStack& stack);"));
    EXPECT_THAT(ported.source, HasSubstr("return RenderStateBlock(RenderStateMask::Blend);"));
}

TEST(PortInput, AParameterThatIsChangedIsACopy)
{
    const Ported ported = PortMembers(
        "    void A(RenderTextureDescriptor desc) { desc.msaaSamples = 1; }\n"
        "    void B(RenderTextureDescriptor desc) { other.desc.msaaSamples = desc.msaaSamples; }\n"
        "    void C(Color color) { color *= 2f; }\n");
    ExpectAll(ported.header,
              {"void A(RenderTextureDescriptor desc);",
               "void B(const RenderTextureDescriptor& desc);", "void C(Color color);"});
}

TEST(PortInput, ATooltipInPiecesIsOne)
{
    EXPECT_THAT(
        PortMembers("    [Tooltip(\"How wide, \" +\n        \"in pixels.\")] public int w;\n")
            .header,
        HasSubstr("inspector.Field(\"w\", w, \"How wide, in pixels.\");"));
}

TEST(PortInput, OneBranchOfAConditionIsPorted)
{
    const std::string members =
        "#if UNITY_6000_0_OR_NEWER\n    public int newer = 1;\n#else\n    public int older = "
        "1;\n#endif\n"
        "    void M() {\n#if UNITY_6000_0_OR_NEWER\n        New();\n#elif URP_14_0_OR_NEWER\n"
        "        Middle();\n#else\n        Old();\n#endif\n    }\n";
    const Ported ported = PortMembers(members);
    EXPECT_THAT(ported.header, HasSubstr("int older = 1;"));
    EXPECT_THAT(ported.header, Not(HasSubstr("newer")));
    EXPECT_THAT(ported.source, HasSubstr("Middle();"));
    EXPECT_THAT(ported.source, Not(HasSubstr("New();")));
    EXPECT_THAT(ported.source, Not(HasSubstr("Old();")));
    EXPECT_THAT(ported.source, Not(HasSubstr("#if")));
    EXPECT_THAT(ported.run.err, Mentions("Unity 2022.3", "'UNITY_6000_0_OR_NEWER' is false",
                                         "'URP_14_0_OR_NEWER' is true"));
}

TEST(PortInput, CSharpOfALaterUnityIsReadForIt)
{
    const WorkingFolder working;
    working.folder.Write("F.cs",
                         "#if UNITY_6000_0_OR_NEWER\n" + std::string(k_Frame) + "}\n#endif\n");
    EXPECT_THAT(Port({"F.cs"}, "F").run.err, HasSubstr("the C# is read for Unity 6000.0 (URP 17)"));
    working.folder.Write("G.cs", "#if WITH_EFFECTS\n" + std::string(k_Frame) + "}\n#endif\n");
    const CommandRun run = RunCommand({"port", "G.cs", "-o", "other"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("(URP 14): 'WITH_EFFECTS' is true"));
}

TEST(PortInput, AColourWithHintsAndATooltipCompiles)
{
    const Ported ported = PortMembers(
        "", "class V : VolumeComponent {\n"
            "    [Tooltip(\"Why?\?!\")] public ColorParameter a = new ColorParameter(Color.red, "
            "true, true, true);\n"
            "    [Tooltip(\"T\")] public ColorParameter b = new ColorParameter(Color.red);\n"
            "    public ColorParameter c = new ColorParameter(Color.red, hdr: true, showAlpha: "
            "false, showEyeDropper: true, overrideState: true);\n"
            "    public ClampedFloatParameter d = new ClampedFloatParameter(value: 1, min: 0, max: "
            "2);\n"
            "    public Layers e = new Layers(1); public VolumeParameter<uint> f = new "
            "VolumeParameter<uint>();\n"
            "    public class Layers : VolumeParameter<uint> { }\n"
            "    bool IsOn() => d.overrideState;\n}\n");
    ExpectAll(ported.header,
              {"ColorParameter a{this, \"a\", Color::red, true, true, true, false, {.tooltip = "
               "\"Why?\\?!\"}};",
               "ColorParameter b{this, \"b\", Color::red, {.tooltip = \"T\"}};",
               "ColorParameter c{this, \"c\", Color::red, true, false, true, true};",
               "ClampedFloatParameter d{this, \"d\", 1.0f, 0.0f, 2.0f};",
               "RenderingLayerMaskParameter e{this, \"e\", RenderingLayerMask(1u)};",
               "UIntParameter f{this, \"f\", 0u};"});
}

// A nested class has its default values behind the class around it only.
TEST(PortInput, AStaticMemberOfANestedClassIsDefinedBehindTheOuterClass)
{
    const Ported ported =
        PortMembers("    P m_Pass;\n", "class P : ScriptableRenderPass {\n"
                                       "    class History { public int frames = 2; }\n"
                                       "    static History s_History; static History s_Made = "
                                       "new History(); }\n");
    ExpectAll(ported.source,
              {"    static P::History s_History;\n", "    static P::History s_Made;\n",
               "};\ninline P::History P::s_History;\ninline P::History P::s_Made;\n"});
}

TEST(PortInput, ArraysAndMasksBeginWithWhatTheyBeginWithInCSharp)
{
    const Ported ported = PortMembers("    const int Most = 4;\n"
                                      "    Vector4[] centers = new Vector4[16];\n"
                                      "    RTHandle[] handles = new RTHandle[Most + 1];\n"
                                      "    int[] two = new int[2] { 3, 4 };\n"
                                      "    int[][] rows = new int[2][];\n"
                                      "    class Row { public int n = 2; }\n"
                                      "    Row[] own = new Row[3];\n"
                                      "    float[] table = new float[2, 2];\n"
                                      "    LayerMask mine = 5;\n"
                                      "    LayerMask odd = -2;\n"
                                      "    static readonly int s_Copy = Shader.PropertyToID("
                                      "\"_Copy\");\n"
                                      "    RenderTargetIdentifier copy = new "
                                      "RenderTargetIdentifier(s_Copy);\n");
    ExpectAll(ported.header,
              {"std::vector<Vector4> centers = std::vector<Vector4>(16);",
               "handles = std::vector<RTHandle>(static_cast<std::size_t>(Most + 1));",
               "std::vector<int> two = {3, 4};", "LayerMask mine = LayerMask(5u);",
               "RenderTargetIdentifier copy = RenderTargetIdentifier(s_Copy);",
               "// int[][] rows = new int[2][];", "// Row[] own = new Row[3];",
               "// float[] table = new float[2, 2];", "// LayerMask odd = -2;"});
}

TEST(PortInput, SettingsOfMasksAndOfSettingsAreSettings)
{
    const Ported ported =
        PortMembers("    public class Inner { [Range(0, 4)] public uint count = 2; }\n"
                    "    public class Outer { public Inner inner = new Inner(); }\n"
                    "    public Outer settings = new Outer();\n"
                    "    public RenderingLayerMask layers = 6; public uint bits = 0xFFFFFFFF;\n"
                    "    [Tooltip(\"Base/Map\")] public Material material;\n");
    ExpectAll(ported.header,
              {"inspector.BeginGroup(\"settings\");", "inspector.BeginGroup(\"inner\");",
               "Field(\"count\", count, {0, 4}, \"\");", "layers = RenderingLayerMask(6u);",
               "Field(\"layers\", layers, \"\");", "std::uint32_t bits = 0xFFFFFFFFu;",
               "Shared<Material> material{};",
               "Field(\"material\", material, std::string_view(\"Base/Map\"));"});
    EXPECT_THAT(ported.header, Not(HasSubstr("TODO")));
}

TEST(PortInput, TheNumberOfTodosIsThatOfTheCpp)
{
    const Ported ported = PortMembers("    public Gradient ramp; void M() { ramp.Evaluate(1); }\n");
    const std::size_t todos = CountOf(ported.header, "// TODO") + CountOf(ported.source, "// TODO");
    EXPECT_GE(todos, 3u); // a member, a setting, a statement
    EXPECT_THAT(ported.run.err, HasSubstr("and " + std::to_string(todos) + " TODOs are left"));
}

TEST(PortInput, AGeneratedTestHasTheLinesOfTheFilter)
{
    const WorkingFolder working;
    working.folder.Write(
        "F.cs",
        k_Frame +
            std::string("    LayerMask layers;\n"
                        "    void M() { var f = new FilteringSettings(RenderQueueRange.opaque,\n"
                        "        layers, 3); }\n}\n"));
    Port({"F.cs"}, "F");
    const std::string test = ReadText("out/FTest.cpp");
    ExpectAll(test, {"// C#: F.cs:5: FilteringSettings(RenderQueueRange.opaque, layers, 3)",
                     "filtering.renderQueueRange = RenderQueueRange::opaque;",
                     "filtering.layerMask = LayerMask::Everything();",
                     "filtering.renderingLayerMask = RenderingLayerMask(3u);", "report.draws",
                     "JudgeMasks("});
    EXPECT_THAT(test.substr(test.find("void TestWithoutDevice"),
                            test.find("void TestWithDevice") - test.find("void TestWithoutDevice")),
                Not(HasSubstr("TODO")));
}

TEST(PortInput, NamesThatCppKeepsAndOtherAlphabetsCompile)
{
    const WorkingFolder working;
    working.folder.Write("F.cs",
                         "public class Gl\xC3\xA4nz" + std::string(k_Frame).substr(13) +
                             "    [Tooltip(\"\xE4 of Latin-1\")] public float register;\n"
                             "    public enum NULL { and = 1 << 2 | 1, Big = 0x80000000 }\n"
                             "    void Take(Texture a) { } void Take(Texture2D a) { }\n}\n");
    const CommandRun run = RunCommand({"port", "F.cs", "-o", "out"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    const std::string header = ReadText("out/Gl\xC3\xA4nz"
                                        "F.h");
    ExpectAll(header, {"namespace Glxc3xa4nzFPlugin", "float register_{};", "enum class NULL_",
                       "and_ = 5, // 1 << 2 | 1", "\"? of Latin-1\""});
    EXPECT_EQ(1u, CountOf(header, "void Take("));
    EXPECT_THAT(ReadText("out/CMakeLists.txt"), HasSubstr("project(Glxc3xa4nzF "));
}

} // namespace limn::test
