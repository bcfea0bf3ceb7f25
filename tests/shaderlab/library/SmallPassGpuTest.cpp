#include "library/Formulas.h"
#include "library/FunctionGrid.h"
#include "library/Lights.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// Vertex functions that hand on a place and little else, sprites, and what a shader graph's
// vertices and fragments hold.

namespace limn::test::small
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using SmallPasses = GpuTest;

const dvec3 k_Camera(1, 2, 6);
const dvec3 k_Albedo(0.8, 0.4, 0.1);
const std::vector<dvec3> k_Places = {{0, 0, 0}, {1, 1, 1}, {-2, 0, 5}};

std::string Include(const std::string& file)
{
    return "#include \"Packages/com.unity.render-pipelines.universal/" + file + ".hlsl\"\n";
}

/// An object where it was modelled, seen in world space, before Lights.h's sky and sun.
void SetScene(FunctionGrid& grid)
{
    const std::vector<float> identity = Floats(glm::mat4(1));
    std::ranges::copy(identity, grid.perDraw.objectToWorld);
    std::ranges::copy(identity, grid.perDraw.worldToObject);
    grid.perDraw.worldTransformParams[3] = 1;
    grid.SetGlobal("unity_MatrixVP", identity);
    grid.SetGlobal("unity_MatrixV", identity);
    grid.SetGlobal("_WorldSpaceCameraPos", Floats4(k_Camera, 1));
    grid.SetGlobal("limn_CameraPos", Floats4(k_Camera, 1));
    grid.SetGlobal("_ScaledScreenParams", {8, 4, 1.125f, 1.25f});
    grid.SetGlobal("_ScaleBiasRt", {-1, 1, -1, 1});
    grid.SetGlobal("_ProjectionParams", {-1, 0.5f, 100, 0.01f});
    grid.SetGlobal("_BaseMap_ST", {2, 4, 0.5f, -1});
    SetLights(grid);
}
std::shared_ptr<const Texture2D> OneTexel(const glm::vec4& texel)
{
    return MakeTexture(1, 1, [=](int, int) { return texel; });
}
dvec2 Tiled(const dvec4& uv)
{
    return {2 * uv.x + 0.5, 4 * uv.y - 1};
}
Values Placed(const dvec4& a, const dvec4&, const dvec4&)
{
    return dvec4(dvec3(a), 1);
}

} // namespace

TEST_F(SmallPasses, DepthAndShadowsArePlacedAndTiled)
{
    const auto inputs = CombineVectors(k_Places);
    FunctionGrid depth("#define _ALPHATEST_ON\n" + Include("Shaders/LitInput") +
                       Include("Shaders/DepthOnlyPass") + R"(
        Varyings At(float3 place)
        {
            Attributes v = (Attributes)0;
            v.position = float4(place, 1);
            v.texcoord = place.xy;
            return DepthOnlyVertex(v);
        })");
    FunctionGrid shadow("#define _ALPHATEST_ON\n" + Include("Shaders/LitInput") +
                        Include("Shaders/ShadowCasterPass") + R"(
        Varyings At(float3 place)
        {
            Attributes v = (Attributes)0;
            v.positionOS = float4(place * float3(1, 1, 0), 1); // behind the near plane
            v.normalOS = float3(0, 0, 1);
            v.texcoord = place.xy;
            return ShadowPassVertex(v);
        })");
    for (FunctionGrid* grid : {&depth, &shadow})
    {
        SetScene(*grid);
        grid->Add("At(a.xyz).uv", inputs, [](auto& a, auto&, auto&) { return Tiled(a); });
        grid->Add("At(a.xyz).positionCS.xyw", inputs,
                  [](auto& a, auto&, auto&) { return dvec3(a.x, a.y, 1); });
    }
    depth.Run();
    shadow.Run();
}

