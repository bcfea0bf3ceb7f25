#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

namespace limn::test
{
namespace
{

using glm::dvec3;
using glm::dvec4;

using BuiltinPasses = GpuTest;

const std::vector<float> k_Identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

TEST_F(BuiltinPasses, BiasShadowCasters)
{
    FunctionGrid grid("#include \"UnityCG.cginc\"\n", ProgramLanguage::Cg);
    std::ranges::copy(k_Identity, grid.perDraw.objectToWorld);
    std::ranges::copy(k_Identity, grid.perDraw.worldToObject);
    grid.SetGlobal("unity_MatrixVP", k_Identity);
    grid.SetGlobal("_MainLightPosition", {0, 0.6f, 0.8f, 0});
    grid.SetGlobal("unity_LightShadowBias", {-0.25f, 1, 0.1f, 0});
    // Reversed z: away from the light is down, and nothing lies in front of the near plane.
    grid.Add("UnityApplyLinearShadowBias(float4(1, 2, a.x, b.x))",
             Combine({-1.0, 0.0, 0.5, 1.5}, {0.125, 1.0, 2.0}),
             [](auto& a, auto& b, auto&)
             {
                 const double moved = a.x + std::max(-1.0, -0.25 / b.x);
                 return dvec4(1, 2, std::min(moved, b.x), b.x);
             });
    grid.Add("UnityClipSpaceShadowCasterPos(float4(a.xyz, 1), b.xyz)",
             CombineVectors({{0, 0, 0}, {1, -2, 3}}, UnitVectors()),
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 normal(b);
                 const double sine = glm::length(glm::cross(normal, dvec3(0, 0.6, 0.8)));
                 return dvec4(dvec3(a) - normal * (0.1 * sine), 1);
             },
             {1e-5, 2e-4});
    grid.Run();
}

TEST_F(BuiltinPasses, ReadLightMapsAndProbes)
{
    FunctionGrid grid("#include \"UnityGlobalIllumination.cginc\"\n", ProgramLanguage::Cg);
    const auto colors = CombineVectors(Colors(), {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}});
    grid.Add("DecodeLightmap(float4(a.xyz, b.x))", colors,
             [](auto& a, auto&, auto&) { return dvec3(a); });
    grid.Add("DecodeLightmapRGBM(float4(a.xyz, b.x), float4(5, 2, 0, 0))", colors,
             [](auto& a, auto& b, auto&) { return dvec3(a) * (5 * b.x * b.x); }, {3e-5, 1e-6});
    grid.Add("DecodeLightmapDoubleLDR(float4(a.xyz, b.x), float4(4.59479380, 1, 0, 0))", colors,
             [](auto& a, auto&, auto&) { return dvec3(a) * 4.59479380; });
    grid.Add("DecodeDirectionalLightmap(a.xyz, float4(b.xyz * 0.5 + 0.5, 0.7), c.xyz)",
             CombineVectors({{1, 0.5, 2}}, UnitVectors(), UnitVectors()),
             [](auto& a, auto& b, auto& c)
             { return dvec3(a) * ((glm::dot(dvec3(b), dvec3(c)) / 2 + 0.5) / 0.7); },
             {1e-5, 1e-5});
    // The point where the ray leaves the box, seen from the probe.
    grid.Add(
        "BoxProjectedCubemapDirection(a.xyz, b.xyz, float4(1, 0, 0, 1), float4(-5, -4, -3, 0), "
        "float4(5, 6, 7, 0))",
        CombineVectors({{0.6, 0.48, 0.64}, {-0.6, 0.64, -0.48}, {0.1, -2, 0.2}},
                       {{0, 0, 0}, {4, -3, 6}}),
        [](auto& a, auto& b, auto&)
        {
            const dvec3 direction = glm::normalize(dvec3(a));
            double nearest = 1e30;
            for (int i = 0; i < 3; ++i)
            {
                const double wall = direction[i] > 0 ? 5.0 + i : -5.0 + i;
                nearest = std::min(nearest, (wall - b[i]) / direction[i]);
            }
            return dvec3(b) + direction * nearest - dvec3(1, 0, 0);
        },
        {1e-5, 1e-5});
    grid.Add("BoxProjectedCubemapDirection(a.xyz, b.xyz, 0, -1, 1)", CombineVectors(UnitVectors()),
             [](auto& a, auto&, auto&) { return dvec3(a); });
    grid.Run();
}

