#include "library/Formulas.h"
#include "library/FunctionGrid.h"
#include "library/Lights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// Trees, grass and terrains of both pipelines: what their vertices and fragments hand on.

namespace limn::test::landscape
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using Landscape = GpuTest;

const dvec3 k_Camera(1, 2, 6);
const std::vector<dvec3> k_Places = {{0, 0, 0}, {1, 1, 1}, {-2, 0, 5}};

std::string Terrain(const std::string& file)
{
    return "#include \"Packages/com.unity.render-pipelines.universal/Shaders/Terrain/" + file +
           ".hlsl\"\n";
}

std::shared_ptr<const Texture2D> OneTexel(const glm::vec4& texel)
{
    return MakeTexture(1, 1, [=](int, int) { return texel; });
}

/// An object that was moved and not turned, seen in world space, before Lights.h's sky and sun.
void SetScene(FunctionGrid& grid, const dvec3& place = dvec3(0))
{
    const std::vector<float> identity = Floats(glm::mat4(1));
    std::ranges::copy(identity, grid.perDraw.objectToWorld);
    std::ranges::copy(identity, grid.perDraw.worldToObject);
    for (int i = 0; i < 3; ++i)
    {
        grid.perDraw.objectToWorld[12 + i] = static_cast<float>(place[i]);
        grid.perDraw.worldToObject[12 + i] = static_cast<float>(-place[i]);
    }
    grid.perDraw.worldTransformParams[3] = 1;
    grid.SetGlobal("unity_MatrixVP", identity);
    grid.SetGlobal("unity_MatrixV", identity);
    grid.SetGlobal("_WorldSpaceCameraPos", Floats4(k_Camera, 1));
    grid.SetGlobal("limn_CameraPos", Floats4(k_Camera, 1));
    grid.SetGlobal("_ScaledScreenParams", {8, 4, 1.125f, 1.25f});
    grid.SetGlobal("_ScaleBiasRt", {-1, 1, -1, 1});
    SetLights(grid);
}

void SetTrees(FunctionGrid& grid)
{
    grid.SetGlobal("_TreeInstanceScale", {2, 3, 0.5f, 1});
    grid.SetGlobal("_TreeInstanceColor", {0.5f, 0.25f, 1, 1});
    grid.SetGlobal("_Color", {0.5f, 1, 0.75f, 1});
    grid.SetGlobal("_SquashPlaneNormal", {0, 0.6f, 0.8f, -1});
    grid.SetGlobal("_SquashAmount", {0.25f});
    // The columns of a matrix that leans.
    grid.SetGlobal("_TerrainEngineBendTree",
                   {1, 0, 0, 0, 0.25f, 1, 0, 0, 0, 0.5f, 1, 0, 7, 8, 9, 1});
}
/// A tree's place, pressed three quarters of the way to the plane of SetTrees.
dvec4 Squashed(const dvec3& p)
{
    const dvec3 normal(0, 0.6, 0.8);
    return {p - normal * (0.75 * (glm::dot(normal, p) - 1)), 1};
}

/// What SpeedTree adds to a hue: by the tree's place, and by a place and a normal of its parts.
double Hue(const dvec3& tree, double x, const dvec3& normal)
{
    const auto fraction = [](double v)
    {
        return v - std::floor(v);
    };
    return fraction(tree.x + tree.y + tree.z) + fraction(x + normal.y + normal.x) * 0.5 - 0.3;
}

} // namespace

TEST_F(Landscape, TreesOfTheTreeCreatorGrowAndBend)
{
    FunctionGrid grid(R"(
        #include "UnityCG.cginc"
        #include "Lighting.cginc"
        fixed4 _Color;
        #include "UnityBuiltin3xTreeLibrary.cginc"
        appdata_full Bark(float3 place, float3 normal)
        {
            appdata_full v = (appdata_full)0;
            v.vertex = float4(place, 1);
            v.normal = normal * 3;
            v.tangent = float4(normal.zxy * 2, -1);
            v.color = float4(0.3, 0.5, 0.25, 0.75);
            v.texcoord1.xy = float2(0.5, 1);
            TreeVertBark(v);
            return v;
        })",
                      ProgramLanguage::Cg);
    SetScene(grid);
    SetTrees(grid);
    grid.SetGlobal("_Wind", {0.2f, 0.4f, 0.6f, 0}); // no waves, only a lean of half of it
    const auto inputs = CombineVectors(k_Places, UnitVectors());
    grid.Add("Bark(a.xyz, b.xyz).vertex", inputs,
             [](auto& a, auto&, auto&)
             { return Squashed(dvec3(a) * dvec3(2, 3, 0.5) + dvec3(0.1, 0.2, 0.3)); });
    grid.Add("Bark(a.xyz, b.xyz).normal", inputs, [](auto&, auto& b, auto&) { return dvec3(b); });
    grid.Add("Bark(a.xyz, b.xyz).tangent", inputs,
             [](auto&, auto& b, auto&) { return dvec4(b.z, b.x, b.y, -1); });
    grid.Add("Bark(a.xyz, b.xyz).color", inputs,
             [](auto&, auto&, auto&) { return dvec4(0.25, 0.25, 0.75, 0.75); });
    grid.Run();
}

