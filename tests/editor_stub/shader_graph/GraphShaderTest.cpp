// Shader graphs as ShaderLab.

#include "GraphFixture.h"

namespace limn::test
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using ShaderOfAGraph = GraphFolder;

std::vector<std::string> LightModes(const ShaderLabDocument& document)
{
    std::vector<std::string> modes;
    for (const ShaderLabPass& pass : document.subShaders.front().passes)
    {
        modes.emplace_back(pass.lightMode());
    }
    return modes;
}

TEST_F(ShaderOfAGraph, HasThePassesOfItsTarget)
{
    EXPECT_THAT(LightModes(Parsed(GraphText("Unlit"))),
                ElementsAre("SRPDefaultUnlit", "ShadowCaster", "DepthOnly", "DepthNormalsOnly"));
    EXPECT_THAT(LightModes(Parsed(GraphText("Lit"))),
                ElementsAre("UniversalForward", "ShadowCaster", "DepthOnly", "DepthNormals"));
    EXPECT_THAT(LightModes(Parsed(GraphText("Lit", R"("m_CastShadows": false)"))),
                ElementsAre("UniversalForward", "DepthOnly", "DepthNormals"));
    EXPECT_THAT(LightModes(Parsed(GraphText("Unlit", R"("m_SurfaceType": 1)"))),
                ElementsAre("SRPDefaultUnlit", "ShadowCaster"));
    EXPECT_THAT(LightModes(Parsed(GraphText("SpriteUnlit"))), ElementsAre("UniversalForward"));
    const ShaderLabDocument screen = Parsed(GraphText("Fullscreen"));
    ASSERT_EQ(screen.subShaders.front().passes.size(), 2u);
    EXPECT_EQ(screen.subShaders.front().passes[0].name, "DrawProcedural");
    EXPECT_EQ(screen.subShaders.front().passes[1].name, "Blit");
    EXPECT_EQ(screen.name, "Tests/a");
}

/// The state of the first pass, as it is written.
std::string FirstState(const std::string& shaderLab)
{
    const std::size_t begin = shaderLab.find("Cull", shaderLab.find("Pass"));
    std::string state = shaderLab.substr(begin, shaderLab.find("HLSLPROGRAM") - begin);
    std::string words;
    for (std::istringstream stream(state); stream >> state;)
    {
        words += (words.empty() ? "" : " ") + state;
    }
    return words;
}