TEST_F(SmallPasses, BakersGetWhatSurfacesScatterAndGive)
{
    FunctionGrid lit("#define _EMISSION\n" + Include("Shaders/LitInput") +
                     Include("Shaders/LitMetaPass") + R"(
        Varyings At(float4 uv)
        {
            Attributes v = (Attributes)0;
            v.uv0 = uv.xy;
            v.uv1 = uv.zw;
            return UniversalVertexMeta(v);
        })");
    SetScene(lit);
    lit.SetGlobal("_BaseMap_ST", {2, 4, 0.5f, -1});
    lit.SetGlobal("unity_MetaFragmentControl", {1, 0, 0, 0});
    lit.SetGlobal("unity_OneOverOutputBoost", {1});
    lit.SetGlobal("unity_MaxOutputValue", {10});
    lit.SetGlobal("_BaseColor", {0.8f, 0.4f, 0.1f, 1});
    lit.SetGlobal("_Metallic", {0.25f});
    lit.SetGlobal("_Smoothness", {0.5f});
    const auto inputs = CombineVectors(Colors());
    lit.Add("At(a).uv", inputs,
            [](auto& a, auto&, auto&) { return dvec2(2 * a.x + 0.5, 4 * a.y - 1); });
    lit.Add("UniversalFragmentMetaLit(At(a))", inputs,
            [](auto&, auto&, auto&)
            {
                const dvec3 specular = glm::mix(dvec3(0.04), k_Albedo, 0.25);
                return dvec4(k_Albedo * (0.96 * 0.75) + specular * (0.25 / 2), 1);
            });
    lit.Run();
    for (const char* kind : {"Unlit", "BakedLit"})
    {
        FunctionGrid flat(Include("Shaders/" + std::string(kind) + "Input") +
                          Include("Shaders/" + std::string(kind) + "MetaPass"));
        flat.SetTexture("_BaseMap", OneTexel({0.5f, 0.25f, 1, 0.5f}));
        flat.SetGlobal("_BaseColor", {0.8f, 0.5f, 0.25f, 0.5f});
        flat.SetGlobal("unity_MetaFragmentControl", {1, 0, 0, 0});
        flat.SetGlobal("unity_OneOverOutputBoost", {1});
        flat.SetGlobal("unity_MaxOutputValue", {10});
        flat.Add("UniversalFragmentMeta" + std::string(kind) + "((Varyings)0) + 0 * a",
                 Combine({0.0}), [](auto&, auto&, auto&) { return dvec4(0.4, 0.125, 0.25, 1); });
        flat.Run();
    }
}

TEST_F(SmallPasses, TheWholeTargetIsCovered)
{
    FunctionGrid grid("#define _USE_DRAW_PROCEDURAL 1\n" + Include("Shaders/Utils/Fullscreen") + R"(
        Varyings Corner(float index)
        {
            Attributes v = (Attributes)0;
            v.vertexID = uint(index);
            return FullscreenVert(v);
        })");
    grid.SetGlobal("_ScaleBias", {1, 1, 0, 0});
    // Whichever way the corners go: what is seen at a place of the target is that place of the
    // picture. y of clip space points up, v down.
    grid.Add("Corner(a.x).positionCS.xy + (0.5 - Corner(a.x).uv) * float2(2, -2)",
             Combine({0.0, 1.0, 2.0, 3.0}), [](auto&, auto&, auto&) { return dvec2(0); });
    grid.Add("abs(Corner(a.x).positionCS.xyw)", Combine({0.0, 1.0, 2.0, 3.0}),
             [](auto&, auto&, auto&) { return dvec3(1); });
    grid.Add("abs(Corner(a.x).uv * 2 - 1)", Combine({0.0, 1.0, 2.0, 3.0}),
             [](auto&, auto&, auto&) { return dvec2(1); });
    grid.Run();
}