TEST_F(Landscape, OldTreesBendAsAWhole)
{
    FunctionGrid grid(R"(
        #include "UnityCG.cginc"
        #include "UnityBuiltin2xTreeLibrary.cginc"
        v2f At(float3 place, float follows)
        {
            appdata_tree v = (appdata_tree)0;
            v.vertex = float4(place, 1);
            v.color.w = follows;
            v.texcoord = float4(place, 0.5);
            return limn_TreeVertex(v);
        })",
                      ProgramLanguage::Cg);
    SetScene(grid);
    SetTrees(grid);
    const auto inputs = CombineVectors(k_Places, {{0, 0, 0}, {0.25, 0, 0}, {1, 0, 0}});
    grid.Add("At(a.xyz, b.x).pos", inputs,
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 p = dvec3(a) * dvec3(2, 3, 0.5);
                 const dvec3 bent(p.x + p.y / 4, p.y + p.z / 2, p.z);
                 return Squashed(glm::mix(p, bent, b.x));
             });
    grid.Add("At(a.xyz, b.x).uv", inputs,
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 0.5); });
    grid.Run();
}

TEST_F(Landscape, FourLampsLightLeavesByVertex)
{
    FunctionGrid grid(R"(
        #define VERTEXLIGHT_ON
        #include "UnityCG.cginc"
        #include "Lighting.cginc"
        fixed4 _Color;
        #include "UnityBuiltin3xTreeLibrary.cginc"
    )",
                      ProgramLanguage::Cg);
    SetScene(grid);
    grid.SetGlobal("unity_4LightPosX0", {0, 5, -3, 1});
    grid.SetGlobal("unity_4LightPosY0", {2, 0, 1, 1});
    grid.SetGlobal("unity_4LightPosZ0", {0, 0, 4, 1});
    grid.SetGlobal("unity_4LightAtten0", {0, 0.5f, 1, 25});
    std::vector<float> colors = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1, 1, 0};
    colors.resize(32);
    grid.SetGlobal("unity_LightColor", colors);
    grid.Add("limn_LeafAmbient(a.xyz, b.xyz)",
             CombineVectors({{0, 0, 0}, {1, 1, 2}, {-20, 3, 7}}, UnitVectors()),
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 positions[] = {{0, 2, 0}, {5, 0, 0}, {-3, 1, 4}, {1, 1, 1}};
                 const dvec3 lamps[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
                 const double falloff[] = {0, 0.5, 1, 25};
                 dvec3 sum = k_Sky;
                 for (int i = 0; i < 4; ++i)
                 {
                     const dvec3 to = positions[i] - dvec3(a);
                     const double cosine = std::max(0.0, glm::dot(glm::normalize(to), dvec3(b)));
                     sum += lamps[i] * (cosine / (1 + glm::dot(to, to) * falloff[i]));
                 }
                 return sum;
             },
             {2e-5, 1e-5});
    grid.Run();
}