TEST_F(ShaderOfAGraph, HasTheStateOfItsTarget)
{
    EXPECT_EQ(FirstState(Translate(GraphText()).shaderLab),
              "Cull Back Blend Off ZTest LEqual ZWrite On");
    EXPECT_EQ(FirstState(Translate(GraphText("Lit", R"("m_SurfaceType": 1, "m_AlphaMode": 2,
                  "m_RenderFace": 0, "m_ZTestMode": 8, "m_ZWriteControl": 1)"))
                             .shaderLab),
              "Cull Off Blend SrcAlpha One, One One ZTest Always ZWrite On");
    const std::string own =
        Translate(GraphText("Unlit", R"("m_AllowMaterialOverride": true, "m_SurfaceType": 1)"))
            .shaderLab;
    EXPECT_EQ(FirstState(own), "Cull [_Cull] Blend [_SrcBlend] [_DstBlend] ZTest [_ZTest] ZWrite "
                               "[_ZWrite]");
    EXPECT_THAT(own, HasSubstr("_DstBlend(\"_DstBlend\", Float) = 10"));
    EXPECT_THAT(own, HasSubstr("shader_feature_local_fragment _ _ALPHATEST_ON"));
    const ShaderLabDocument cut = Parsed(GraphText("Unlit", R"("m_AlphaClip": true)"));
    EXPECT_EQ(*cut.subShaders.front().tags.Find("Queue"), "AlphaTest");

    GraphText screen("Fullscreen");
    screen.Object("data", "UnityEditor.Rendering.Fullscreen.ShaderGraph.FullscreenData",
                  R"("m_BlendMode": 1, "m_EnableStencil": true, "m_StencilReference": 3,
                  "m_StencilReadMask": 7, "m_StencilWriteMask": 255,
                  "m_StencilCompareFunction": 3, "m_DepthWrite": true, "m_DepthTestMode": 4)");
    EXPECT_EQ(FirstState(Translate(screen).shaderLab),
              "Cull Off Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha ZTest LEqual ZWrite "
              "On Stencil { Ref 3 ReadMask 7 WriteMask 255 Comp Equal Pass Keep Fail Keep ZFail "
              "Keep }");
}

TEST_F(ShaderOfAGraph, HasItsPropertiesAndKeywords)
{
    GraphText graph;
    graph.Property("Vector1", "_Glow", R"("m_Value": 0.5, "m_FloatType": 1,
                   "m_RangeValues": {"x": 0, "y": 2})",
                   "Vector1");
    graph.Property("Color", "_Tint", R"("m_Value": {"r": 1, "g": 0.5, "b": 0, "a": 1},
                   "m_ColorMode": 1)",
                   "Vector4");
    graph.Property("Boolean", "_On", R"("m_Value": true)", "Boolean");
    graph.Property("Texture2D", "_Map", R"("useTilingAndOffset": true, "m_DefaultType": 3)",
                   "Texture2D");
    graph.Property("Vector2", "_Hidden", R"("m_OverrideReferenceName": "_Global",
                   "m_GeneratePropertyBlock": false)",
                   "Vector2");
    graph.Keyword("WET", R"("m_KeywordType": 0, "m_KeywordDefinition": 0, "m_Value": 1)");
    graph.Keyword("KIND", R"("m_KeywordType": 1, "m_KeywordDefinition": 1, "m_KeywordScope": 1,
                  "m_Entries": [{"id": 1, "referenceName": "A"}, {"id": 2, "referenceName": "B"}])");
    const std::string text = Translate(graph).shaderLab;
    EXPECT_THAT(text, HasSubstr("_Glow(\"_Glow\", Range(0, 2)) = 0.5\n"));
    EXPECT_THAT(text, HasSubstr("[HDR] _Tint(\"_Tint\", Color) = (1, 0.5, 0, 1)\n"));
    EXPECT_THAT(text, HasSubstr("[ToggleUI] _On(\"_On\", Float) = 1\n"));
    EXPECT_THAT(text, HasSubstr("        _Map(\"_Map\", 2D) = \"bump\" {}\n"));
    EXPECT_THAT(text, HasSubstr("float4 _Map_ST;"));
    EXPECT_THAT(text, HasSubstr("[Toggle(WET)] WET(\"WET\", Float) = 1\n"));
    EXPECT_THAT(text, HasSubstr("#pragma shader_feature_local _ WET\n"));
    EXPECT_THAT(text, HasSubstr("#pragma multi_compile KIND_A KIND_B\n"));
    const std::size_t end = text.find("CBUFFER_END");
    EXPECT_GT(text.find("float2 _Global;"), end) << "the frame's, not the material's";
    EXPECT_LT(text.find("float _Glow;"), end);
    EXPECT_THAT(text, Not(HasSubstr("_Global(\"")));
}

