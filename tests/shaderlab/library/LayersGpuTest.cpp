#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// The layers of terrains, and the gradients and colours of the UI Toolkit, in double.

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using LayerFunctions = GpuTest;

std::shared_ptr<const Texture2D> Row(const std::vector<dvec4>& texels)
{
    return MakeTexture(static_cast<int>(texels.size()), 1,
                       [&](int x, int) { return texels[static_cast<std::size_t>(x)]; });
}

const dvec4 k_Layers[] = {
    {0.9, 0.2, 0.1, 0.8}, {0.3, 0.7, 0.2, 0.6}, {0.1, 0.2, 0.8, 1.0}, {0.5, 0.5, 0.4, 0.3}};
const dvec4 k_Left(0.6, 0.3, 0.0, 0.05);
const dvec4 k_Right(0.1, 0.2, 0.5, 0.4);

/// A control texture of two texels, each at an edge of the terrain, and a layer of one colour each.
void SetLayers(FunctionGrid& grid)
{
    grid.SetTexture("_Control", Row({k_Left, k_Right}));
    grid.SetGlobal("_Control_TexelSize", {0.5f, 1, 2, 1});
    for (int i = 0; i < 4; ++i)
    {
        const std::string number = std::to_string(i);
        grid.SetTexture("_Splat" + number, Row({k_Layers[i]}));
        grid.SetGlobal("_Splat" + number + "_ST", {4, 4, 0, 0});
    }
}

dvec4 Control(double u)
{
    return glm::mix(k_Left, k_Right, u);
}

TEST_F(LayerFunctions, TerrainsOfTheBuiltinPipelineMixTheirLayers)
{
    FunctionGrid grid(R"(
        #define TERRAIN_STANDARD_SHADER
        #include "TerrainSplatmapCommon.cginc"
        float4 Mixed(float u, half4 smoothness, int what)
        {
            Input IN = (Input)0;
            IN.tc.xy = float2(u, 0.5);
            half4 control, diffuse;
            half weight;
            fixed3 normal = fixed3(0, 0, 1);
            SplatmapMix(IN, smoothness, control, weight, diffuse, normal);
            return what == 0 ? diffuse : what == 1 ? control : half4(normal, weight);
        })",
                      ProgramLanguage::Cg);
    SetLayers(grid);
    const std::vector<GridInput> places = {{dvec4(0)}, {dvec4(0.25)}, {dvec4(0.8)}, {dvec4(1)}};
    const auto shares = [](double u)
    {
        const dvec4 control = Control(u);
        return control / (control.x + control.y + control.z + control.w + 0.001);
    };
    // Texels are filtered with 8 bits between two of them.
    const Tolerance filtered{0.0, 2.5e-3};
    grid.Add(
        "Mixed(a.x, half4(0.5, 1, 0.25, 0), 1)", places,
        [=](auto& a, auto&, auto&) { return shares(a.x); }, filtered);
    grid.Add(
        "Mixed(a.x, half4(0.5, 1, 0.25, 0), 0)", places,
        [=](auto& a, auto&, auto&)
        {
            const double smoothness[] = {0.5, 1, 0.25, 0};
            dvec4 sum(0);
            for (int i = 0; i < 4; ++i)
            {
                sum += k_Layers[i] * dvec4(1, 1, 1, smoothness[i]) * shares(a.x)[i];
            }
            return sum;
        },
        filtered);
    grid.Add(
        "Mixed(a.x, half4(0.5, 1, 0.25, 0), 2)", places,
        [](auto& a, auto&, auto&)
        {
            const dvec4 control = Control(a.x);
            return dvec4(0, 0, 1, control.x + control.y + control.z + control.w);
        },
        filtered);
    grid.Run();
}

const std::string k_UrpTerrain = R"(
    #include "Packages/com.unity.render-pipelines.universal/Shaders/Terrain/TerrainLitInput.hlsl"
    #include "Packages/com.unity.render-pipelines.universal/Shaders/Terrain/TerrainLitPasses.hlsl"
    float4 Mixed(float4 control, int what)
    {
        half weight;
        half4 diffuse, smoothness;
        half3 normal = half3(0, 0, 1);
        SplatmapMix(0, 0, 0, control, weight, diffuse, smoothness, normal);
        return what == 0 ? half4(diffuse.rgb, weight) : what == 1 ? control : smoothness;
    })";