TEST_F(SmallPasses, SpritesAreMaskedAndLit)
{
    FunctionGrid mask(Include("ShaderLibrary/Core") +
                      Include("Shaders/2D/Include/SpriteMaskShared") +
                      Include("Shaders/2D/Include/SurfaceData2D") + R"(
        Varyings At(float3 place)
        {
            Attributes v = (Attributes)0;
            v.positionOS = float4(place, 1);
            v.texcoord = place.xy;
            return MaskRenderingVertex(v);
        }
        SurfaceData2D Surface(float4 a, float4 b, float3 n)
        {
            SurfaceData2D s;
            InitializeSurfaceData(a.rgb, a.a, b, n, s);
            return s;
        })");
    SetScene(mask);
    const auto inputs = CombineVectors(k_Places, Colors(), UnitVectors());
    mask.Add("At(a.xyz).positionCS", inputs, Placed);
    mask.Add("At(a.xyz).uv", inputs, [](auto& a, auto&, auto&) { return dvec2(a); });
    mask.Add("float4(Surface(a, b, c.xyz).albedo, Surface(a, b, c.xyz).alpha)", inputs,
             [](auto& a, auto&, auto&) { return a; });
    mask.Add("Surface(a, b, c.xyz).mask", inputs, [](auto&, auto& b, auto&) { return b; });
    mask.Add("Surface(a, b, c.xyz).normalTS", inputs,
             [](auto&, auto&, auto& c) { return dvec3(c); });
    mask.Run();
}

TEST_F(SmallPasses, ChosenParticlesAreDrawnAgain)
{
    for (const bool hasFrames : {false, true})
    {
        FunctionGrid grid((hasFrames ? "#define _FLIPBOOKBLENDING_ON\n" : "") +
                          Include("Shaders/Particles/ParticlesLitInput") +
                          Include("Shaders/Particles/ParticlesEditorPass") + R"(
            VaryingsParticle At(float3 place)
            {
                AttributesParticle v = (AttributesParticle)0;
                v.positionOS = float4(place, 1);
                v.color = float4(place, 0.5);
                v.texcoords.xy = place.yz;
                return vertParticleEditor(v);
            })");
        SetScene(grid);
        const auto inputs = CombineVectors(k_Places);
        grid.Add("At(a.xyz).clipPos", inputs, Placed);
        grid.Add("At(a.xyz).color", inputs,
                 [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 0.5); });
        grid.Add("At(a.xyz).texcoord", inputs,
                 [](auto& a, auto&, auto&) { return dvec2(a.y, a.z); });
        grid.Run();
    }
}

TEST_F(SmallPasses, SpeedTrees8HandOnTheirColor)
{
    const std::string helper = R"(
        SpeedTreeVertexInput At(float3 place, float3 normal)
        {
            SpeedTreeVertexInput v = (SpeedTreeVertexInput)0;
            v.vertex = float4(place, 1);
            v.normal = normal;
            v.tangent = float4(normal.zxy, 1);
            v.texcoord = float4(place.xy, 0, 0);
            v.color = float4(normal, 0.5);
            return v;
        }
    )";
    FunctionGrid grid(Include("Shaders/Nature/SpeedTree8Input") +
                      Include("Shaders/Nature/SpeedTree8Passes") + helper);
    SetScene(grid);
    const auto inputs = CombineVectors(k_Places, UnitVectors());
    for (const char* vertex :
         {"SpeedTree8Vert", "SpeedTree8VertDepth", "SpeedTree8VertDepthNormal"})
    {
        const std::string call = std::string(vertex) + "(At(a.xyz, b.xyz))";
        grid.Add(call + ".uv", inputs, [](auto& a, auto&, auto&) { return dvec2(a); });
        grid.Add(call + ".color", inputs,
                 [](auto&, auto& b, auto&) { return dvec4(dvec3(b), 0.5); });
        grid.Add(call + ".clipPos", inputs, Placed);
    }
    grid.Run();
}