/// A graph whose colour is what a sub graph makes of a property.
GraphText GraphOfASubGraph()
{
    GraphText graph;
    const std::string glow = graph.Property("Vector1", "_Glow", R"("m_Value": 0.5)", "Vector1");
    const std::string sub = graph.Node(
        "SubGraph", "3 In Vector1, >7 Out Vector3",
        R"("m_SerializedSubGraph": "{\"subGraph\": {\"fileID\": 1, \"guid\": \"inner\"}}",
        "m_PropertyGuids": ["property0"], "m_PropertyIds": [3])");
    graph.Connect(glow, 0, sub, 3);
    graph.Connect(sub, 7, graph.Block("SurfaceDescription.BaseColor", "0 BaseColor ColorRGB"), 0);
    return graph;
}

TEST_F(ShaderOfAGraph, HasWhatItsSubGraphsCompute)
{
    GraphText inner;
    const std::string in = inner.Property("Vector1", "_Inner", "", "Vector1");
    const std::string node = inner.Node("OneMinus", "0 In DynamicVector, >1 Out DynamicVector");
    inner.Connect(in, 0, node, 0);
    inner.Connect(node, 1, inner.Node("SubGraphOutput", "7 Out Vector3"), 7);
    inner.Object("data", "UnityEditor.ShaderGraph.GraphData", "");
    Write("inner.shadersubgraph", inner.text());
    const std::string text = Translate(GraphOfASubGraph()).shaderLab;
    EXPECT_THAT(text, HasSubstr("float v0 = 1 - _Glow;"));
    EXPECT_THAT(text, HasSubstr("surface.BaseColor = float3(v0, v0, v0);"));
}

TEST_F(ShaderOfAGraph, CallsTheFunctionsOfItsAuthor)
{
    m_Folder.Write("Waves.hlsl", "void Waves_float(float2 uv, out float h) { h = uv.x; }\n");
    m_Files["waves"] = m_Folder / "Waves.hlsl";
    GraphText graph;
    const std::string file =
        graph.Node("CustomFunction", ">1 h Vector1, 0 uv Vector2 = {\"x\": 1, \"y\": 2}",
                   R"("m_SourceType": 0, "m_FunctionName": "Waves", "m_FunctionSource": "waves")");
    const std::string text =
        graph.Node("CustomFunction", "0 h Vector1, 2 map Texture2DInput, >1 c Vector3",
                   R"("m_SourceType": 1, "m_FunctionName": "Foam", "m_FunctionBody": "c = h;")");
    graph.Connect(file, 1, text, 0);
    graph.Connect(text, 1, graph.Block("SurfaceDescription.BaseColor", "0 BaseColor ColorRGB"), 0);
    const std::string shader = Translate(graph).shaderLab;
    EXPECT_THAT(shader, HasSubstr("#include \"Waves.hlsl\"\n"));
    EXPECT_THAT(shader, HasSubstr("Waves_float(float2(1, 2), v0);"));
    EXPECT_THAT(shader, HasSubstr("void Foam_node1(float h, UnityTexture2D map, out float3 c)"));
}

TEST_F(ShaderOfAGraph, CallsTheFunctionOfItsPrecision)
{
    m_Folder.Write("Waves.hlsl", "");
    m_Files["waves"] = m_Folder / "Waves.hlsl";
    for (const auto& [precision, graphs, called] :
         {std::tuple("0", R"("m_GraphPrecision": 1)", "Waves_float("),
          std::tuple("0", R"("m_GraphPrecision": 2)", "Waves_half("),
          std::tuple("0", R"("m_ConcretePrecision": 1)", "Waves_half("),
          std::tuple("1", R"("m_GraphPrecision": 2)", "Waves_float("),
          std::tuple("2", R"("m_GraphPrecision": 0)", "Waves_half(")})
    {
        GraphText graph;
        const std::string node =
            graph.Node("CustomFunction", ">1 h Vector1",
                       std::string(R"("m_FunctionName": "Waves", "m_FunctionSource": "waves", )") +
                           R"("m_Precision": )" + precision);
        graph.Connect(node, 1, graph.Block("SurfaceDescription.BaseColor", "0 C ColorRGB"), 0);
        EXPECT_THAT(Problems(graph.text(graphs)), ElementsAre());
        EXPECT_THAT(TranslateGraph(m_Folder / "a.shadergraph",
                                   [this](const std::string& guid) { return m_Files[guid]; })
                        .shaderLab,
                    HasSubstr(called))
            << precision << graphs;
    }
}

TEST_F(ShaderOfAGraph, NamesTheTexturesThatStandInIt)
{
    GraphText graph;
    const std::string asset = graph.Node("Texture2DAsset", ">0 Out Texture2D",
                                         R"("m_Texture": {"m_SerializedTexture":
        "{\"texture\": {\"fileID\": 2800000, \"guid\": \"abc\", \"type\": 3}}"})");
    const std::string sample = graph.Node(
        "SampleTexture2D", "1 Texture Texture2DInput, 2 UV UV, 3 Sampler SamplerState, >0 RGBA "
                           "Vector4");
    graph.Connect(asset, 0, sample, 1);
    graph.Connect(sample, 0, graph.Block("SurfaceDescription.BaseColor", "0 BaseColor ColorRGB"),
                  0);
    const TranslatedGraph translated = Translate(graph);
    ASSERT_EQ(translated.textures.size(), 1u);
    EXPECT_EQ(translated.textures[0].guid, "abc");
    EXPECT_EQ(translated.textures[0].fileID, 2800000);
    EXPECT_THAT(translated.shaderLab, HasSubstr(translated.textures[0].property + "(\""));
}

TEST_F(ShaderOfAGraph, ListsAllThatItCannotTranslate)
{
    GraphText graph = GraphOfASubGraph();
    const std::string strange = graph.Node("Hologram", ">0 Out Vector1");
    const std::string light = graph.Node("LightTexture", ">0 Out Texture2D");
    graph.Connect(strange, 0, graph.Block("SurfaceDescription.Alpha", "0 Alpha Vector1"), 0);
    graph.Connect(light, 0,
                  graph.Block("SurfaceDescription.AlphaClipThreshold", "0 Threshold Vector1"), 0);
    EXPECT_THAT(Problems(graph.text()), ElementsAre(Mentions("Hologram", "unknown to limn"),
                                                    Mentions("LightTexture", "unknown to limn"),
                                                    Mentions("sub graph", "guid inner")));
}

