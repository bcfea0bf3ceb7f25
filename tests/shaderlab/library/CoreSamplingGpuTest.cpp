#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// Sampling, hashes and the reflection terms that ray tracing takes, against their definitions.

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using CoreSampling = GpuTest;

dvec3 Spherical(double phi, double cosTheta)
{
    const double sinTheta = std::sqrt(std::max(0.0, 1 - cosTheta * cosTheta));
    return {sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta};
}

TEST_F(CoreSampling, HashesGiveTheNumbersOfTheirPublishedForm)
{
    FunctionGrid grid(CoreInclude("Hashes") + R"(
        float3 Tchou23(float2 v) { float3 o; Hash_Tchou_2_3_float(v, o); return o; }
        float3 Tchou33(float3 v) { half3 o; Hash_Tchou_3_3_half(v, o); return o; }
        float4 Firsts(float3 v)
        {
            float a; float2 b; float c;
            Hash_Tchou_2_1_float(v.xy, a);
            Hash_Tchou_2_2_float(v.xy, b);
            Hash_Tchou_3_1_float(v, c);
            return float4(a, b, c);
        }
        float Sine(float2 v) { float o; Hash_BetterSine_2_1_float(v, o); return o; }
        float2 Sines(float2 v) { float2 o; Hash_LegacySine_2_2_float(v, o); return o; }
        float Mod(float2 v) { float o; Hash_LegacyMod_2_1_float(v, o); return o; })");
    const auto unit = [](std::uint32_t x)
    {
        return (x >> 8) / 16777215.0;
    };
    const auto two = [=](const dvec4& v)
    {
        auto x = static_cast<std::uint32_t>(std::lround(v.x));
        auto y = static_cast<std::uint32_t>(std::lround(v.y));
        y ^= 1103515245U;
        x += y;
        x *= y;
        x ^= x >> 5;
        x *= 0x27d4eb2dU;
        y ^= x << 3;
        return dvec3(unit(x), unit(y), unit(x ^ (y << 5)));
    };
    const auto three = [=](const dvec4& v)
    {
        auto x = static_cast<std::uint32_t>(std::lround(v.x));
        auto y = static_cast<std::uint32_t>(std::lround(v.y));
        auto z = static_cast<std::uint32_t>(std::lround(v.z));
        x ^= 1103515245U;
        y ^= x + z;
        y *= 134775813U;
        z += x ^ y;
        y += x ^ z;
        x += y * z;
        x *= 0x27d4eb2dU;
        z ^= x << 3;
        y += z << 3;
        return dvec3(unit(x), unit(y), unit(z));
    };
    const auto places =
        CombineVectors({{0, 0, 0}, {1, 2, 3}, {-5, 7, -11}, {1000, -1, 4}, {2.3, 2.7, 3.1}});
    grid.Add("Tchou23(a.xy)", places, [=](auto& a, auto&, auto&) { return two(a); });
    grid.Add("Tchou33(a.xyz)", places, [=](auto& a, auto&, auto&) { return three(a); });
    grid.Add("Firsts(a.xyz)", places,
             [=](auto& a, auto&, auto&)
             {
                 const dvec3 v = two(a);
                 return dvec4(v.x, v.x, v.y, three(a).x);
             });
    // Large factors magnify what a float's sine is off by.
    const auto frac = [](double x)
    {
        return x - std::floor(x);
    };
    grid.Add("Sine(a.xy)", CombineVectors({{0.5, 0, 0}, {3, 4, 0}, {0, 0.1, 0}}),
             [=](auto& a, auto&, auto&)
             { return frac(std::sin((a.x * 12.9898 + a.y * 78.233) / 1000) * 43758.5453); },
             {0.0, 0.02, 43758.5453});
    grid.Add("Sines(a.xy)", CombineVectors({{0.01, 0, 0}, {0.002, 0.01, 0}}),
             [=](auto& a, auto&, auto&)
             {
                 return dvec2(frac(std::sin(a.x * 15.27 + a.y * 99.41)),
                              frac(std::sin(a.x * 47.63 + a.y * 89.98)));
             },
             {1e-5, 1e-6, 1});
    grid.Add("Mod(a.xy)", CombineVectors({{0, 0, 0}, {1, 2, 0}, {5, 100, 0}, {290, 3, 0}}),
             [=](auto& a, auto&, auto&)
             {
                 const double x = std::fmod(a.x, 289);
                 double p = std::fmod((34 * x + 1) * x, 289) + std::fmod(a.y, 289);
                 p = std::fmod((34 * p + 1) * p, 289);
                 return frac(p / 41) * 2 - 1;
             },
             {0.0, 2e-5});
    grid.Run();
}

