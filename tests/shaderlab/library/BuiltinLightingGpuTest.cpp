#include "library/Formulas.h"
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

using BuiltinLighting = GpuTest;

constexpr const char* k_Includes = "#include \"UnityPBSLighting.cginc\"\n"
                                   "#include \"UnityUI.cginc\"\n"
                                   "#include \"AutoLight.cginc\"\n";

const std::vector<double> k_LobeCosines = {0.0, 1e-4, 0.05, 0.3, 0.7071, 0.99, 1.0};
const std::vector<double> k_LobeRoughness = {0.002, 0.05, 0.25, 0.5, 1.0};

TEST_F(BuiltinLighting, AddsUpSphericalHarmonics)
{
    FunctionGrid grid(k_Includes, ProgramLanguage::Cg);
    const double r[] = {0.1, -0.2, 0.3, 0.5, 0.05, -0.06, 0.07, 0.08};
    const double c[] = {0.11, -0.12, 0.13};
    const auto vector = [&](int first, double scale)
    {
        std::vector<float> values;
        for (int i = first; i < first + 4; ++i)
        {
            values.push_back(static_cast<float>(r[i] * scale));
        }
        return values;
    };
    grid.SetGlobal("unity_SHAr", vector(0, 1));
    grid.SetGlobal("unity_SHAg", vector(0, 2));
    grid.SetGlobal("unity_SHAb", vector(0, -3));
    grid.SetGlobal("unity_SHBr", vector(4, 1));
    grid.SetGlobal("unity_SHBg", vector(4, 2));
    grid.SetGlobal("unity_SHBb", vector(4, -3));
    grid.SetGlobal("unity_SHC", {0.11f, -0.12f, 0.13f, 0});
    grid.Add("ShadeSH9(float4(a.xyz, 1))", CombineVectors(UnitVectors()),
             [=](auto& n, auto&, auto&)
             {
                 const double one = r[0] * n.x + r[1] * n.y + r[2] * n.z + r[3];
                 const double two =
                     r[4] * n.x * n.y + r[5] * n.y * n.z + r[6] * n.z * n.z + r[7] * n.z * n.x;
                 const double last = n.x * n.x - n.y * n.y;
                 return dvec3(one + two + c[0] * last, 2 * (one + two) + c[1] * last,
                              -3 * (one + two) + c[2] * last);
             });
    grid.Run();
}

TEST_F(BuiltinLighting, AddsUpFourPointLights)
{
    FunctionGrid grid(std::string(k_Includes) + R"(
        float3 Lit(float3 pos, float3 normal)
        {
            return Shade4PointLights(float4(0, 5, -3, 1), float4(2, 0, 1, 1), float4(0, 0, 4, 1),
                                     float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1),
                                     float3(1, 1, 1), float4(0, 0.5, 1, 25), pos, normal);
        })",
                      ProgramLanguage::Cg);
    grid.Add("Lit(a.xyz, b.xyz)",
             CombineVectors({{0, 0, 0}, {1, 1, 2}, {-20, 3, 7}}, UnitVectors()),
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 positions[] = {{0, 2, 0}, {5, 0, 0}, {-3, 1, 4}, {1, 1, 1}};
                 const dvec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
                 const double falloff[] = {0, 0.5, 1, 25};
                 dvec3 sum(0);
                 for (int i = 0; i < 4; ++i)
                 {
                     const dvec3 to = positions[i] - dvec3(a);
                     const double cosine = std::max(0.0, glm::dot(glm::normalize(to), dvec3(b)));
                     sum += colors[i] * (cosine / (1 + glm::dot(to, to) * falloff[i]));
                 }
                 return sum;
             },
             {2e-5, 1e-5});
    grid.Run();
}

