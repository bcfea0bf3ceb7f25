#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using TerrainFunctions = GpuTest;

/// Bayer's matrix of 2^order rows by its definition: four copies of the one before, four times as
/// large, and 0, 2, 3, 1 added.
int Bayer(int order, int x, int y)
{
    if (order == 0)
    {
        return 0;
    }
    const int half = 1 << (order - 1);
    const int added[2][2] = {{0, 2}, {3, 1}};
    return 4 * Bayer(order - 1, x % half, y % half) + added[y / half][x / half];
}

TEST_F(TerrainFunctions, TreesAreDitheredByBayersMatrix)
{
    FunctionGrid grid("#include \"UnityBuiltin3xTreeLibrary.cginc\"\n", ProgramLanguage::Cg);
    std::vector<GridInput> pixels;
    for (int y = 0; y < 8; ++y)
    {
        for (int x = 0; x < 8; ++x)
        {
            pixels.push_back({dvec4(x + 16.5, y + 8.5, 0, 0), dvec4(0.125 * x, 0, 0, 0)});
        }
    }
    grid.Add("ScreenDitherToAlpha(a.x, a.y, b.x)", pixels,
             [](auto& a, auto& b, auto&)
             {
                 const double limit = (Bayer(3, int(a.x) % 8, int(a.y) % 8) + 11) / 64.0;
                 return limit * b.x * (1 - b.x) + b.x;
             });
    grid.SetGlobal("_ScreenParams", {40, 30, 1, 1});
    grid.Add("ComputeAlphaCoverage(a, 0.25)",
             {{dvec4(1.03, 1.03, 0, 2)}, {dvec4(0.31, 0.72, 0, 1)}, {dvec4(0.92, 0.1, 0, 4)}},
             [](auto& a, auto&, auto&)
             {
                 const int x = int(a.x / a.w * 40);
                 const int y = int(a.y / a.w * 30);
                 return (Bayer(3, x % 8, y % 8) + 11) / 64.0 * 0.25 * 0.75 + 0.25;
             });
    grid.Run();
}

TEST_F(TerrainFunctions, SpeedTreesBlendTheirLevelsOfDetail)
{
    const std::string body = R"(
        #include "SpeedTreeCommon.cginc"
        float3 Offset(float3 position, float3 other, float lod, float facing)
        {
            SpeedTreeVB v = (SpeedTreeVB)0;
            v.vertex = float4(position, 1);
            v.texcoord1 = float4(other, 0.5);
            v.texcoord3 = float2(3, -2);
            v.color.a = 1 - facing;
            OffsetSpeedTreeVertex(v, lod);
            return v.vertex.xyz;
        })";
    const std::vector<GridInput> places = CombineVectors(
        {{1, 2, 3}, {-4, 0.5, 0}}, {{0, 0, 1}, {2, -1, 7}}, {{0, 0, 0}, {0.25, 0, 0}, {1, 0, 0}});
    FunctionGrid branches("#define GEOM_TYPE_BRANCH\n#define LOD_FADE_PERCENTAGE\n" + body,
                          ProgramLanguage::Cg);
    branches.Add("Offset(a.xyz, b.xyz, c.x, 0)", places,
                 [](auto& a, auto& b, auto& c) { return dvec3(a) * (1 - c.x) + dvec3(b) * c.x; });
    branches.Run();
    FunctionGrid leaves("#define GEOM_TYPE_LEAF\n#define LOD_FADE_PERCENTAGE\n" + body,
                        ProgramLanguage::Cg);
    // From the anchor to where the leaf is at the next level: 0.5, 3, -2.
    leaves.Add("Offset(a.xyz, b.xyz, c.x, 0)", places,
               [](auto& a, auto& b, auto& c)
               {
                   const dvec3 anchor(b);
                   return anchor + (dvec3(a) - anchor) * (1 - c.x) + dvec3(0.5, 3, -2) * c.x;
               });
    leaves.Run();
}