TEST_F(CoreSampling, PointsAreSpreadEvenly)
{
    FunctionGrid grid(CoreInclude("Sampling/Sampling"));
    const auto numbers = Combine({0.0, 1.0, 2.0, 5.0, 20.0});
    grid.Add("Fibonacci2d((uint)a.x, 21)", numbers,
             [](auto& a, auto&, auto&)
             { return dvec2((a.x + 0.5) / 21, std::fmod(a.x * 13 / 21.0, 1.0)); },
             {1e-5, 3e-6});
    grid.Add("Golden2dSeq((uint)a.x, 10)", numbers,
             [](auto& a, auto&, auto&)
             { return dvec2((a.x + 0.5) / 10, std::fmod(a.x / ((1 + std::sqrt(5.0)) / 2), 1.0)); },
             {1e-5, 3e-6});
    grid.Add("float4(SampleDiskFibonacci((uint)a.x, 34), SampleSphereFibonacci((uint)a.x, 34))",
             numbers,
             [](auto& a, auto&, auto&)
             {
                 const double u = (a.x + 0.5) / 34;
                 const double turn = 2 * k_Pi * std::fmod(a.x * 21 / 34.0, 1.0);
                 return dvec4(std::sqrt(u), turn, 1 - 2 * u, turn);
             },
             {1e-5, 2e-5});
    grid.Add("Hammersley2d((uint)a.x, 32)", Combine({0.0, 1.0, 6.0, 31.0}),
             [](auto& a, auto&, auto&)
             {
                 double mirrored = 0.0;
                 for (int bit = 0; bit < 5; ++bit)
                 {
                     mirrored += ((int(a.x) >> bit) & 1) * std::pow(0.5, bit + 1);
                 }
                 return dvec2(a.x / 32, mirrored);
             });
    const auto pairs = Combine({0.0, 0.2, 0.7, 1.0}, {0.0, 0.3, 0.9});
    const Tolerance near{1e-5, 2e-6, 1};
    grid.Add(
        "SampleDiskUniform(a.x, b.x)", pairs,
        [](auto& a, auto& b, auto&)
        { return dvec2(Spherical(2 * k_Pi * b.x, 0)) * std::sqrt(a.x); },
        near);
    grid.Add("SampleSphereUniform(a.x, b.x)", pairs,
             [](auto& a, auto& b, auto&) { return Spherical(2 * k_Pi * b.x, 1 - 2 * a.x); },
             {1e-5, 4e-4}); // the sine near a pole is out of a small difference
    grid.Add("SampleHemisphereCosine(a.x, b.x)", pairs,
             [](auto& a, auto& b, auto&) { return Spherical(2 * k_Pi * b.x, std::sqrt(1 - a.x)); },
             {1e-5, 4e-4});
    grid.Add("SampleConeUniform(a.x, b.x, 0.5)", pairs,
             [](auto& a, auto& b, auto&) { return Spherical(2 * k_Pi * b.x, 0.5 + 0.5 * a.x); },
             {1e-5, 4e-4});
    grid.Add("SampleConeStrata((uint)a.x, 0.04, 0.25)", numbers,
             [](auto& a, auto&, auto&)
             {
                 const double golden = k_Pi * (3 - std::sqrt(5.0));
                 return Spherical(a.x * golden, 1 - 0.75 * a.x * 0.04);
             },
             {1e-5, 1e-5, 1});
    grid.Add("CubemapTexelToDirection(float2(a.x, b.x), 1)", pairs,
             [](auto& a, auto& b, auto&) { return glm::normalize(dvec3(-1, -b.x, a.x)); });
    grid.Run();
}