TEST_F(BuiltinLighting, FollowsTheMicrofacetFormulas)
{
    FunctionGrid grid(k_Includes, ProgramLanguage::Cg);
    const Tolerance tolerance{2e-5, 1e-6};
    const auto schlick = [](double f0, double f90, double cosine)
    {
        return f0 + (f90 - f0) * std::pow(1 - cosine, 5);
    };
    grid.Add(
        "FresnelTerm(a.x, b.x).x", Combine({0.0, 0.04, 0.5, 1.0}, k_LobeCosines),
        [=](auto& a, auto& b, auto&) { return schlick(a.x, 1, b.x); }, tolerance);
    grid.Add(
        "FresnelLerp(a.x, b.x, c.x).y", Combine({0.04, 1.0}, {0.3, 1.0}, k_LobeCosines),
        [=](auto& a, auto& b, auto& c) { return schlick(a.x, b.x, c.x); }, tolerance);
    grid.Add(
        "FresnelLerpFast(a.x, b.x, c.x).z", Combine({0.04, 1.0}, {0.3, 1.0}, k_LobeCosines),
        [](auto& a, auto& b, auto& c) { return a.x + (b.x - a.x) * std::pow(1 - c.x, 4); },
        tolerance);
    // Trowbridge-Reitz; the device subtracts near numbers at the top of narrow lobes.
    grid.Add("GGXTerm(a.x, b.x)", Combine(k_LobeCosines, {0.05, 0.25, 0.5, 1.0}),
             [](auto& a, auto& b, auto&)
             {
                 const double a2 = b.x * b.x;
                 const double d = a.x * a.x * (a2 - 1) + 1;
                 return a2 / k_Pi / (d * d + 1e-7);
             },
             {1e-3, 1e-6});
    grid.Add(
        "SmithJointGGXVisibilityTerm(a.x, b.x, c.x)",
        Combine(k_LobeCosines, k_LobeCosines, k_LobeRoughness),
        [](auto& a, auto& b, auto& c)
        {
            const double view = a.x * (b.x + c.x - b.x * c.x);
            const double light = b.x * (a.x + c.x - a.x * c.x);
            return 0.5 / (view + light + 1e-5);
        },
        tolerance);
    grid.Add(
        "SmithBeckmannVisibilityTerm(a.x, b.x, c.x)",
        Combine(k_LobeCosines, k_LobeCosines, k_LobeRoughness),
        [](auto& a, auto& b, auto& c)
        {
            const double k = c.x * std::sqrt(2 / k_Pi);
            return 0.25 / ((a.x * (1 - k) + k) * (b.x * (1 - k) + k) + 1e-5);
        },
        tolerance);
    grid.Add(
        "DisneyDiffuse(a.x, b.x, c.x, 0.3)", Combine(k_LobeCosines, k_LobeCosines, k_LobeCosines),
        [](auto& a, auto& b, auto& c)
        {
            const double f = 0.5 + 2 * c.x * c.x * 0.3 - 1;
            return (1 + f * std::pow(1 - a.x, 5)) * (1 + f * std::pow(1 - b.x, 5));
        },
        tolerance);
    grid.Add("PerceptualRoughnessToSpecPower(a.x)", Combine({0.0, 0.1, 0.3, 0.6, 0.999, 1.0}),
             [](auto& a, auto&, auto&)
             { return std::max(1e-4, 2 / std::max(1e-4, std::pow(a.x, 4)) - 2); },
             {1e-4, 1e-4});
    grid.Add("NDFBlinnPhongNormalizedTerm(a.x, b.x)", Combine({0.5, 0.9, 1.0}, {1.0, 10.0, 100.0}),
             [](auto& a, auto& b, auto&) { return (b.x + 2) / (2 * k_Pi) * std::pow(a.x, b.x); },
             {1e-4, 1e-6});
    grid.Run();
}

TEST_F(BuiltinLighting, ShadesAStandardSurface)
{
    FunctionGrid grid(std::string(k_Includes) + R"(
        float3 Shade(float3 n, float3 l, float smoothness)
        {
            UnityLight light;
            light.color = float3(1, 0.5, 2);
            light.dir = l;
            light.ndotl = 0;
            UnityIndirect gi;
            gi.diffuse = float3(0.1, 0.2, 0.3);
            gi.specular = float3(0.4, 0.5, 0.6);
            return BRDF1_Unity_PBS(float3(0.7, 0.2, 0.1), float3(0.04, 0.04, 0.04), 0.96, smoothness,
                                   n, float3(0, 0, 1), light, gi).rgb;
        })",
                      ProgramLanguage::Cg);
    grid.Add("Shade(a.xyz, b.xyz, c.x)",
             CombineVectors(UnitVectors(), UnitVectors(), {{0, 0, 0}, {0.5, 0, 0}, {0.8, 0, 0}}),
             [](auto& a, auto& b, auto& c)
             {
                 const dvec3 n(a), l(b), v(0, 0, 1);
                 const double perceptual = 1 - c.x;
                 const double rough = std::max(0.002, perceptual * perceptual);
                 const dvec3 sum = l + v;
                 const dvec3 h = sum / std::sqrt(std::max(0.001, glm::dot(sum, sum)));
                 const double nv = std::abs(glm::dot(n, v));
                 const double nl = std::clamp(glm::dot(n, l), 0.0, 1.0);
                 const double nh = std::clamp(glm::dot(n, h), 0.0, 1.0);
                 const double lh = std::clamp(glm::dot(l, h), 0.0, 1.0);
                 const double f = 2 * lh * lh * perceptual - 0.5;
                 const double diffuse =
                     nl * (1 + f * std::pow(1 - nl, 5)) * (1 + f * std::pow(1 - nv, 5));
                 const double a2 = rough * rough;
                 const double d = nh * nh * (a2 - 1) + 1;
                 const double visibility = 0.5 / (nl * (nv * (1 - rough) + rough) +
                                                  nv * (nl * (1 - rough) + rough) + 1e-5);
                 const double specular = visibility * a2 / (d * d + 1e-7) * nl;
                 const double fresnel = 0.04 + 0.96 * std::pow(1 - lh, 5);
                 const double grazing = std::min(1.0, c.x + 0.04);
                 const double mirrored = (0.04 + (grazing - 0.04) * std::pow(1 - nv, 5)) / (a2 + 1);
                 const dvec3 color(1, 0.5, 2);
                 return dvec3(0.7, 0.2, 0.1) * (dvec3(0.1, 0.2, 0.3) + color * diffuse) +
                        color * (specular * fresnel) + dvec3(0.4, 0.5, 0.6) * mirrored;
             },
             {1e-3, 1e-4});
    grid.Run();
}