TEST_F(Landscape, HuesOfTreesVary)
{
    const dvec3 tree(3.25, 1.5, -2.125);
    const auto inputs = CombineVectors({{0.1, 0, 0}, {1.7, 0, 0}, {-2.45, 0, 0}}, UnitVectors());
    const auto hue = [=](const dvec4& a, const dvec4& b, const dvec4&)
    {
        return Saturate(Hue(tree, a.x, dvec3(b)) * 0.75);
    };
    FunctionGrid builtin(R"(
        #define EFFECT_HUE_VARIATION
        #include "SpeedTreeCommon.cginc"
        Input At(float x, float3 normal)
        {
            SpeedTreeVB v = (SpeedTreeVB)0;
            v.vertex = float4(x, 0, 0, 1);
            v.normal = normal;
            v.texcoord.xy = float2(0.25, 0.5);
            v.color = float4(0.5, 0, 0, 0);
            Input result;
            SpeedTreeVert(v, result);
            return result;
        })",
                         ProgramLanguage::Cg);
    SetScene(builtin, tree);
    builtin.SetGlobal("_HueVariation", {0, 0, 0, 0.75f});
    builtin.SetGlobal("_Color", {0.5f, 1, 0.75f, 1});
    builtin.Add("At(a.x, b.xyz).HueVariationAmount", inputs, hue, {1e-5, 1e-5});
    builtin.Add("At(a.x, b.xyz).mainTexUV", inputs,
                [](auto&, auto&, auto&) { return dvec2(0.25, 0.5); });
    builtin.Add("At(a.x, b.xyz).color", inputs,
                [](auto&, auto&, auto&) { return dvec4(0.25, 0.5, 0.375, 1); });
    builtin.Run();

    const std::string nature =
        "#include \"Packages/com.unity.render-pipelines.universal/Shaders/Nature/";
    FunctionGrid urp("#define EFFECT_HUE_VARIATION\n" + nature + "SpeedTree7Input.hlsl\"\n" +
                     nature + "SpeedTree7Passes.hlsl\"\n" + R"(
        float At(float x, float3 normal)
        {
            SpeedTreeVertexInput v = (SpeedTreeVertexInput)0;
            v.vertex = float4(x, 0, 0, 1);
            v.normal = normal;
            return limn_Tree7Hue(v);
        })");
    SetScene(urp, tree);
    urp.SetGlobal("_HueVariation", {0, 0, 0, 0.75f});
    urp.Add("At(a.x, b.xyz)", inputs, hue, {1e-5, 1e-5});
    urp.Run();
}

TEST_F(Landscape, SpeedTree8TakesMapsAndFadesShadows)
{
    for (const bool hasMaps : {false, true})
    {
        FunctionGrid grid((hasMaps ? "#define EFFECT_EXTRA_TEX\n" : "") + std::string(R"(
            #define EFFECT_SUBSURFACE
            #define EFFECT_BILLBOARD
            #include "SpeedTree8Common.cginc"
            SurfaceOutputStandard Surface(float shade)
            {
                Input i = (Input)0;
                i.color = float4(shade, 0.5, 0, 1);
                SurfaceOutputStandard s = (SurfaceOutputStandard)0;
                s.Normal = float3(0, 0, 1);
                SpeedTreeSurf(i, s);
                return s;
            }
            float3 Light(float attenuation)
            {
                UnityGIInput d = (UnityGIInput)0;
                d.light.color = float3(1, 2, 3);
                d.atten = attenuation;
                UnityGI gi = (UnityGI)0;
                SurfaceOutputStandard s = (SurfaceOutputStandard)0;
                s.Normal = float3(0, 0, 1);
                LightingSpeedTreeSubsurface_GI(s, d, gi);
                return gi.light.color;
            })"),
                          ProgramLanguage::Cg);
        grid.SetGlobal("_Color", {0.5f, 1, 0.75f, 1});
        grid.SetGlobal("_Glossiness", {0.75f});
        grid.SetGlobal("_Metallic", {0.25f});
        grid.SetGlobal("_BillboardShadowFade", {0.25f});
        grid.SetGlobal("_SubsurfaceColor", {1, 0.5f, 0.25f, 0});
        grid.SetTexture("_SubsurfaceTex", OneTexel({0.5f, 0.25f, 1, 0}));
        grid.SetTexture("_ExtraTex", OneTexel({0.125f, 0.625f, 0.5f, 0}));
        const auto inputs = Combine({0.0, 0.5, 1.0});
        grid.Add("float4(Surface(a.x).Smoothness, Surface(a.x).Metallic, Surface(a.x).Occlusion, "
                 "Surface(a.x).Alpha)",
                 inputs,
                 [=](auto& a, auto&, auto&)
                 { return hasMaps ? dvec4(0.125, 0.625, a.x / 2, 1) : dvec4(0.75, 0.25, a.x, 1); });
        grid.Add("Surface(a.x).Emission", inputs,
                 [](auto&, auto&, auto&) { return dvec3(0.5, 0.125, 0.25); });
        grid.Add("Light(a.x)", inputs,
                 [](auto& a, auto&, auto&) { return dvec3(1, 2, 3) * (a.x + (1 - a.x) * 0.25); });
        grid.Run();
    }
}