TEST_F(CoreSampling, LightsAreSampledOverTheirAreas)
{
    FunctionGrid grid(CoreInclude("Sampling/Sampling") + R"(
        static const float4x4 k_Light = {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 5, 6, 7, 1};
        float4 Rectangle(float2 u) { float p; float3 P, N; SampleRectangle(u, k_Light, 4, 2, p, P, N); return float4(P, p); }
        float4 RectangleN(float2 u) { float p; float3 P, N; SampleRectangle(u, k_Light, 4, 2, p, P, N); return float4(N, p); }
        float4 Cylinder(float2 u) { float p; float3 P, N; SampleCylinder(u, k_Light, 0.5, 3, p, P, N); return float4(P, p); }
        float4 Disk(float2 u) { float p; float3 P, N; SampleDisk(u, k_Light, 2, p, P, N); return float4(P, p); }
        float4 Ball(float2 u) { float p; float3 P, N; SampleSphere(u, k_Light, 2, p, P, N); return float4(P, p); })");
    // The light's x, y and z are the world's y, z and x.
    const auto world = [](const dvec3& v)
    {
        return dvec3(v.z, v.x, v.y) + dvec3(5, 6, 7);
    };
    const auto pairs = Combine({0.1, 0.5, 0.9}, {0.0, 0.3});
    grid.Add("Rectangle(float2(a.x, b.x))", pairs,
             [=](auto& a, auto& b, auto&) {
                 return dvec4(world({(a.x - 0.5) * 4, (b.x - 0.5) * 2, 0}), 1.0 / 8);
             });
    grid.Add("RectangleN(float2(a.x, b.x))", pairs,
             [](auto&, auto&, auto&) { return dvec4(-1, 0, 0, 1.0 / 8); });
    grid.Add("Cylinder(float2(a.x, b.x))", pairs,
             [=](auto& a, auto& b, auto&)
             {
                 const double angle = 2 * k_Pi * b.x;
                 return dvec4(
                     world({(a.x - 0.5) * 3, std::cos(angle) * 0.5, std::sin(angle) * 0.5}),
                     1 / (2 * k_Pi * 0.5 * 3));
             },
             {1e-5, 1e-6, 1});
    grid.Add("Disk(float2(a.x, b.x))", pairs,
             [=](auto& a, auto& b, auto&)
             {
                 const dvec2 at = dvec2(Spherical(2 * k_Pi * b.x, 0)) * (2 * std::sqrt(a.x));
                 return dvec4(world({at, 0}), 1 / (k_Pi * 4));
             },
             {1e-5, 1e-6, 2});
    grid.Add("Ball(float2(a.x, b.x))", pairs,
             [](auto& a, auto& b, auto&)
             {
                 const dvec3 at = 2.0 * Spherical(2 * k_Pi * b.x, 1 - 2 * a.x) + dvec3(5, 6, 7);
                 return dvec4(at, 1 / (4 * k_Pi * 4));
             },
             {1e-5, 1e-6, 2});
    grid.Run();
}