TEST_F(BuiltinPasses, PlaceVerticesByTheirLightMapCoordinates)
{
    FunctionGrid grid("#include \"UnityMetaPass.cginc\"\n", ProgramLanguage::Cg);
    grid.SetGlobal("unity_MatrixVP", k_Identity);
    grid.SetGlobal("unity_MetaVertexControl", {1, 0, 0, 0});
    grid.Add(
        "UnityMetaVertexPosition(float4(a.xyz, 1), b.xy, 9, float4(0.5, 0.25, 0.125, 0.75), 9)",
        CombineVectors({{7, 8, -1}, {7, 8, 2}}, {{0, 0, 0}, {0.5, 1, 0}}),
        [](auto& a, auto& b, auto&)
        { return dvec4(b.x * 0.5 + 0.125, b.y * 0.25 + 0.75, a.z > 0 ? 1e-4 : 0.0, 1); });
    grid.Add(
        "UnityMetaVizUV(int(a.x), float2(1, 2), float2(3, 4), float2(5, 6), float4(2, 3, 1, -1))",
        Combine({0.0, 1.0, 2.0}),
        [](auto& a, auto&, auto&)
        { return glm::dvec2(2 * (2 * a.x + 1) + 1, 3 * (2 * a.x + 2) - 1); });
    grid.Run();
}

TEST_F(BuiltinPasses, ShadeByLambertAndBlinnPhong)
{
    FunctionGrid grid(R"(
        #include "Lighting.cginc"
        float4 Shade(float3 n, float3 l, float3 v, float gloss)
        {
            SurfaceOutput s = (SurfaceOutput)0;
            s.Albedo = float3(0.5, 0.25, 1);
            s.Normal = n;
            s.Specular = 0.25;
            s.Gloss = gloss;
            s.Alpha = 0.75;
            UnityGI gi = (UnityGI)0;
            gi.light.color = float3(1, 2, 3);
            gi.light.dir = l;
            gi.indirect.diffuse = float3(0.1, 0.2, 0.3);
            return gloss == 0 ? LightingLambert(s, gi) : LightingBlinnPhong(s, v, gi);
        })",
                      ProgramLanguage::Cg);
    grid.SetGlobal("_SpecColor", {0.5f, 0.5f, 0.5f, 1});
    for (const double gloss : {0.0, 0.5})
    {
        grid.Add("Shade(a.xyz, b.xyz, float3(0, 0.6, 0.8), " + std::to_string(gloss) + ")",
                 CombineVectors(UnitVectors(), {{0, 0, 1}, {0, 1, 0}, {0.6, 0.8, 0}}),
                 [=](auto& a, auto& b, auto&)
                 {
                     const dvec3 n(a), l(b), light(1, 2, 3), albedo(0.5, 0.25, 1);
                     const dvec3 h = glm::normalize(l + dvec3(0, 0.6, 0.8));
                     const double cosine = std::max(0.0, glm::dot(n, h));
                     const double shine = std::pow(cosine, 32) * gloss;
                     const dvec3 direct =
                         albedo * light * std::max(0.0, glm::dot(n, l)) + light * (0.5 * shine);
                     return dvec4(direct + albedo * dvec3(0.1, 0.2, 0.3), 0.75);
                 },
                 {1e-4, 1e-5});
    }
    grid.Run();
}