TEST_F(BuiltinLighting, SplitsLightBetweenDiffuseAndSpecular)
{
    FunctionGrid grid(std::string(k_Includes) + R"(
        float4 Metallic(float3 albedo, float metallic)
        {
            half3 specular;
            half rest;
            half3 diffuse = DiffuseAndSpecularFromMetallic(albedo, metallic, specular, rest);
            return float4(diffuse + specular * 2, rest);
        }
        float4 Specular(float3 albedo, float3 specular)
        {
            half rest;
            return float4(EnergyConservationBetweenDiffuseAndSpecular(albedo, specular, rest), rest);
        })",
                      ProgramLanguage::Cg);
    grid.Add("Metallic(a.xyz, b.x)", CombineVectors(Colors(), {{0, 0, 0}, {0.3, 0, 0}, {1, 0, 0}}),
             [](auto& a, auto& b, auto&)
             {
                 const double rest = 0.96 * (1 - b.x);
                 const dvec3 specular = dvec3(0.04) + (dvec3(a) - 0.04) * b.x;
                 return dvec4(dvec3(a) * rest + specular * 2.0, rest);
             });
    grid.Add("Specular(a.xyz, b.xyz)", CombineVectors(Colors(), {{0, 0, 0}, {0.2, 0.6, 0.1}}),
             [](auto& a, auto& b, auto&)
             {
                 const double rest = 1 - std::max({b.x, b.y, b.z});
                 return dvec4(dvec3(a) * rest, rest);
             });
    grid.Add("LerpWhiteTo(a.xyz, b.x)",
             CombineVectors(Colors(), {{0, 0, 0}, {0.25, 0, 0}, {1, 0, 0}}),
             [](auto& a, auto& b, auto&) { return 1.0 + (dvec3(a) - 1.0) * b.x; });
    grid.Add("BlendNormals(a.xyz, b.xyz)",
             CombineVectors({{0, 0, 1}, {0.6, 0, 0.8}}, {{0, 0, 1}, {0, -0.6, 0.8}}),
             [](auto& a, auto& b, auto&)
             { return glm::normalize(dvec3(a.x + b.x, a.y + b.y, a.z * b.z)); });
    grid.Add("UnpackScaleNormal(float4(a.xyz, 1), b.x)",
             CombineVectors({{0.5, 0.5, 1}, {0.75, 0.25, 0}}, {{0, 0, 0}, {1, 0, 0}, {1.3, 0, 0}}),
             [](auto& a, auto& b, auto&)
             {
                 const double x = (a.x * 2 - 1) * b.x;
                 const double y = (a.y * 2 - 1) * b.x;
                 return dvec3(x, y, std::sqrt(1 - std::min(1.0, x * x + y * y)));
             });
    grid.Run();
}

TEST_F(BuiltinLighting, ClipsAndColorsTheUserInterface)
{
    FunctionGrid grid(k_Includes, ProgramLanguage::Cg);
    grid.Add(
        "UnityGet2DClipping(a.xy, float4(-1, 0, 2, 3))",
        CombineVectors({{0, 1, 0}, {-1, 0, 0}, {2, 3, 0}, {-1.01, 1, 0}, {0, 3.01, 0}, {5, 5, 0}}),
        [](auto& a, auto&, auto&)
        { return a.x >= -1 && a.x <= 2 && a.y >= 0 && a.y <= 3 ? 1.0 : 0.0; });
    // Unity's fit comes within half a step of 8 bits below white; at white it gives the sum of its
    // coefficients.
    grid.Add("UIGammaToLinear(a.xxx).z", Combine({0.0, 0.02, 0.04, 0.0725, 0.0726, 0.2, 0.5, 0.8}),
             [](auto& a, auto&, auto&)
             { return a.x <= 0.04045 ? a.x / 12.92 : std::pow((a.x + 0.055) / 1.055, 2.4); },
             {0.0, 0.5 / 255});
    grid.Add("UIGammaToLinear(a.xxx).x", Combine({1.0}),
             [](auto&, auto&, auto&) { return 0.99586413; });
    grid.Add("UnityMixRealtimeAndBakedShadows(a.x, 0.2, b.x)",
             Combine({0.0, 0.5, 1.0}, {0.0, 0.3, 1.0}),
             [](auto& a, auto& b, auto&) { return std::min(1.0, a.x + b.x); });
    grid.Run();
}

} // namespace
} // namespace limn::test