TEST_F(SmallPasses, TexturesOfGraphsKeepTheirNumbers)
{
    FunctionGrid grid(CoreInclude("Texture") + R"(
        TEXTURE2D(_Map); SAMPLER(sampler_Map); float4 _Map_TexelSize, _Map_ST;
        float4 Of(float2 uv)
        {
            UnityTexture2D map = UnityBuildTexture2DStruct(_Map);
            return float4(map.GetTransformedUV(uv), map.texelSize.zw);
        }
        float4 Color(float2 uv)
        {
            UnityTexture2D map = UnityBuildTexture2DStruct(_Map);
            return map.tex.Sample(map.samplerstate, uv);
        })");
    grid.SetGlobal("_Map_ST", {2, 4, 0.5f, -1});
    grid.SetGlobal("_Map_TexelSize", {0.25f, 0.5f, 4, 2});
    grid.SetTexture("_Map",
                    MakeTexture(1, 1, [](int, int) { return glm::vec4(0.25f, 0.5f, 1, 0); }));
    const auto inputs = CombineVectors(k_Places);
    grid.Add("Of(a.xy)", inputs, [](auto& a, auto&, auto&) { return dvec4(Tiled(a), 4, 2); });
    grid.Add("Color(a.xy)", inputs, [](auto&, auto&, auto&) { return dvec4(0.25, 0.5, 1, 0); });
    grid.Run();
}