TEST_F(CoreSampling, MaterialsOfRayTracersFollowTheirFormulas)
{
    FunctionGrid grid(CoreInclude("BSDF"));
    const auto inputs = Combine({0.1, 0.5, 0.95}, {0.2, 0.8}, {0.1, 0.6, 1.0});
    // Smith's masking of GGX by its slope: (sqrt(1 + a^2 tan^2) - 1) / 2.
    const auto lambda = [](double cosine, double roughness)
    {
        const double tangent2 = 1 / (cosine * cosine) - 1;
        return (std::sqrt(1 + roughness * roughness * tangent2) - 1) / 2;
    };
    grid.Add("Lambda_GGX(c.x, float3(sqrt(1 - a.x * a.x) * float2(0.6, 0.8), a.x))", inputs,
             [=](auto& a, auto&, auto& c) { return lambda(a.x, c.x); }, {1e-4, 1e-6});
    grid.Add("G_MaskingSmithGGX(a.x, c.x)", inputs,
             [=](auto& a, auto&, auto& c) { return 1 / (1 + lambda(a.x, c.x)); }, {2e-5, 1e-6});
    grid.Add("V_SmithJointGGX(a.x, b.x, c.x, GetSmithJointGGXPartLambdaV(b.x, c.x))", inputs,
             [=](auto& a, auto& b, auto& c)
             { return 1 / (1 + lambda(a.x, c.x) + lambda(b.x, c.x)) / (4 * a.x * b.x); },
             {2e-5, 1e-6});
    grid.Add("V_SmithJointGGXAniso(0.3, 0.4, a.x, 0.1, -0.2, b.x, c.x, 0.5)", inputs,
             [](auto& a, auto& b, auto& c)
             {
                 const double v = glm::length(dvec3(0.3 * c.x, 0.4 * 0.5, a.x));
                 const double l = glm::length(dvec3(0.1 * c.x, -0.2 * 0.5, b.x));
                 return 0.5 / (b.x * v + a.x * l);
             },
             {2e-5, 1e-6});
    grid.Add("V_SmithJointGGXApprox(a.x, b.x, c.x)", inputs,
             [](auto& a, auto& b, auto& c)
             {
                 const auto line = [&](double x)
                 {
                     return x * (1 - c.x) + c.x;
                 };
                 return 0.5 / (a.x * line(b.x) + b.x * line(a.x));
             });
    // Fresnel's equations with a complex index of refraction.
    grid.Add("F_FresnelConductor(float3(0.2, 1.0, 2.5), float3(9, 4, 16), a.x)", inputs,
             [](auto& a, auto&, auto&)
             {
                 const auto reflect = [&](double n, double k2)
                 {
                     const double k = std::sqrt(k2);
                     const std::complex<double> index(n, k);
                     const double sine2 = 1 - a.x * a.x;
                     const std::complex<double> root = std::sqrt(index * index - sine2);
                     const auto s = (a.x - root) / (a.x + root);
                     const auto p = (index * index * a.x - root) / (index * index * a.x + root);
                     return (std::norm(s) + std::norm(p)) / 2;
                 };
                 return dvec3(reflect(0.2, 9), reflect(1, 4), reflect(2.5, 16));
             },
             {1e-4, 1e-5});
    grid.Add("F_Transm_Schlick(float3(0.04, 0.5, 1), a.x)", inputs,
             [](auto& a, auto&, auto&)
             { return (1.0 - dvec3(0.04, 0.5, 1)) * (1 - std::pow(1 - a.x, 5)); },
             {1e-5, 1e-6});
    grid.Add("GetProjectedRoughness(0.3, 0.4, sqrt(0.75), c.x, 0.5)", inputs,
             [](auto&, auto&, auto& c)
             { return std::sqrt((0.09 * c.x * c.x + 0.16 * 0.25) / 0.25); },
             {1e-5, 1e-6});
    // What the clear coat leaves of it, exactly; the polynomial is near it.
    grid.Add("ConvertF0ForAirInterfaceToF0ForClearCoat15(a.x)", Combine({0.04, 0.2, 0.5, 0.9, 1.0}),
             [](auto& a, auto&, auto&)
             {
                 const double root = std::sqrt(a.x);
                 return std::pow((1 - 5 * root) / (5 - root), 2);
             },
             {0.0, 0.006});
    grid.Run();
}