TEST_F(TerrainFunctions, LeavesAreLitFromBehind)
{
    FunctionGrid grid(R"(
        #include "UnityBuiltin3xTreeLibrary.cginc"
        half4 Leaf(float3 n, float3 l, float3 v)
        {
            LeafSurfaceOutput s = (LeafSurfaceOutput)0;
            s.Albedo = half3(0.2, 0.5, 0.1);
            s.Normal = n;
            s.Translucency = 0.6;
            s.Specular = 0.0625;
            s.Gloss = 0.3;
            s.Alpha = 0.75;
            return LightingTreeLeaf(s, l, v, 0.5);
        })",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_TranslucencyColor", {0.7f, 0.9f, 0.3f});
    grid.SetGlobal("_TranslucencyViewDependency", {0.25f});
    grid.SetGlobal("_LightColor0", {1.0f, 0.8f, 0.6f, 1});
    grid.SetGlobal("_WorldSpaceLightPos0", {0, 0.6f, 0.8f, 0});
    grid.SetGlobal("_MainLightPosition", {0, 0.6f, 0.8f, 0});
    grid.SetGlobal("_WorldSpaceCameraPos", {4, 5, 6, 0});
    const float object[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    std::copy(std::begin(object), std::end(object), grid.perDraw.objectToWorld);
    const auto back = [](double nl, const dvec3& l, const dvec3& v)
    {
        return glm::mix(Saturate(-nl), Saturate(glm::dot(v, -l)), 0.25);
    };
    const std::vector<dvec3> ways = {glm::normalize(dvec3(1, 2, 3)),
                                     glm::normalize(dvec3(-2, 1, -1)), dvec3(0, 1, 0),
                                     glm::normalize(dvec3(1, -1, 0.5))};
    grid.Add("Leaf(a.xyz, b.xyz, c.xyz)", CombineVectors(ways, ways, {ways[0], ways[3]}),
             [=](auto& n, auto& l, auto& v)
             {
                 const dvec3 normal(n), light(l), view(v);
                 const double nl = glm::dot(normal, light);
                 const double nh = glm::dot(normal, glm::normalize(light + view));
                 const double spec = nh > 0 ? std::pow(nh, 8.0) * 0.3 : 0.0;
                 const dvec3 through = back(nl, light, view) * 0.6 * 2.0 * dvec3(0.7, 0.9, 0.3);
                 const dvec3 lit = dvec3(0.2, 0.5, 0.1) *
                                   (through + std::max(0.0, nl * 0.6 + 0.4)) * dvec3(1.0, 0.8, 0.6);
                 return dvec4((lit + spec) * 0.5, 0.75);
             },
             {1e-4, 1e-5});
    grid.Add("ShadeTranslucentMainLight(float4(b.xyz, 1), a.xyz)",
             CombineVectors(ways, {{0, 0, 0}, {1, 8, 20}}),
             [=](auto& n, auto& p, auto&)
             {
                 const dvec3 light(0, 0.6, 0.8);
                 const dvec3 view = glm::normalize(dvec3(4, 5, 6) - dvec3(p));
                 const double nl = glm::dot(dvec3(n), light);
                 return dvec3(1.0, 0.8, 0.6) * (std::max(0.0, nl * 0.6 + 0.4) +
                                                back(nl, light, view) * dvec3(0.7, 0.9, 0.3));
             },
             {1e-4, 1e-5});
    grid.Run();
}

TEST_F(TerrainFunctions, BillboardsOfTreesFaceTheCamera)
{
    FunctionGrid grid(R"(
        #include "TerrainEngine.cginc"
        float3 Spread(float3 p, float2 o, float z)
        {
            float4 pos = float4(p, 1);
            TerrainBillboardTree(pos, o, z);
            return pos.xyz;
        }
        // Rows: x to z, y to x, z to y, twice as large.
        float4 Expanded(float3 p, float3 n, float4 t, int what)
        {
            float4x4 m = float4x4(0, 0, 2, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1);
            float4 pos = float4(p, 1);
            ExpandBillboard(m, pos, n, t);
            return what == 0 ? pos : what == 1 ? float4(n, 0) : t;
        })",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_TreeBillboardCameraRight", {0, 0, 1, 0});
    grid.SetGlobal("_TreeBillboardCameraUp", {0, 1, 0, 0.5f});
    grid.SetGlobal("_TreeBillboardCameraFront", {-1, 0, 0, 0});
    grid.SetGlobal("_TreeBillboardCameraPos", {1, 2, 3, 0.25f});
    grid.SetGlobal("_TreeBillboardDistances", {100, 0, 0, 0});
    grid.Add("Spread(a.xyz, b.xy, b.z)",
             CombineVectors({{0, 0, 0}, {5, 1, -2}, {30, 0, 0}}, {{-2, 6, 3}, {2, 0, -1}}),
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 p(a);
                 if (glm::distance(p, dvec3(1, 2, 3)) > 10)
                 {
                     return p; // too far away
                 }
                 return p + dvec3(-std::abs(b.x) * 0.5, b.y * 0.75 + b.z * 0.25, b.x);
             });
    const auto inputs = CombineVectors({{1, 2, 3}}, {{0, 0.6, 0.8}, {1, 0, 0}}, {{0, 1, 0}});
    const auto turned = [](const dvec4& v)
    {
        return dvec3(v.y, v.z, v.x);
    };
    grid.Add("Expanded(a.xyz, b.xyz, float4(c.xyz, 0), 0).xyz", inputs,
             [=](auto& a, auto& b, auto&)
             { return dvec3(a) + 2.0 * turned(dvec4(b.x, b.y, 0, 0)); });
    grid.Add("Expanded(a.xyz, b.xyz, float4(c.xyz, 0), 1).xyz", inputs,
             [=](auto&, auto& b, auto&) { return turned(b); });
    grid.Add("Expanded(a.xyz, b.xyz, float4(c.xyz, 0), 2)", inputs,
             [=](auto&, auto&, auto& c) { return dvec4(turned(c), -1); });
    // What is no billboard stays.
    grid.Add("Expanded(a.xyz, b.xyz, float4(c.xyz, 1), 0).xyz", inputs,
             [](auto& a, auto&, auto&) { return dvec3(a); });
    grid.Add("Expanded(a.xyz, b.xyz, float4(c.xyz, -1), 1).xyz", inputs,
             [](auto&, auto& b, auto&) { return dvec3(b); });
    grid.Run();
}

