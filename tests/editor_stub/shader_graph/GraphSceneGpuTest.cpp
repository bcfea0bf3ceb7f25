// Shader graphs of a Unity project, drawn.

#include "GraphText.h"
#include "Mentions.h"
#include "unity_scene/GpuTestOfAProject.h"

namespace limn::test
{
namespace
{

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* k_MaterialId = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa";
constexpr const char* k_GraphId = "dddddddddddddddddddddddddddddddd";
constexpr const char* k_PictureId = "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb";
constexpr const char* k_RendererId = "cccccccccccccccccccccccccccccccc";
constexpr const char* k_Yaml = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

/// A project with a quad before an orthographic camera, whose upper half it fills. Its material is
/// of a graph; the sky is blue.
class DrawnGraph : public GpuTestOfAProject
{
protected:
    /// @param saved  the properties of the material
    std::string Draw(const GraphText& graph, const std::string& saved = "")
    {
        Write("Assets/Paint.shadergraph", graph.text(), k_GraphId);
        return DrawWith(
            std::string("{fileID: -6465566751694194690, guid: ") + k_GraphId + ", type: 3}", saved);
    }
    /// @param shader  the reference to it
    std::string DrawWith(const std::string& shader, const std::string& saved)
    {
        WriteAsset("Assets/A.mat",
                   "--- !u!21 &2100000\nMaterial:\n  m_Shader: " + shader +
                       "\n  m_SavedProperties:\n" + saved,
                   k_MaterialId);
        return GpuTestOfAProject::Draw(CameraAt("1", "Camera", 0, "r: 0, g: 0, b: 1, a: 1", "") +
                                       QuadAt("2", 0, 0.5f, 2, 1, m_Materials) + m_Light);
    }