TEST_F(CoreSampling, DirectionsFollowTheMaterialsLobe)
{
    FunctionGrid grid(CoreInclude("ImageBasedLighting") + R"(
        static const float3x3 k_Frame = {0, 1, 0, 0, 0, 1, 1, 0, 0};
        float4 Ggx(float2 u, float3 V, float r)
        {
            float3 L; float NdotL, NdotH, VdotH;
            SampleGGXDir(u, V, k_Frame, r, L, NdotL, NdotH, VdotH);
            return float4(L, NdotH);
        }
        float4 Weight(float2 u, float3 V, float r)
        {
            float3 L; float VdotH, NdotL, weight;
            ImportanceSampleGGX(u, V, k_Frame, r, V.x, L, VdotH, NdotL, weight);
            return float4(L, weight);
        }
        float4 Aniso(float2 u, float3 V, float r)
        {
            float3 L; float VdotH, NdotL, weight;
            ImportanceSampleAnisoGGX(u, V, k_Frame, r, r, V.x, L, VdotH, NdotL, weight);
            return float4(L, weight);
        }
        float4 Visible(float2 u, float3 V, float r)
        {
            float3 v, h; float VdotH;
            SampleGGXVisibleNormal(u, V, k_Frame, r, v, h, VdotH);
            return float4(h, VdotH);
        })");
    std::vector<GridInput> inputs;
    for (const double u : {0.1, 0.45, 0.8})
    {
        for (const double v : {0.05, 0.6})
        {
            for (const double roughness : {0.2, 0.7})
            {
                inputs.push_back(
                    {dvec4(u, v, 0, 0), dvec4(0.8, 0.36, 0.48, 0), dvec4(roughness, 0, 0, 0)});
            }
        }
    }
    // The surface looks along x; local x, y, z are the world's y, z, x.
    struct Sample
    {
        dvec3 half, light;
        double weight;
    };
    const auto sample = [](const dvec4& a, const dvec4& b, const dvec4& c)
    {
        const double r2 = c.x * c.x;
        const dvec3 half = Spherical(2 * k_Pi * a.y, std::sqrt((1 - a.x) / (1 + (r2 - 1) * a.x)));
        const dvec3 view(b.y, b.z, b.x);
        // A facet that is seen from behind reflects nothing: what came goes on.
        const double seen = std::max(0.0, glm::dot(view, half));
        const dvec3 light = 2.0 * seen * half - view;
        const auto lambda = [&](double cosine)
        {
            return (std::sqrt(1 + r2 * (1 / (cosine * cosine) - 1)) - 1) / 2;
        };
        // G (V.H) / ((N.H) (N.V))
        const double weight =
            glm::dot(view, half) / (half.z * view.z) / (1 + lambda(light.z) + lambda(view.z));
        return Sample{half, dvec3(light.z, light.x, light.y), light.z > 0 ? weight : 0.0};
    };
    grid.Add("Ggx(a.xy, b.xyz, c.x)", inputs,
             [=](auto& a, auto& b, auto& c)
             {
                 const Sample s = sample(a, b, c);
                 return dvec4(s.light, s.half.z);
             },
             {1e-4, 1e-5, 2});
    std::vector<GridInput> above = inputs;
    std::erase_if(above, [=](const GridInput& i) { return sample(i.a, i.b, i.c).light.x < 0.05; });
    grid.Add("Weight(a.xy, b.xyz, c.x)", above,
             [=](auto& a, auto& b, auto& c)
             {
                 const Sample s = sample(a, b, c);
                 return dvec4(s.light, s.weight);
             },
             {1e-4, 1e-5, 2});
    // With the same roughness both ways the anisotropic lobe is the same lobe, sampled by tan^2 =
    // r^2 u / (1 - u), which is the isotropic one's.
    grid.Add("Aniso(a.xy, b.xyz, c.x)", above,
             [=](auto& a, auto& b, auto& c)
             {
                 const Sample s = sample(a, b, c);
                 return dvec4(s.light, s.weight);
             },
             {1e-4, 1e-5, 2});
    // Seen from above, every facet is seen as large as it is: the slopes of a disc, stretched.
    std::vector<GridInput> front = inputs;
    for (GridInput& input : front)
    {
        input.b = dvec4(1, 0, 0, 0);
    }
    grid.Add("Visible(a.xy, b.xyz, c.x)", front,
             [](auto& a, auto&, auto& c)
             {
                 const dvec3 flat(std::sqrt(a.x) * std::cos(2 * k_Pi * a.y),
                                  std::sqrt(a.x) * std::sin(2 * k_Pi * a.y), std::sqrt(1 - a.x));
                 const dvec3 h = glm::normalize(flat * dvec3(c.x, c.x, 1));
                 return dvec4(h, h.z);
             },
             {1e-4, 1e-5, 2});
    grid.Add("GetSpecularDominantDir(float3(0, 0, 1), float3(1, 0, 0), a.x, 0.5)",
             Combine({0.0, 0.5, 1.0}),
             [](auto& a, auto&, auto&)
             {
                 const double p2 = a.x * a.x;
                 const double s = 1 - p2;
                 const double t = (std::sqrt(s) + p2) * Saturate(s * s + s * 0.25);
                 return dvec3(t, 0, 1 - t);
             });
    grid.Run();
}

} // namespace
} // namespace limn::test