TEST_F(ShaderOfAGraph, IsAnErrorOfItsFileWhereItIsNone)
{
    EXPECT_THAT(Problems(R"({"m_SerializableNodes": []})"),
                ElementsAre(Mentions("no target for URP")));
    EXPECT_THAT(Problems(R"({"m_SerializableNodes": [{"JSONnodeData": "{"}]})"),
                ElementsAre(Mentions("JSON")));
    EXPECT_THAT(Problems("{} {\"a\": "), ElementsAre(Mentions("JSON", "number 1")));
    EXPECT_THAT(Problems("[1, 2]"), ElementsAre(Mentions("no shader graph", "GraphData")));
    EXPECT_THAT(Problems(GraphText("Decal").text()),
                ElementsAre(Mentions("UniversalDecalSubTarget", "Fullscreen")));
    EXPECT_THAT(Problems("{\"m_Type\": \"UnityEditor.ShaderGraph.GraphData\"}"),
                ElementsAre(Mentions("no target for URP")));
    const std::string whole = GraphOfASubGraph().text();
    for (std::size_t size = 0; size <= whole.rfind('}'); size += 37)
    {
        EXPECT_FALSE(Problems(whole.substr(0, size)).empty()) << size;
    }
}

/// An object of a graph of Unity 2019, whose own text stands in a string.
std::string OldObject(const std::string& type, const std::string& json)
{
    std::string text;
    for (const char c : json)
    {
        text += c == '\n'               ? "\\n"
                : c == '"' || c == '\\' ? std::string{'\\', c}
                                        : std::string(1, c);
    }
    return R"({"typeInfo": {"fullName": "UnityEditor.ShaderGraph.)" + type +
           R"("}, "JSONnodeData": ")" + text + "\"}";
}

std::string OldSlot(const std::string& kind, const std::string& id, const std::string& name,
                    const std::string& more = "")
{
    return OldObject(kind + "MaterialSlot", R"({"m_Id": )" + id + R"(, "m_ShaderOutputName": ")" +
                                                name + "\"" + more + "}");
}