    std::string m_Materials = MaterialLine(k_MaterialId); ///< the quad's materials
    std::string m_Light;                                  ///< a light of the scene
};

constexpr const char* k_ColorBlock = "SurfaceDescription.BaseColor";

TEST_F(DrawnGraph, HasTheValuesOfTheMaterial)
{
    GraphText graph;
    const std::string tint = graph.Property(
        "Color", "_Tint", R"("m_Value": {"r": 1, "g": 0, "b": 0, "a": 1})", "Vector4");
    graph.Connect(tint, 0, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    EXPECT_THAT(Draw(graph), Not(HasSubstr("graph")));
    EXPECT_EQ(Pixel(8, 12), "255 0 0") << "the graph's own colour";
    EXPECT_EQ(Pixel(8, 4), "0 0 255") << "the sky";
    Draw(graph, "    m_Colors:\n    - _Tint: {r: 0, g: 1, b: 0, a: 1}\n");
    EXPECT_EQ(Pixel(8, 12), "0 255 0");
}

TEST_F(DrawnGraph, SeesCoordinatesAsUnityDoes)
{
    GraphText graph;
    const std::string uv = graph.Node("UV", ">0 Out Vector4");
    const std::string step = graph.Node("Step", "0 Edge DynamicVector = {\"x\": 0.5, \"y\": 0.5}, "
                                                "1 In DynamicVector, >2 Out DynamicVector");
    const std::string halves =
        graph.Node("Swizzle", "0 In DynamicVector, >1 Out Vector3", R"("_maskInput": "xyw")");
    graph.Connect(uv, 0, halves, 0);
    graph.Connect(halves, 1, step, 1);
    const std::string mask = graph.Node("ChannelMask", "0 In DynamicVector, >1 Out DynamicVector",
                                        R"("m_ChannelMask": 3)");
    graph.Connect(step, 2, mask, 0);
    graph.Connect(mask, 1, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    Draw(graph);
    EXPECT_EQ(Pixel(2, 9), "0 0 0") << "u grows to the right, v upwards";
    EXPECT_EQ(Pixel(13, 9), "255 0 0");
    EXPECT_EQ(Pixel(2, 14), "0 255 0");
    EXPECT_EQ(Pixel(13, 14), "255 255 0");
}

TEST_F(DrawnGraph, MovesVertices)
{
    GraphText graph;
    const std::string place = graph.Node("Position", ">0 Out Vector3", R"("m_Space": 2)");
    const std::string down = graph.Node("Subtract", "0 A DynamicVector, 1 B DynamicVector = "
                                                    "{\"y\": 1}, >2 Out DynamicVector");
    const std::string local =
        graph.Node("Transform", "0 In Vector3, >1 Out Vector3",
                   R"("m_Conversion": {"from": 2, "to": 0}, "m_ConversionType": 0)");
    graph.Connect(place, 0, down, 0);
    graph.Connect(down, 2, local, 0);
    graph.Connect(local, 1, graph.Block("VertexDescription.Position", "0 Position Position"), 0);
    graph.Block("VertexDescription.Normal", "0 Normal Normal");
    graph.Block("VertexDescription.Tangent", "0 Tangent Tangent");
    graph.Block(k_ColorBlock, R"(0 BaseColor ColorRGB = {"x": 1})");
    Draw(graph);
    EXPECT_EQ(Pixel(8, 12), "0 0 255") << "it has left the upper half";
    EXPECT_EQ(Pixel(8, 4), "255 0 0");
}

TEST_F(DrawnGraph, CutsAndBlendsAsItsTargetIsSet)
{
    GraphText cut("Unlit", R"("m_AlphaClip": true)");
    const std::string uv = cut.Node("UV", ">0 Out Vector4");
    const std::string u = cut.Node("Split", "0 In DynamicVector, >1 R Vector1");
    cut.Connect(uv, 0, u, 0);
    cut.Connect(u, 1, cut.Block("SurfaceDescription.Alpha", "0 Alpha Vector1"), 0);
    cut.Block("SurfaceDescription.AlphaClipThreshold", "0 Threshold Vector1 = 0.5");
    cut.Block(k_ColorBlock, R"(0 BaseColor ColorRGB = {"x": 1})");
    Draw(cut);
    EXPECT_EQ(Pixel(2, 12), "0 0 255");
    EXPECT_EQ(Pixel(13, 12), "255 0 0");

    GraphText added("Unlit", R"("m_SurfaceType": 1, "m_AlphaMode": 2)");
    added.Block("SurfaceDescription.Alpha", "0 Alpha Vector1 = 1");
    added.Block(k_ColorBlock, R"(0 BaseColor ColorRGB = {"x": 1})");
    Draw(added);
    EXPECT_EQ(Pixel(8, 12), "255 0 255");
}

TEST_F(DrawnGraph, HasTheTexturesThatStandInIt)
{
    Image image{1, 1, GraphicsFormat::R8G8B8A8_SRGB, {}};
    for (const int channel : {0, 255, 0, 255})
    {
        image.texels.push_back(static_cast<std::byte>(channel));
    }
    m_Folder.Write("Assets/green.png.meta", std::string("guid: ") + k_PictureId + "\n");
    WritePng(m_Folder / "Assets/green.png", image);
    GraphText graph;
    const std::string asset = graph.Node("Texture2DAsset", ">0 Out Texture2D",
                                         std::string(R"("m_Texture": {"m_SerializedTexture":
                   "{\"texture\": {\"fileID\": 2800000, \"guid\": \")") +
                                             k_PictureId + R"(\", \"type\": 3}}"})");
    const std::string sample =
        graph.Node("SampleTexture2D", "1 Texture Texture2DInput, 2 UV UV, 3 Sampler "
                                      "SamplerState, >0 RGBA Vector4");
    graph.Connect(asset, 0, sample, 1);
    graph.Connect(sample, 0, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    EXPECT_THAT(Draw(graph), Not(HasSubstr("texture")));
    EXPECT_EQ(Pixel(8, 12), "0 255 0");
}

// Each shape is as wide and high as half of the quad.
TEST_F(DrawnGraph, HasShapes)
{
    m_Size = "128"; // their borders are a pixel soft
    for (const auto& [type, slots] :
         {std::pair("Ellipse", "0 UV UV, 2 Width Vector1 = 0.5, 3 Height Vector1 = 0.5, >4 Out "
                               "Vector1"),
          std::pair("Rectangle", "0 UV UV, 1 Width Vector1 = 0.5, 2 Height Vector1 = 0.5, >4 Out "
                                 "Vector1"),
          std::pair("RoundedRectangle", "0 UV UV, 1 Width Vector1 = 0.5, 2 Height Vector1 = 0.5, "
                                        "3 Radius Vector1 = 0.1, >4 Out Vector1"),
          std::pair("Polygon", "0 UV UV, 1 Sides Vector1 = 6, 2 Width Vector1 = 0.5, 3 Height "
                               "Vector1 = 0.5, >4 Out Vector1")})
    {
        SCOPED_TRACE(type);
        GraphText graph;
        const std::string shape = graph.Node(type, slots);
        graph.Connect(shape, 4, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
        Draw(graph);
        EXPECT_EQ(Pixel(64, 96), "255 255 255");
        EXPECT_EQ(Pixel(50, 90), "255 255 255");
        EXPECT_EQ(Pixel(2, 96), "0 0 0");
        EXPECT_EQ(Pixel(64, 66), "0 0 0");
        EXPECT_EQ(Pixel(126, 126), "0 0 0");
    }
}

/// A graph whose colour goes from one key, at a quarter of its width, to the other at three
/// quarters.
GraphText GraphOfAGradient(const std::string& mode, const std::string& from, const std::string& to)
{
    GraphText graph;
    const std::string gradient =
        graph.Node("Gradient", ">0 Out Gradient",
                   R"("m_SerializableMode": )" + mode + R"(, "m_SerializableColorKeys": [{)" +
                       from + R"(, "w": 0.25}, {)" + to +
                       R"(, "w": 0.75}], "m_SerializableAlphaKeys": [{"x": 1, "y": 0}])");
    const std::string time = graph.Node("Split", "0 In DynamicVector, >1 R Vector1");
    graph.Connect(graph.Node("UV", ">0 Out Vector4"), 0, time, 0);
    const std::string sample =
        graph.Node("SampleGradient", "0 Gradient GradientInput, 1 Time Vector1, >2 Out Vector4");
    graph.Connect(gradient, 0, sample, 0);
    graph.Connect(time, 1, sample, 1);
    graph.Connect(sample, 2, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    return graph;
}

TEST_F(DrawnGraph, HasGradients)
{
    Draw(GraphOfAGradient("0", R"("x": 1, "y": 0, "z": 0)", R"("x": 0, "y": 0, "z": 1)"));
    EXPECT_EQ(Pixel(2, 12), "255 0 0") << "before the first key";
    EXPECT_EQ(Pixel(13, 12), "0 0 255") << "behind the last";
    // At 13/32, 5/16 of the way: 11/16 of red and 5/16 of blue, in linear light.
    EXPECT_EQ(Pixel(6, 12), "216 0 152");

    const std::string black = R"("x": 0, "y": 0, "z": 0)";
    const std::string white = R"("x": 1, "y": 1, "z": 1)";
    Draw(GraphOfAGradient("1", black, white));
    EXPECT_EQ(Pixel(6, 12), "255 255 255") << "the next key's";
    // Oklab's lightness of a grey is the cube root of its light: 5/16 is 0.0305, or 49 of 255.
    Draw(GraphOfAGradient("2", black, white));
    EXPECT_EQ(Pixel(6, 12), "49 49 49");
}

TEST_F(DrawnGraph, HasChecks)
{
    GraphText checks;
    const std::string board = checks.Node(
        "Checkerboard", R"(0 UV UV, 1 ColorA ColorRGB = {"x": 1}, 2 ColorB ColorRGB = {"z": 1},
        3 Frequency Vector2 = {"x": 2, "y": 1}, >4 Out Vector3)");
    checks.Connect(board, 4, checks.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    Draw(checks);
    EXPECT_EQ(Pixel(1, 9), Pixel(9, 9)) << "it repeats after half of the quad";
    EXPECT_EQ(Pixel(1, 9), Pixel(5, 13)) << "and is shifted in the next row";
    EXPECT_NE(Pixel(1, 9), Pixel(5, 9));
    EXPECT_NE(Pixel(1, 9), Pixel(1, 13));
}

TEST_F(DrawnGraph, FollowsAKeywordOfTheMaterial)
{
    GraphText graph;
    graph.Keyword("WET", R"("m_KeywordType": 0, "m_KeywordDefinition": 0, "m_Value": 0)");
    const std::string chosen =
        graph.Node("Keyword", ">0 Out DynamicVector, 1 On DynamicVector, 2 Off DynamicVector",
                   R"("m_Keyword": {"m_Id": "keywordWET"})");
    const std::string red = "1 X Vector1 = 1, 2 Y Vector1 = 0, 3 Z Vector1 = 0, >0 Out Vector3";
    graph.Connect(graph.Node("Vector3", red), 0, chosen, 1);
    const std::string green = "1 X Vector1 = 0, 2 Y Vector1 = 1, 3 Z Vector1 = 0, >0 Out Vector3";
    graph.Connect(graph.Node("Vector3", green), 0, chosen, 2);
    graph.Connect(chosen, 0, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    Draw(graph, "    m_Colors: []\n");
    EXPECT_EQ(Pixel(8, 12), "0 255 0");
    Draw(graph, "    m_Colors: []\n  m_ValidKeywords:\n  - WET\n");
    EXPECT_EQ(Pixel(8, 12), "255 0 0");
}

// The picture that URP's own Lit gives with the same values, by sun and sky.
TEST_F(DrawnGraph, IsLitAsUrpsLitIs)
{
    m_Light = R"(--- !u!1 &8
GameObject: {m_Name: Sun, m_IsActive: 1}
--- !u!4 &9
Transform:
  m_GameObject: {fileID: 8}
  m_LocalRotation: {x: 0.35, y: 0.2, z: 0, w: 0.9}
--- !u!108 &10
Light:
  m_GameObject: {fileID: 8}
  m_Type: 1
  m_Color: {r: 1, g: 0.9, b: 0.8, a: 1}
  m_Intensity: 1.5
)";
    GraphText graph("Lit", "", R"("m_WorkflowMode": 1)");
    graph.Block(k_ColorBlock, R"(0 BaseColor ColorRGB = {"x": 0.8, "y": 0.4, "z": 0.2})");
    graph.Block("SurfaceDescription.Metallic", "0 Metallic Vector1 = 0.25");
    graph.Block("SurfaceDescription.Smoothness", "0 Smoothness Vector1 = 0.6");
    graph.Block("SurfaceDescription.Occlusion", "0 Occlusion Vector1 = 1");
    const std::string glow = graph.Node(
        "Vector3", "1 X Vector1 = 0, 2 Y Vector1 = 0.1, 3 Z Vector1 = 0, >0 Out Vector3");
    graph.Connect(glow, 0, graph.Block("SurfaceDescription.Emission", "0 Emission ColorRGB"), 0);
    Draw(graph);
    const Image drawn = m_Picture;
    DrawWith(
        "{fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, type: 3}",
        "    m_Floats:\n    - _Metallic: 0.25\n    - _Smoothness: 0.6\n    m_Colors:\n"
        "    - _BaseColor: {r: 0.8, g: 0.4, b: 0.2, a: 1}\n"
        "    - _EmissionColor: {r: 0, g: 0.1, b: 0, a: 1}\n  m_ValidKeywords:\n  - _EMISSION\n");
    EXPECT_NE(Pixel(8, 12), Pixel(8, 4));
    for (std::size_t i = 0; i < drawn.texels.size(); ++i)
    {
        EXPECT_NEAR(std::to_integer<int>(drawn.texels[i]),
                    std::to_integer<int>(m_Picture.texels[i]), 1)
            << i;
    }
}

// The graph turns round what the camera has drawn where the scene is near.
TEST_F(DrawnGraph, DrawsOverTheWholeScreen)
{
    const auto asset = [](const std::string& guid)
    {
        return "{fileID: 11400000, guid: " + guid + ", type: 2}";
    };
    m_Folder.Write("ProjectSettings/GraphicsSettings.asset",
                   std::string(k_Yaml) +
                       "--- !u!30 &1\nGraphicsSettings:\n  m_CustomRenderPipeline: " +
                       asset(k_PictureId) + "\n");
    WriteAsset("Assets/P.asset",
               "--- !u!114 &11400000\nMonoBehaviour:\n  m_MSAA: 1\n"
               "  m_RequireDepthTexture: 1\n  m_RendererDataList:\n  - " +
                   asset(k_RendererId) + "\n  m_DefaultRendererIndex: 0\n",
               k_PictureId);
    WriteAsset(
        "Assets/R.asset",
        "--- !u!114 &5\nMonoBehaviour:\n  m_Script: {fileID: 11500000, guid: "
        "b00045f12942b46c698459096c89274e, type: 3}\n  m_Name: Whole\n  m_Active: 1\n"
        "  injectionPoint: 550\n  fetchColorBuffer: 1\n  requirements: 1\n"
        "  passMaterial: {fileID: 2100000, guid: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa, type: 2}\n"
        "--- !u!114 &11400000\nMonoBehaviour:\n  m_Name: R\n  m_RendererFeatures:\n"
        "  - {fileID: 5}\n",
        k_RendererId);
    m_Materials = "  - {fileID: 0}\n"; // the quad has no material of its own: it is magenta
    GraphText graph("Fullscreen");
    const std::string source =
        graph.Node("UniversalSampleBuffer", "0 UV ScreenPosition, >2 Output ColorRGBA",
                   R"("m_BufferType": 2)");
    const std::string depth = graph.Node("SceneDepth", "0 UV ScreenPosition, >1 Out Vector1",
                                         R"("m_DepthSamplingMode": 2)");
    const std::string compare = graph.Node("Comparison",
                                           "0 A Vector1, 1 B Vector1 = 10, >2 Out "
                                           "Boolean",
                                           R"("m_ComparisonType": 2)");
    const std::string branch =
        graph.Node("Branch", "0 Predicate Boolean, 1 True DynamicVector, 2 False "
                             "DynamicVector, >3 Out DynamicVector");
    const std::string inverse = graph.Node("OneMinus", "0 In DynamicVector, >1 Out DynamicVector");
    graph.Connect(depth, 1, compare, 0);
    graph.Connect(compare, 2, branch, 0);
    graph.Connect(source, 2, inverse, 0);
    graph.Connect(inverse, 1, branch, 1);
    graph.Connect(source, 2, branch, 2);
    graph.Connect(branch, 3, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    Draw(graph);
    EXPECT_EQ(Pixel(8, 12), "0 255 0") << "the quad is near: magenta turned round";
    EXPECT_EQ(Pixel(8, 4), "0 0 255") << "the sky is far";
}

TEST_F(DrawnGraph, ThatCannotBeTranslatedSaysWhy)
{
    GraphText graph;
    const std::string strange = graph.Node("Hologram", ">0 Out Vector1");
    graph.Connect(strange, 0, graph.Block(k_ColorBlock, "0 BaseColor ColorRGB"), 0);
    const std::string said = Draw(graph);
    EXPECT_THAT(said, Mentions("Paint.shadergraph", "Hologram", "unknown to limn"));
    EXPECT_THAT(said, Mentions("A.mat", "Paint.shadergraph", "cannot translate", "Lit is used"));
}

} // namespace
} // namespace limn::test