TEST_F(SmallPasses, GraphsMoveVerticesAndKnowWhereFragmentsAre)
{
    FunctionGrid grid(R"(
        #define ATTRIBUTES_NEED_NORMAL
        #define ATTRIBUTES_NEED_TANGENT
        #define VARYINGS_NEED_POSITION_WS
        #define VARYINGS_NEED_NORMAL_WS
        #define VARYINGS_NEED_TANGENT_WS
        #define VARYINGS_NEED_VIEWDIRECTION_WS
        #define VARYINGS_NEED_TEXCOORD0
        #define VARYINGS_NEED_TEXCOORD1
        #define VARYINGS_NEED_TEXCOORD2
        #define VARYINGS_NEED_TEXCOORD3
        #define VARYINGS_NEED_COLOR
        #define VARYINGS_NEED_SCREENPOSITION
        #define VARYINGS_NEED_FOG_AND_VERTEX_LIGHT
        #define FEATURES_GRAPH_VERTEX
        #define _NORMALMAP 1
        #define _NORMAL_DROPOFF_TS 1
        #define CUSTOMINTERPOLATOR_VARYPASSTHROUGH_FUNC
        #define SHADERPASS SHADERPASS_FORWARD
)" + Include("ShaderLibrary/Core") +
                      Include("ShaderLibrary/Lighting") +
                      Include("ShaderLibrary/ShaderGraphFunctions") +
                      Include("Editor/ShaderGraph/Includes/ShaderPass") + R"(
        struct Attributes { float3 positionOS; float3 normalOS; float4 tangentOS; float4 uv0; float4 uv1;
                            float4 uv2; float4 uv3; float4 color; };
        struct Varyings { float4 positionCS; float3 positionWS; float3 normalWS; float4 tangentWS;
                          float3 viewDirectionWS; float4 texCoord0; float4 texCoord1; float4 texCoord2;
                          float4 texCoord3; float4 color; float4 screenPosition; float3 sh;
                          float4 fogFactorAndVertexLight; float custom; };
        struct VertexDescription { float3 Position; float3 Normal; float3 Tangent; float Custom; };
        struct SurfaceDescription { float3 BaseColor; float3 NormalTS; float3 Emission; float Metallic;
                                    float Smoothness; float Occlusion; float Alpha;
                                    float AlphaClipThreshold; };
        #define VertexDescriptionInputs Attributes
        #define SurfaceDescriptionInputs Varyings
        #define PackedVaryings Varyings
        Varyings PackVaryings(Varyings v) { return v; }
        Varyings UnpackVaryings(Varyings v) { return v; }
        Attributes BuildVertexDescriptionInputs(Attributes v) { return v; }
        Varyings BuildSurfaceDescriptionInputs(Varyings v) { return v; }
        VertexDescription VertexDescriptionFunction(Attributes v)
        {
            VertexDescription d;
            d.Position = v.positionOS * 2;
            d.Normal = v.normalOS.yzx;
            d.Tangent = v.tangentOS.zxy;
            d.Custom = 0.25;
            return d;
        }
        SurfaceDescription SurfaceDescriptionFunction(Varyings v) { return (SurfaceDescription)0; }
        void CustomInterpolatorPassThroughFunc(inout Varyings v, VertexDescription d)
        {
            v.custom = d.Custom;
        }
)" + Include("Editor/ShaderGraph/Includes/Varyings") +
                      "#include \"limn/GraphLit.hlsl\"\n" + R"(
        Varyings At(float3 place, float3 normal)
        {
            Attributes v = (Attributes)0;
            v.positionOS = place;
            v.normalOS = normal;
            v.tangentOS = float4(normal, -1);
            v.uv0 = 10; v.uv1 = 11; v.uv2 = 12; v.uv3 = 13; v.color = 14;
            return BuildVaryings(v);
        }
        InputData Data(float3 place, float3 normal)
        {
            Varyings v = At(place, normal);
            v.positionCS = float4(2, 3, 0.5, 1);
            v.tangentWS = float4(normal.zxy, 1);
            v.normalWS = normal;
            v.fogFactorAndVertexLight = float4(0.625, place);
            SurfaceDescription s = (SurfaceDescription)0;
            s.NormalTS = float3(0, 0, 1);
            return limn_GraphInputData(v, s);
        })");
    SetScene(grid);
    const auto inputs = CombineVectors(k_Places, UnitVectors());
    grid.Add("At(a.xyz, b.xyz).positionCS", inputs,
             [](auto& a, auto&, auto&) { return dvec4(2.0 * dvec3(a), 1); });
    grid.Add("At(a.xyz, b.xyz).normalWS", inputs,
             [](auto&, auto& b, auto&) { return dvec3(b.y, b.z, b.x); });
    grid.Add("At(a.xyz, b.xyz).tangentWS", inputs,
             [](auto&, auto& b, auto&) { return dvec4(b.z, b.x, b.y, -1); });
    grid.Add("At(a.xyz, b.xyz).viewDirectionWS", inputs,
             [](auto& a, auto&, auto&) { return k_Camera - 2.0 * dvec3(a); });
    grid.Add("float4(At(a.xyz, b.xyz).texCoord0.x, At(a.xyz, b.xyz).texCoord1.y, "
             "At(a.xyz, b.xyz).texCoord2.z, At(a.xyz, b.xyz).texCoord3.w)",
             inputs, [](auto&, auto&, auto&) { return dvec4(10, 11, 12, 13); });
    grid.Add("float2(At(a.xyz, b.xyz).color.x, At(a.xyz, b.xyz).custom)", inputs,
             [](auto&, auto&, auto&) { return dvec2(14, 0.25); });
    grid.Add("At(a.xyz, b.xyz).screenPosition", inputs,
             [](auto& a, auto&, auto&) { return dvec4(a.x + 0.5, 0.5 - a.y, 2 * a.z, 1); });
    grid.Add("Data(a.xyz, b.xyz).positionWS - Data(a.xyz, b.xyz).vertexLighting", inputs,
             [](auto& a, auto&, auto&) { return dvec3(a); });
    grid.Add("Data(a.xyz, b.xyz).normalWS", inputs, [](auto&, auto& b, auto&) { return dvec3(b); });
    grid.Add("Data(a.xyz, b.xyz).viewDirectionWS", inputs,
             [](auto& a, auto&, auto&) { return glm::normalize(k_Camera - 2.0 * dvec3(a)); });
    grid.Add("Data(a.xyz, b.xyz).bakedGI", inputs, [](auto&, auto&, auto&) { return k_Sky; });
    grid.Add("float4(Data(a.xyz, b.xyz).normalizedScreenSpaceUV, Data(a.xyz, b.xyz).fogCoord, "
             "Data(a.xyz, b.xyz).shadowMask.w)",
             inputs, [](auto&, auto&, auto&) { return dvec4(0.25, 0.75, 0.625, 1); });
    grid.Run();
}

} // namespace limn::test::small