TEST_F(BuiltinPasses, AddUpTheLightsOfVertexLitPasses)
{
    FunctionGrid grid("#include \"UnityCG.cginc\"\n", ProgramLanguage::Cg);
    std::ranges::copy(k_Identity, grid.perDraw.objectToWorld);
    std::ranges::copy(k_Identity, grid.perDraw.worldToObject);
    grid.SetGlobal("unity_MatrixV", k_Identity);
    grid.SetGlobal("unity_MatrixInvV", k_Identity);
    grid.SetGlobal("unity_AmbientSky", {0.1f, 0.2f, 0.3f, 0});
    const auto two = [](std::vector<float> values)
    {
        values.resize(32, 0.0f);
        return values;
    };
    grid.SetGlobal("unity_LightColor", two({1, 0, 0, 0, 0, 1, 0, 0}));
    grid.SetGlobal("unity_LightPosition", two({0, 0.6f, 0.8f, 0, 1, 2, 3, 1}));
    // The second light: cosines of half and a quarter of its angle 0.5 and 0.75, falloff 2.
    grid.SetGlobal("unity_LightAtten", two({-1, 1, 0, 0, 0.5f, 4, 2, 0}));
    grid.SetGlobal("unity_SpotDirection", two({0, 0, 1, 0, 0, 0.6f, 0.8f, 0}));
    const auto lit = [](dvec3 at, dvec3 normal, bool spot)
    {
        const dvec3 to = dvec3(1, 2, 3) - at;
        const dvec3 direction = glm::normalize(to);
        const double cone = (glm::dot(direction, dvec3(0, 0.6, 0.8)) - 0.5) * 4;
        const double falloff =
            (spot ? std::clamp(cone, 0.0, 1.0) : 1.0) / (1 + 2 * glm::dot(to, to));
        return dvec3(0.1 + std::max(0.0, glm::dot(normal, dvec3(0, 0.6, 0.8))),
                     0.2 + std::max(0.0, glm::dot(normal, direction)) * falloff, 0.3);
    };
    const auto inputs = CombineVectors({{0, 0, 0}, {0, 3, 1}, {1, 1, 2.5}}, UnitVectors());
    grid.Add("ShadeVertexLights(float4(a.xyz, 1), b.xyz)", inputs,
             [=](auto& a, auto& b, auto&) { return lit(dvec3(a), dvec3(b), false); });
    grid.Add("ShadeVertexLightsFull(float4(a.xyz, 1), b.xyz, 2, true).yz", inputs,
             [=](auto& a, auto& b, auto&)
             {
                 const dvec3 sum = lit(dvec3(a), dvec3(b), true);
                 return glm::dvec2(sum.y, sum.z);
             });
    grid.Run();
}

TEST_F(BuiltinPasses, ShadeForSmallDevices)
{
    FunctionGrid grid(R"(
        #include "UnityStandardBRDF.cginc"
        float3 Shade(float3 n, float3 l, float smoothness)
        {
            UnityLight light;
            light.color = float3(1, 0.5, 2);
            light.dir = l;
            light.ndotl = 0;
            UnityIndirect gi;
            gi.diffuse = float3(0.1, 0.2, 0.3);
            gi.specular = float3(0.4, 0.5, 0.6);
            return BRDF2_Unity_PBS(float3(0.7, 0.2, 0.1), float3(0.04, 0.04, 0.04), 0.96, smoothness,
                                   n, float3(0, 0, 1), light, gi).rgb;
        })",
                      ProgramLanguage::Cg);
    grid.Add("Shade(a.xyz, b.xyz, c.x)",
             CombineVectors(UnitVectors(), UnitVectors(), {{0, 0, 0}, {0.5, 0, 0}, {0.7, 0, 0}}),
             [](auto& a, auto& b, auto& c)
             {
                 const dvec3 n(a), l(b), v(0, 0, 1);
                 const double perceptual = 1 - c.x;
                 const double rough = perceptual * perceptual;
                 const dvec3 h = (l + v) / std::sqrt(std::max(0.001, glm::dot(l + v, l + v)));
                 const auto clamped = [](double x)
                 {
                     return std::clamp(x, 0.0, 1.0);
                 };
                 const double nl = clamped(glm::dot(n, l));
                 const double nh = clamped(glm::dot(n, h));
                 const double nv = clamped(glm::dot(n, v));
                 const double lh = clamped(glm::dot(l, h));
                 const double d = nh * nh * (rough * rough - 1) + 1.00001;
                 const double specular =
                     rough * rough / (d * d * std::max(0.1, lh * lh) * (4 * rough + 2));
                 const double grazing = clamped(c.x + 0.04);
                 const double mirrored = (1 - 0.28 * rough * perceptual) *
                                         (0.04 + (grazing - 0.04) * std::pow(1 - nv, 4));
                 const dvec3 diffuse(0.7, 0.2, 0.1);
                 return (diffuse + 0.04 * specular) * dvec3(1, 0.5, 2) * nl +
                        diffuse * dvec3(0.1, 0.2, 0.3) + dvec3(0.4, 0.5, 0.6) * mirrored;
             },
             {1e-3, 1e-4});
    grid.Run();
}

} // namespace
} // namespace limn::test