TEST_F(LayerFunctions, TerrainsOfUrpMixTheirLayersByDensity)
{
    FunctionGrid grid(k_UrpTerrain);
    SetLayers(grid);
    // Of the first two layers alpha is a density, of the others it is not.
    grid.SetGlobal("_DiffuseRemapScale0", {1, 1, 0.5f, 0});
    grid.SetGlobal("_DiffuseRemapScale1", {1, 0.25f, 1, 0});
    grid.SetGlobal("_DiffuseRemapScale2", {1, 1, 1, 1});
    grid.SetGlobal("_DiffuseRemapScale3", {0.5f, 1, 1, 1});
    grid.SetGlobal("_Smoothness0", {0.5f});
    grid.SetGlobal("_Smoothness3", {0.25f});
    grid.SetGlobal("_NumLayersCount", {4});
    const std::vector<GridInput> controls = {
        {dvec4(0.6, 0.3, 0.0, 0.1)}, {dvec4(0.21, 0.42, 0.2, 0.17)}, {dvec4(0, 1, 0, 0)}};
    const auto dense = [](const dvec4& control)
    {
        dvec4 weights = control;
        for (int i = 0; i < 2; ++i)
        {
            weights[i] = Saturate(20 * (k_Layers[i].w - (1 - control[i]))) + 0.001 * control[i];
        }
        return weights;
    };
    const auto total = [=](const dvec4& control)
    {
        return glm::dot(dense(control), dvec4(1));
    };
    grid.Add("Mixed(a, 1)", controls,
             [=](auto& a, auto&, auto&) { return dense(a) / (total(a) + std::pow(2.0, -14.0)); },
             {1e-4, 1e-4});
    grid.Add("Mixed(a, 0)", controls,
             [=](auto& a, auto&, auto&)
             {
                 const dvec3 tints[] = {{1, 1, 0.5}, {1, 0.25, 1}, {1, 1, 1}, {0.5, 1, 1}};
                 dvec3 sum(0);
                 for (int i = 0; i < 4; ++i)
                 {
                     sum += dvec3(k_Layers[i]) * tints[i] * dense(a)[i];
                 }
                 return dvec4(sum / (total(a) + std::pow(2.0, -14.0)), total(a));
             },
             {1e-4, 1e-4});
    grid.Add("Mixed(a, 2)", controls, [](auto&, auto&, auto&) { return dvec4(0.4, 0, 0, 0.075); });
    grid.Run();
}

TEST_F(LayerFunctions, TerrainsOfUrpShowTheHighestLayer)
{
    FunctionGrid grid("#define _TERRAIN_BLEND_HEIGHT\n" + k_UrpTerrain + R"(
    float4 Highest(float4 control, float4 heights)
    {
        half4 masks[4];
        for (int i = 0; i < 4; ++i) masks[i] = half4(0, 0, heights[i], 0);
        HeightBasedSplatModify(control, masks);
        return control;
    })");
    grid.SetGlobal("_HeightTransition", {0.2f});
    std::vector<GridInput> inputs;
    for (const dvec4& control : {dvec4(0.25), dvec4(0.7, 0.2, 0.1, 0), dvec4(0, 0, 1, 0)})
    {
        inputs.push_back({control, dvec4(0.1, 0.9, 0.5, 0.4)});
        inputs.push_back({control, dvec4(1, 0.2, 0.95, 0)});
    }
    grid.Add("Highest(a, b)", inputs,
             [](auto& a, auto& b, auto&)
             {
                 const dvec4 heights = a * b;
                 const double top = std::max({heights.x, heights.y, heights.z, heights.w});
                 dvec4 seen(0);
                 for (int i = 0; i < 4; ++i)
                 {
                     seen[i] = (std::max(heights[i] - (top - 0.2), 0.0) + 1e-6) * a[i];
                 }
                 return seen / glm::dot(seen, dvec4(1));
             },
             {1e-4, 1e-5});
    grid.Run();
}