TEST_F(Landscape, LayersOfTerrainsAreWeighedAndFogged)
{
    const double density = 0.05;
    for (const bool isAdded : {false, true})
    {
        const std::string defines =
            std::string("#define FOG_EXP2\n") + (isAdded ? "#define TERRAIN_SPLAT_ADDPASS\n" : "");
        const auto fogged = [=](const dvec4& a, const dvec4& b, const dvec4&)
        {
            const double clear = std::exp(-std::pow(density * b.x, 2));
            const dvec3 fog = isAdded ? dvec3(0) : dvec3(0.2, 0.4, 0.8);
            return glm::mix(fog, dvec3(a) * 0.5, clear);
        };
        const auto inputs = CombineVectors(Colors(), {{0, 0, 0}, {10, 0, 0}, {40, 0, 0}});
        FunctionGrid builtin(defines + R"(
            #define TERRAIN_STANDARD_SHADER
            #define TERRAIN_SURFACE_OUTPUT SurfaceOutputStandard
            #include "UnityPBSLighting.cginc"
            #include "TerrainSplatmapCommon.cginc"
            float3 Final(float3 color, float distance)
            {
                Input i = (Input)0;
                i.fogCoord = 0.5 * (1.0 - distance / 200.0);
                SurfaceOutputStandard o = (SurfaceOutputStandard)0;
                o.Alpha = 0.5;
                fixed4 result = float4(color, 1);
                SplatmapFinalColor(i, o, result);
                return result.rgb;
            })",
                             ProgramLanguage::Cg);
        builtin.SetGlobal("_ProjectionParams", {1, 0.5f, 200, 0.005f});
        builtin.SetGlobal("unity_FogColor", {0.2f, 0.4f, 0.8f, 1});
        builtin.SetGlobal("unity_FogParams",
                          {static_cast<float>(density / std::sqrt(std::log(2.0)))});
        builtin.Add("Final(a.xyz, b.x)", inputs, fogged, {1e-4, 1e-5});
        builtin.Run();
        FunctionGrid urp(defines + Terrain("TerrainLitInput") + Terrain("TerrainLitPasses") + R"(
            float3 Final(float3 color, float factor)
            {
                half4 result = half4(color, 0.5);
                SplatmapFinalColor(result, factor);
                return result.rgb;
            })");
        urp.SetGlobal("unity_FogColor", {0.2f, 0.4f, 0.8f, 1});
        // 2^-f^2 is e^-(0.05 distance)^2.
        urp.Add("Final(a.xyz, b.x * 0.060056120)", inputs, fogged, {1e-4, 1e-5});
        urp.Run();
    }
}

TEST_F(Landscape, FragmentsOfTerrainsKnowWhereTheyAre)
{
    FunctionGrid grid("#define _NORMALMAP\n#define _ADDITIONAL_LIGHTS_VERTEX\n" +
                      Terrain("TerrainLitInput") + Terrain("TerrainLitPasses") + R"(
        InputData At(float3 place, float3 normal, float3 normalTS)
        {
            Varyings v = (Varyings)0;
            v.positionWS = place;
            v.clipPos = float4(2, 3, 0.5, 1);
            v.normal = float4(normal, 0.1);
            v.tangent = float4(normal.zxy, 0.2);
            v.bitangent = float4(normal.yzx, 0.3);
            v.fogFactorAndVertexLight = float4(0.625, place);
            InputData d;
            InitializeInputData(v, normalTS, d);
            return d;
        }
        VaryingsLean Depth(float3 place)
        {
            AttributesLean v = (AttributesLean)0;
            v.position = float4(place, 1);
            v.texcoord = place.xy;
            return DepthOnlyVertex(v);
        })");
    SetScene(grid);
    const auto inputs = CombineVectors(k_Places, UnitVectors(), {{0, 0, 1}, {0.6, 0, 0.8}});
    const auto turned = [](const dvec4& b, const dvec4& c)
    {
        return dvec3(-b.z, -b.x, -b.y) * c.x + dvec3(b.y, b.z, b.x) * c.y + dvec3(b) * c.z;
    };
    grid.Add("At(a.xyz, b.xyz, c.xyz).positionWS + At(a.xyz, b.xyz, c.xyz).vertexLighting", inputs,
             [](auto& a, auto&, auto&) { return 2.0 * dvec3(a); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).normalWS * length(mul(c.xyz, "
             "At(a.xyz, b.xyz, c.xyz).tangentToWorld))",
             inputs, [=](auto&, auto& b, auto& c) { return turned(b, c); }, {1e-5, 1e-5});
    grid.Add("mul(c.xyz, At(a.xyz, b.xyz, c.xyz).tangentToWorld)", inputs,
             [=](auto&, auto& b, auto& c) { return turned(b, c); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).viewDirectionWS", inputs,
             [](auto&, auto&, auto&) { return dvec3(0.1, 0.2, 0.3); });
    grid.Add("At(a.xyz, b.xyz, c.xyz).bakedGI", inputs, [](auto&, auto&, auto&) { return k_Sky; });
    grid.Add("float4(At(a.xyz, b.xyz, c.xyz).normalizedScreenSpaceUV, "
             "At(a.xyz, b.xyz, c.xyz).fogCoord, At(a.xyz, b.xyz, c.xyz).shadowMask.w)",
             inputs, [](auto&, auto&, auto&) { return dvec4(0.25, 0.75, 0.625, 1); });
    grid.Add("Depth(a.xyz).clipPos", inputs,
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 1); });
    grid.Add("Depth(a.xyz).texcoord", inputs, [](auto& a, auto&, auto&) { return dvec2(a); });
    grid.Run();
}