TEST_F(TerrainFunctions, SoftOcclusionTreesAreShadedByTheirMesh)
{
    FunctionGrid grid(R"(
        #define USE_CUSTOM_LIGHT_DIR
        #include "UnityBuiltin2xTreeLibrary.cginc"
        appdata_tree Tree(float3 normal, float4 tangent)
        {
            appdata_tree v = (appdata_tree)0;
            v.vertex = float4(1, 2, 3, 1);
            v.normal = normal;
            v.tangent = tangent;
            return v;
        })",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_TerrainTreeLightDirections", {0, 1, 0, 0, 0.6f, 0, 0.8f, 0});
    grid.SetGlobal("_TerrainTreeLightColors", {1, 0.9f, 0.8f, 0, 0.1f, 0.2f, 0.4f, 0});
    grid.SetGlobal("unity_AmbientSky", {0.2f, 0.25f, 0.3f, 1});
    grid.SetGlobal("_Occlusion", {1.5f});
    grid.SetGlobal("_AO", {0.75f});
    grid.SetGlobal("_BaseLight", {0.125f});
    grid.SetGlobal("_Color", {0.5f, 1, 1, 0.5f});
    grid.SetGlobal("_TreeInstanceColor", {1, 0.5f, 1, 0.5f});
    grid.SetGlobal("_TreeInstanceScale", {1, 1, 1, 1});
    grid.SetGlobal("_HalfOverCutoff", {1.25f});
    const dvec3 ambient(0.2, 0.25, 0.3);
    const dvec3 tint(0.5, 0.5, 1);
    const dvec3 directions[] = {{0, 1, 0}, {0.6, 0, 0.8}};
    const dvec3 colors[] = {{1, 0.9, 0.8}, {0.1, 0.2, 0.4}};
    std::vector<GridInput> inputs;
    for (const double open : {0.0, 0.4, 1.0})
    {
        inputs.push_back({dvec4(0, 0.8, 0.6, 0), dvec4(0.3, -0.4, 0.5, open)});
        inputs.push_back({dvec4(1, 0, 0, 0), dvec4(0, 0.9, 0, open)});
    }
    grid.Add("leaves(Tree(a.xyz, b)).color", inputs,
             [=](auto&, auto& b, auto&)
             {
                 dvec3 light = ambient;
                 for (int i = 0; i < 4; ++i) // the last two lights are black
                 {
                     const dvec3 to = i < 2 ? directions[i] : dvec3(0);
                     const dvec3 color = i < 2 ? colors[i] : dvec3(0);
                     const double seen = 1.5 * glm::dot(dvec3(b), to) + 0.75 * b.w;
                     light += color * (std::max(0.0, seen) + 0.125);
                 }
                 return dvec4(light * tint, 0.5 * 1.25);
             });
    grid.Add("bark(Tree(a.xyz, b)).color", inputs,
             [=](auto& a, auto& b, auto&)
             {
                 dvec3 light = ambient;
                 for (int i = 0; i < 2; ++i)
                 {
                     light += colors[i] * std::max(0.0, glm::dot(dvec3(a), directions[i])) *
                              (0.75 * b.w + 0.125);
                 }
                 return dvec4(light * tint, 0.25);
             });
    grid.Run();
}