TEST_F(LayerFunctions, SimpleStandardSurfacesAreLitFromTheirVertices)
{
    for (const bool hasNormalMap : {false, true})
    {
        FunctionGrid grid((hasNormalMap ? "#define _NORMALMAP\n" : "") + std::string(R"(
            #define _GLOSSYREFLECTIONS_OFF
            #define UNITY_SETUP_BRDF_INPUT MetallicSetup
            #include "UnityStandardCoreForwardSimple.cginc"
            float3 Lit(float3 place, float3 normal)
            {
                VertexInput v = (VertexInput)0;
                v.vertex = float4(place, 1);
                v.normal = normal;
            #ifdef _NORMALMAP
                v.tangent = float4(normalize(cross(normal, float3(0.3, 0.5, 0.9))), 1);
            #endif
                return fragForwardBaseSimpleInternal(vertForwardBaseSimple(v)).rgb;
            })"),
                          ProgramLanguage::Cg);
        for (int i = 0; i < 4; ++i)
        {
            grid.perDraw.objectToWorld[i * 5] = 1;
            grid.perDraw.worldToObject[i * 5] = 1;
        }
        grid.perDraw.worldTransformParams[3] = 1;
        grid.SetTexture("_BumpMap", Row({dvec4(0.5, 0.5, 1, 1)})); // flat
        grid.SetGlobal("_BumpScale", {1});
        grid.SetGlobal("_Color", {0.8f, 0.4f, 0.2f, 1});
        grid.SetGlobal("_Metallic", {0.25f});
        grid.SetGlobal("_Glossiness", {0.6f});
        grid.SetGlobal("_LightColor0", {1, 0.5f, 2, 1});
        grid.SetGlobal("_MainLightColor", {1, 0.5f, 2, 1});
        grid.SetGlobal("_MainLightPosition", {0, 0.6f, 0.8f, 0});
        grid.SetGlobal("_WorldSpaceCameraPos", {1, 2, 6, 0});
        grid.SetGlobal("limn_CameraPos", {1, 2, 6, 1});
        grid.SetGlobal("unity_AmbientSky", {0.1f, 0.2f, 0.3f, 1});
        const dvec3 light(0, 0.6, 0.8);
        grid.Add("Lit(a.xyz, b.xyz)",
                 CombineVectors({{0, 0, 0}, {1, 1, 1}, {-2, 0, 5}}, UnitVectors()),
                 [=](auto& a, auto& b, auto&)
                 {
                     const dvec3 albedo(0.8, 0.4, 0.2);
                     const dvec3 diffuse = albedo * (0.96 * 0.75);
                     const dvec3 specular = glm::mix(dvec3(0.04), albedo, 0.25);
                     const dvec3 normal(b);
                     const dvec3 view = glm::normalize(dvec3(1, 2, 6) - dvec3(a));
                     // Phong's lobe, a quarter as narrow as Blinn's of the same roughness
                     const double power = (2 / std::pow(0.4, 4.0) - 2) / 4;
                     const double mirrored = glm::dot(glm::reflect(-view, normal), light);
                     const double lobe =
                         std::min(16.0, std::pow(std::abs(mirrored), power) * (power + 1) / 2);
                     const double fresnel = std::pow(1 - Saturate(glm::dot(normal, view)), 4.0);
                     const double grazing = 0.6 + 1 - 0.96 * 0.75;
                     return dvec3(1, 0.5, 2) * Saturate(glm::dot(normal, light)) *
                                (diffuse + specular * lobe) +
                            dvec3(0.1, 0.2, 0.3) * glm::mix(specular, dvec3(grazing), fresnel);
                 },
                 {2e-3, 2e-4});
        grid.Run();
    }
}

TEST_F(LayerFunctions, InterfacesAddressGradientsAndPages)
{
    FunctionGrid grid("#define UIE_CUSTOM_SHADER\n#include \"UnityUIE.cginc\"\n",
                      ProgramLanguage::Cg);
    // A ray from the focus through the place, to the circle around the middle of the square.
    std::vector<GridInput> inputs;
    for (const dvec2& focus : {dvec2(0), dvec2(0.5, -0.25)})
    {
        for (const dvec2& place : {dvec2(0.75, 0.5), dvec2(0.2, 0.9), dvec2(0.1, 0.1)})
        {
            inputs.push_back({dvec4(place, 0, 0), dvec4(focus, 0, 0)});
        }
    }
    grid.Add("uie_radial_address(a.xy, b.xy)", inputs,
             [](auto& a, auto& b, auto&)
             {
                 const dvec2 focus(b);
                 const dvec2 from = dvec2(a) * 2.0 - 1.0 - focus;
                 // |focus + from / t| = 1, for the t that is 1 on the rim
                 const double aa = glm::dot(from, from);
                 const double ab = glm::dot(from, focus);
                 const double reach =
                     (-ab + std::sqrt(ab * ab + aa * (1 - glm::dot(focus, focus)))) / aa;
                 return 1 / reach;
             },
             {1e-4, 1e-5});
    grid.Add("uie_decode_shader_info_texel_pos(a.xy / 255.0, b.x / 255.0, 3)",
             {{dvec4(0), dvec4(0)}, {dvec4(2, 3, 0, 0), dvec4(40, 0, 0, 0)}},
             [](auto& a, auto& b, auto&)
             {
                 const int id = int(b.x);
                 return dvec2(a.x * 32 + id % 32, a.y * 8 + id / 32 * 3);
             },
             {1e-4, 1e-3});
    const auto levels = Combine({0.0, 0.02, 0.2, 0.5, 1.0});
    grid.Add("uie_linear_to_gamma(a.xxx).x", levels,
             [](auto& a, auto&, auto&) { return LinearToSrgb(a.x); }, {1e-4, 1e-5});
    // A fitted cubic, which is to give every value of 8 bits back (below 0 is 0 there).
    grid.Add("saturate(uie_linear_to_gamma(uie_gamma_to_linear(a.xxx)).x)", levels,
             [](auto& a, auto&, auto&) { return a.x; }, {0.0, 0.5 / 255});
    grid.SetGlobal("_ClipSpaceParams", {400, 300, 1 / 400.0f, 1 / 300.0f});
    grid.Add("uie_snap_to_integer_pos(a.xy)", {{dvec4(0.1234, -0.777, 0, 0)}},
             [](auto& a, auto&, auto&)
             {
                 return dvec2(std::round((a.x + 1) * 400 + 0.1527) / 400 - 1,
                              std::round((a.y + 1) * 300 + 0.1527) / 300 - 1);
             });
    grid.Run();
}

} // namespace
} // namespace limn::test