TEST_F(Landscape, NormalsOfTerrainsAreThoseOfTheirLayers)
{
    FunctionGrid grid("#define _NORMALMAP\n" + Terrain("TerrainLitInput") +
                      Terrain("TerrainLitDepthNormalsPass") + R"(
        float4 Normal(float3 normal)
        {
            VaryingsDepthNormal v = (VaryingsDepthNormal)0;
            v.normal = float4(normal, 0);
            v.tangent = float4(normal.zxy, 0);
            v.bitangent = float4(normal.yzx, 0);
            half4 result;
            DepthNormalOnlyFragment(v, result);
            return result;
        })");
    grid.SetTexture("_Control", OneTexel({1, 0, 0, 0}));
    grid.SetGlobal("_Control_TexelSize", {1, 1, 1, 1});
    grid.SetTexture("_Normal0", OneTexel({0.8f, 0.5f, 1, 1}));
    grid.SetGlobal("_NormalScale0", {1});
    grid.Add("Normal(a.xyz)", CombineVectors({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
             [](auto& a, auto&, auto&)
             { return dvec4(dvec3(-a.z, -a.x, -a.y) * 0.6 + dvec3(a) * 0.8, 0); },
             {1e-4, 1e-4});
    grid.Run();
}

TEST_F(Landscape, FragmentsOfGrassKnowWhereTheyAre)
{
    FunctionGrid grid(Terrain("WavingGrassInput") + Terrain("WavingGrassPasses") +
                      Terrain("WavingGrassDepthNormalsPass") + R"(
        InputData At(float3 place, float3 normal)
        {
            GrassVertexOutput v = (GrassVertexOutput)0;
            v.posWSShininess = float4(place, 32);
            v.clipPos = float4(2, 3, 0.5, 1);
            v.normal = normal;
            v.viewDir = normal * 2;
            v.fogFactorAndVertexLight = float4(0.625, place);
            InputData d;
            InitializeInputData(v, d);
            return d;
        }
        GrassVertexDepthNormalOutput Still(float3 place, float3 normal)
        {
            GrassVertexDepthNormalInput v = (GrassVertexDepthNormalInput)0;
            v.vertex = float4(place, 1);
            v.normal = normal;
            v.texcoord = place.xy;
            return limn_GrassDepthNormal(v, 0);
        })");
    SetScene(grid);
    const auto inputs = CombineVectors(k_Places, UnitVectors());
    grid.Add("At(a.xyz, b.xyz).positionWS + At(a.xyz, b.xyz).vertexLighting", inputs,
             [](auto& a, auto&, auto&) { return 2.0 * dvec3(a); });
    grid.Add("At(a.xyz, b.xyz).normalWS + 3 * At(a.xyz, b.xyz).viewDirectionWS", inputs,
             [](auto&, auto& b, auto&) { return 4.0 * dvec3(b); });
    grid.Add("At(a.xyz, b.xyz).bakedGI", inputs, [](auto&, auto&, auto&) { return k_Sky; });
    grid.Add("float4(At(a.xyz, b.xyz).normalizedScreenSpaceUV, At(a.xyz, b.xyz).fogCoord, "
             "At(a.xyz, b.xyz).shadowMask.w)",
             inputs, [](auto&, auto&, auto&) { return dvec4(0.25, 0.75, 0.625, 1); });
    grid.Add("Still(a.xyz, b.xyz).clipPos", inputs,
             [](auto& a, auto&, auto&) { return dvec4(dvec3(a), 1); });
    grid.Add("Still(a.xyz, b.xyz).normal", inputs, [](auto&, auto& b, auto&) { return dvec3(b); });
    grid.Add("Still(a.xyz, b.xyz).uv", inputs, [](auto& a, auto&, auto&) { return dvec2(a); });
    grid.Add("Still(a.xyz, b.xyz).viewDirWS", inputs,
             [](auto& a, auto&, auto&) { return k_Camera - dvec3(a); });
    grid.Run();
}

} // namespace limn::test::landscape