TEST_F(TerrainFunctions, BrushesArePlacedAndGridsAreBuilt)
{
    FunctionGrid grid("#include \"TerrainTool.cginc\"\n#include \"TerrainPreview.cginc\"\n",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_PCUVToBrushUVScales", {2, 0.5f, -1, 3});
    grid.SetGlobal("_PCUVToBrushUVOffset", {0.25f, 0.75f, 0, 0});
    grid.SetGlobal("_ObjectPos_PCPixelsX", {1, 0, 0, 0});
    grid.SetGlobal("_ObjectPos_PCPixelsY", {0, 0, 2, 0});
    grid.SetGlobal("_ObjectPos_HeightMapSample", {0, 100, 0, 0});
    grid.SetGlobal("_ObjectPos_Offset", {5, 6, 7, 0});
    grid.SetGlobal("_TerrainObjectToWorldOffset", {10, 20, 30, 0});
    grid.SetGlobal("_QuadRez", {3, 2, 36, 4});
    const auto places = Combine({0.0, 0.5, 3.0}, {0.25});
    grid.Add("PaintContextUVToBrushUV(float2(a.x, b.x))", places,
             [](auto& a, auto& b, auto&)
             { return dvec2(2 * a.x - b.x + 0.25, 0.5 * a.x + 3 * b.x + 0.75); });
    grid.Add(
        "TerrainObjectToWorldPosition(PaintContextPixelsToObjectPosition(float2(a.x, b.x), 0.5))",
        places, [](auto& a, auto& b, auto&) { return dvec3(15 + a.x, 76, 37 + 2 * b.x); });
    std::vector<double> vertices(36);
    for (int i = 0; i < 36; ++i)
    {
        vertices[static_cast<std::size_t>(i)] = i;
    }
    grid.Add("BuildProceduralQuadMeshVertex(uint(a.x))", Combine(vertices),
             [](auto& a, auto&, auto&)
             {
                 const dvec2 corners[] = {{0, 0}, {0, 1}, {1, 1}, {1, 1}, {1, 0}, {0, 0}};
                 const int quad = int(a.x) / 6;
                 return (dvec2(quad % 3, quad / 3) + corners[int(a.x) % 6]) * 4.0;
             });
    grid.Run();
}

TEST_F(TerrainFunctions, OldReflectionTermsKeepTheirValues)
{
    FunctionGrid grid("#define INCLUDE_UNITY_STANDARD_BRDF_DEPRECATED\n"
                      "#include \"UnityDeprecated.cginc\"\n",
                      ProgramLanguage::Cg);
    const std::vector<double> cosines = {0.1, 0.5, 1.0};
    const auto inputs = Combine(cosines, {0.0, 0.3, 0.9}, cosines);
    const auto schlick = [](double cosine)
    {
        return std::pow(1 - cosine, 5.0);
    };
    grid.Add("LazarovFresnelTerm(0.04, b.x, a.x).x", inputs,
             [=](auto& a, auto& b, auto&) { return 0.04 + 0.96 * schlick(a.x) / (4 - 3 * b.x); });
    grid.Add("SebLagardeFresnelTerm(0.04, b.x, a.x).x", inputs,
             [=](auto& a, auto& b, auto&)
             { return 0.04 + (std::max(0.04, b.x) - 0.04) * schlick(a.x); });
    grid.Add("CookTorranceVisibilityTerm(a.x, c.x, 0.9, 0.7)", inputs,
             [](auto& a, auto&, auto& c)
             {
                 const double v = 0.7 + 1e-5;
                 const double g = std::min({1.0, 1.8 * c.x / v, 1.8 * a.x / v});
                 return g / (a.x * c.x + 1e-4);
             },
             {1e-4, 1e-6});
    grid.Add("ModifiedKelemenVisibilityTerm(a.x, b.x)", inputs,
             [](auto& a, auto& b, auto&)
             {
                 const double k = b.x * b.x * std::sqrt(2 / k_Pi);
                 return std::pow(a.x * (1 - k) + k, -2.0);
             },
             {1e-4, 1e-6});
    grid.Add("SmithGGXVisibilityTerm(a.x, c.x, b.x)", inputs,
             [](auto& a, auto& b, auto& c)
             {
                 const double k = b.x * b.x / 2;
                 return 1 / ((a.x * (1 - k) + k) * (c.x * (1 - k) + k) + 1e-5);
             },
             {1e-4, 1e-6});
    grid.Add("RDFBlinnPhongNormalizedTerm(a.x, 8)", inputs,
             [](auto& a, auto&, auto&) { return std::pow(a.x, 8.0) * 10 / (8 * k_Pi); },
             {1e-4, 1e-9});
    grid.Run();
}

} // namespace
} // namespace limn::test