TEST_F(ShaderOfAGraph, MayBeOneThatUnity2019HasSaved)
{
    const std::string slots =
        OldSlot("Position", "9", "Vertex Position") + ", " + OldSlot("ColorRGB", "0", "Albedo") +
        ", " + OldSlot("Vector1", "2", "Metallic", R"(, "m_Value": 0.25)") + ", " +
        OldSlot("Vector1", "5", "Smoothness") + ", " + OldSlot("Vector1", "6", "Occlusion") + ", " +
        OldSlot("Vector1", "8", "AlphaClipThreshold", R"(, "m_Value": 0.5)");
    const std::string properties =
        OldObject("ColorShaderProperty", R"({"m_Name": "Tint", "m_DefaultReferenceName": "Color_1",
                  "m_GeneratePropertyBlock": true, "m_Guid": {"m_GuidSerialized": "p"},
                  "m_Value": {"r": 1}})");
    const std::string nodes =
        OldObject("PropertyNode", R"({"m_GuidSerialized": "a", "m_PropertyGuidSerialized": "p",
                  "m_SerializableSlots": [)" +
                                      OldSlot("Vector4", "0", "Out", R"(, "m_SlotType": 1)") +
                                      "]}") +
        ", " +
        OldObject("CustomFunctionNode", R"({"m_GuidSerialized": "f", "m_SourceType": 1,
                  "m_FunctionName": "Foam", "m_SerializableSlots": [)" +
                                            OldSlot("Vector1", "2", "size", R"(, "m_Value": 3)") +
                                            ", " + OldSlot("Texture2DInput", "0", "map") + ", " +
                                            OldSlot("Vector1", "1", "c", R"(, "m_SlotType": 1)") +
                                            "]}") +
        ", " +
        OldObject("SplitNode", R"({"m_GuidSerialized": "s", "m_SerializableSlots": [)" +
                                   OldSlot("DynamicVector", "0", "Input") + ", " +
                                   OldSlot("Vector1", "1", "R", R"(, "m_SlotType": 1)") + "]}") +
        ", " +
        OldObject("PBRMasterNode", R"({"m_GuidSerialized": "m", "m_Model": 1, "m_TwoSided": true,
                  "m_SerializableSlots": [)" +
                                       slots + "]}");
    const std::string edges =
        OldObject("Edge", R"({"m_OutputSlot": {"m_SlotId": 0, "m_NodeGUIDSerialized": "a"},
                  "m_InputSlot": {"m_SlotId": 0, "m_NodeGUIDSerialized": "m"}})") +
        ", " + OldObject("Edge", R"({"m_OutputSlot": {"m_SlotId": 1, "m_NodeGUIDSerialized": "f"},
                  "m_InputSlot": {"m_SlotId": 5, "m_NodeGUIDSerialized": "m"}})") +
        ", " + OldObject("Edge", R"({"m_OutputSlot": {"m_SlotId": 0, "m_NodeGUIDSerialized": "a"},
                  "m_InputSlot": {"m_SlotId": 0, "m_NodeGUIDSerialized": "s"}})") +
        ", " + OldObject("Edge", R"({"m_OutputSlot": {"m_SlotId": 1, "m_NodeGUIDSerialized": "s"},
                  "m_InputSlot": {"m_SlotId": 6, "m_NodeGUIDSerialized": "m"}})");
    EXPECT_THAT(Problems(R"({"m_Path": "Old", "m_SerializedProperties": [)" + properties +
                         R"(], "m_SerializableNodes": [)" + nodes +
                         R"(], "m_SerializableEdges": [)" + edges + "]}"),
                ElementsAre());
    const std::string text = TranslateGraph(m_Folder / "a.shadergraph", [](const std::string&)
                                            { return std::filesystem::path(); })
                                 .shaderLab;
    EXPECT_THAT(text, HasSubstr("Shader \"Old/a\""));
    EXPECT_THAT(text, HasSubstr("Color_1(\"Tint\", Color) = (1, 0, 0, 0)"));
    EXPECT_THAT(text, HasSubstr("surface.BaseColor = Color_1.xyz;"));
    EXPECT_THAT(text, HasSubstr("surface.Metallic = float(0.25);"));
    EXPECT_THAT(text, HasSubstr("void Foam_f(float size, Texture2D map, out float c)"));
    EXPECT_THAT(text, AllOf(HasSubstr("Foam_f(float(3), "), HasSubstr(".tex, ")));
    EXPECT_THAT(text, HasSubstr("limn_Wide(Color_1).x;"));
    EXPECT_THAT(text, HasSubstr("\"Queue\" = \"AlphaTest\"")) << "its threshold is not 0";
    EXPECT_EQ(FirstState(text), "Cull Off Blend Off ZTest LEqual ZWrite On");
}

// Nodes that are connected in a circle, in a chain without end, or with what they do not have.
TEST_F(ShaderOfAGraph, MayBeConnectedInAnyWay)
{
    GraphText circle;
    const std::string a = circle.Node("OneMinus", "0 In DynamicVector, >1 Out DynamicVector");
    const std::string b = circle.Node("Multiply", "0 A DynamicValue, 1 B DynamicValue, >2 Out "
                                                  "DynamicValue");
    circle.Connect(a, 1, b, 0);
    circle.Connect(b, 2, a, 0);
    circle.Connect(b, 9, b, 1);
    circle.Connect(b, 2, circle.Block("SurfaceDescription.BaseColor", "0 C ColorRGB"), 0);
    EXPECT_THAT(Problems(circle.text()), ElementsAre(Mentions("has no output 9")));

    GraphText chain;
    std::string last = chain.Node("OneMinus", "0 In DynamicVector, >1 Out DynamicVector");
    for (int i = 0; i < 2000; ++i)
    {
        const std::string next = chain.Node("OneMinus", "0 In DynamicVector, >1 Out DynamicVector");
        chain.Connect(last, 1, next, 0);
        last = next;
    }
    chain.Connect(last, 1, chain.Block("SurfaceDescription.BaseColor", "0 C ColorRGB"), 0);
    EXPECT_THAT(Problems(chain.text()), ElementsAre(Mentions("behind too many others")));

    GraphText self;
    const std::string sub = self.Node("SubGraph", ">7 Out Vector3", R"("m_SerializedSubGraph":
                  "{\"subGraph\": {\"guid\": \"self\"}}")");
    self.Connect(sub, 7, self.Node("SubGraphOutput", "7 Out Vector3"), 7);
    self.Connect(sub, 7, self.Block("SurfaceDescription.BaseColor", "0 C ColorRGB"), 0);
    Write("self.shadersubgraph", self.text());
    EXPECT_THAT(Problems(self.text()), ElementsAre(Mentions("uses itself")));
}

} // namespace
} // namespace limn::test
