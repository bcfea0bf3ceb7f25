#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// What materials do with light: cloth, rough diffuse surfaces, thin films, tables of them; and the
// small files of core.

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using MaterialTerms = GpuTest;

double Schlick(double f0, double cosine)
{
    return f0 + (1 - f0) * std::pow(1 - cosine, 5.0);
}

TEST_F(MaterialTerms, ClothHidesItsFibres)
{
    FunctionGrid grid(CoreInclude("BSDF"));
    // Estevez and Kulla, table 1: the five parameters at roughness 0 and 1, mixed by (1 - r)^2.
    const auto hidden = [](double cosine, double roughness)
    {
        const double rough[] = {21.5473, 3.82987, 0.19823, -1.97760, -4.32054};
        const double smooth[] = {25.3245, 3.32435, 0.16801, -1.27393, -4.85967};
        const double w = (1 - roughness) * (1 - roughness);
        double p[5];
        for (int i = 0; i < 5; ++i)
        {
            p[i] = w * smooth[i] + (1 - w) * rough[i];
        }
        const auto curve = [&](double x)
        {
            return p[0] / (1 + p[1] * std::pow(x, p[2])) + p[3] * x + p[4];
        };
        return cosine < 0.5 ? std::exp(curve(cosine))
                            : std::exp(2 * curve(0.5) - curve(1 - cosine));
    };
    const auto inputs = Combine({0.1, 0.4, 0.75, 1.0}, {0.2, 0.5, 0.9}, {0.05, 0.3, 0.6, 1.0});
    grid.Add("V_Charlie(a.x, b.x, c.x)", inputs,
             [=](auto& l, auto& v, auto& r)
             {
                 const double g = 1 / (1 + hidden(l.x, r.x) + hidden(v.x, r.x));
                 return g / (4 * l.x * v.x);
             },
             {1e-4, 1e-6});
    grid.Add("D_Charlie(a.x, c.x)", inputs,
             [](auto& h, auto&, auto& r)
             {
                 const double sine = std::sqrt(1 - h.x * h.x);
                 return (2 + 1 / r.x) * std::pow(sine, 1 / r.x) / (2 * k_Pi);
             },
             {1e-3, 1e-6});
    grid.Run();
}

TEST_F(MaterialTerms, RoughSurfacesScatterAsHammonHasIt)
{
    FunctionGrid grid(CoreInclude("BSDF"));
    // a: cosines of view, light and half way vector; b.x: of the angle between view and light
    std::vector<GridInput> inputs;
    for (const double between : {-0.5, 0.3, 1.0})
    {
        for (const double roughness : {0.0, 0.4, 1.0})
        {
            inputs.push_back({dvec4(0.3, 0.9, 0.6, 0), dvec4(between, roughness, 0, 0),
                              dvec4(0.2, 0.5, 0.9, 0)});
            inputs.push_back(
                {dvec4(1, 0.2, 0.8, 0), dvec4(between, roughness, 0, 0), dvec4(1, 0, 0.3, 0)});
        }
    }
    const auto scattered = [](const dvec4& a, const dvec4& b, const dvec4& albedo)
    {
        // Slides of GDC 2017, p. 113, in whose words alpha is the roughness
        const double facing = 0.5 + 0.5 * b.x;
        const double rough = facing * (0.9 - 0.4 * facing) * ((0.5 + a.z) / a.z);
        const double smooth = 1.05 * (1 - std::pow(1 - a.y, 5.0)) * (1 - std::pow(1 - a.x, 5.0));
        const double single = (smooth * (1 - b.y) + rough * b.y) / k_Pi;
        return single + dvec3(albedo) * (0.1159 * b.y);
    };
    grid.Add("DiffuseGGX(c.rgb, a.x, a.y, a.z, b.x, b.y)", inputs, scattered, {1e-4, 1e-6});
    grid.Add("DiffuseGGXNoPI(c.rgb, a.x, a.y, a.z, b.x, b.y)", inputs,
             [=](auto& a, auto& b, auto& c) { return dvec3(scattered(a, b, c)) * k_Pi; },
             {1e-4, 1e-6});
    grid.Run();
}

TEST_F(MaterialTerms, FilmsShineInTheColorsOfInterference)
{
    FunctionGrid grid(CoreInclude("BSDF"));
    // The Fourier transform of a Gaussian of each sensor, in metres; red has two.
    const auto sensed = [](double opd, double shift)
    {
        const auto lobe = [=](double height, double place, double variance)
        {
            const double frequency = 2 * k_Pi * opd * 1e-6;
            return height * std::sqrt(2 * k_Pi * variance) * std::cos(place * frequency + shift) *
                   std::exp(-variance * frequency * frequency) / 1.0685e-7;
        };
        const dvec3 xyz(lobe(5.4856e-13, 1.6810e6, 4.3278e9) + lobe(9.7470e-14, 2.2399e6, 4.5282e9),
                        lobe(4.4201e-13, 1.7953e6, 9.3046e9), lobe(5.2481e-13, 2.2084e6, 6.6121e9));
        const glm::dmat3 toRgb(3.2409699419, -0.9692436363, 0.0556300797, -1.5373831776,
                               1.8759675015, -0.2039769589, -0.4986107603, 0.0415550574,
                               1.0569715142);
        return toRgb * xyz;
    };
    grid.Add("EvalSensitivity(a.x, b.x)", Combine({0.0, 0.2, 0.5, 1.1}, {0.0, 1.0, k_Pi}),
             [=](auto& a, auto& b, auto&) { return sensed(a.x, b.x); }, {1e-3, 1e-4});
    const auto film = [=](double eta1, double cosine, double thickness, dvec3 base)
    {
        const double eta = 2 - thickness;
        const double sine2 = eta1 * eta1 / (eta * eta) * (1 - cosine * cosine);
        if (sine2 > 1)
        {
            return dvec3(1);
        }
        const double inner = std::sqrt(1 - sine2);
        const double r12 = Schlick(std::pow((eta - eta1) / (eta + eta1), 2.0), cosine);
        const double opd = 3 * thickness * inner;
        const dvec3 spectrum[3] = {dvec3(1), 2.0 * sensed(opd, k_Pi),
                                   2.0 * sensed(2 * opd, 2 * k_Pi)};
        dvec3 seen(0);
        for (int i = 0; i < 3; ++i)
        {
            const double r23 = Schlick(base[i], inner);
            const double both = std::clamp(r12 * r23, 1e-5, 0.9999);
            const double rs = (1 - r12) * (1 - r12) * r23 / (1 - both);
            seen[i] = r12 + rs;
            for (int m = 1; m <= 2; ++m)
            {
                seen[i] += (rs - (1 - r12)) * std::pow(both, m / 2.0) * spectrum[m][i];
            }
        }
        return glm::max(seen, dvec3(0));
    };
    std::vector<GridInput> inputs;
    for (const double thickness : {0.0, 0.25, 0.6, 1.0})
    {
        for (const double cosine : {0.2, 0.7, 1.0})
        {
            inputs.push_back({dvec4(1, cosine, thickness, 0), dvec4(0.04, 0.3, 0.9, 0)});
            inputs.push_back({dvec4(1.5, cosine, thickness, 0), dvec4(0.5, 0.02, 0.2, 0)});
        }
    }
    grid.Add("EvalIridescence(a.x, a.y, a.z, b.rgb)", inputs,
             [=](auto& a, auto& b, auto&) { return film(a.x, a.y, a.z, dvec3(b)); }, {2e-3, 2e-4});
    // The base's reflectance was told for air: its index, seen from the film
    grid.Add("EvalIridescence(a.x, a.y, a.z, b.rgb, 1.0)", inputs,
             [=](auto& a, auto& b, auto&)
             {
                 dvec3 base;
                 for (int i = 0; i < 3; ++i)
                 {
                     const double root = std::sqrt(b[i] + 0.0001);
                     const double ior = (1 + root) / (1 - root);
                     const double eta = 2 - a.z;
                     base[i] = std::pow((ior - eta) / (ior + eta), 2.0);
                 }
                 return film(a.x, a.y, a.z, base);
             },
             {2e-3, 2e-4});
    grid.Run();
}

/// Sums of a function over directions of a hemisphere about z, by the middles of a fine grid.
template <typename F>
double OverHemisphere(F f)
{
    const int rings = 600;
    const int steps = 600;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
    {
        const double cosine = (i + 0.5) / rings;
        const double sine = std::sqrt(1 - cosine * cosine);
        for (int j = 0; j < steps; ++j)
        {
            const double phi = 2 * k_Pi * (j + 0.5) / steps;
            sum += f(dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
        }
    }
    return sum * 2 * k_Pi / (rings * steps);
}

TEST_F(MaterialTerms, TablesOfReflectanceAreIntegralsOverTheHemisphere)
{
    FunctionGrid grid(CoreInclude("ImageBasedLighting"));
    // The light's directions, weighed by the reflection itself: no importance sampling.
    const auto integral = [](double cosine, double roughness)
    {
        const double a2 = roughness * roughness;
        const dvec3 view(std::sqrt(1 - cosine * cosine), 0, cosine);
        const auto smith = [=](double c)
        {
            return 2 / (1 + std::sqrt(1 + a2 * (1 - c * c) / (c * c)));
        };
        const auto lambda = [=](double c)
        {
            return 1 / smith(c) - 1;
        };
        const auto specular = [=](const dvec3& light)
        {
            const dvec3 h = glm::normalize(light + view);
            const double d = a2 / (k_Pi * std::pow(h.z * h.z * (a2 - 1) + 1, 2.0));
            const double g = 1 / (1 + lambda(light.z) + lambda(cosine));
            return std::pair(d * g / (4 * cosine), glm::dot(view, h));
        };
        const double all = OverHemisphere([=](const dvec3& l) { return specular(l).first; });
        const double grazing = OverHemisphere(
            [=](const dvec3& l)
            {
                const auto [value, vh] = specular(l);
                return value * std::pow(1 - vh, 5.0);
            });
        const double perceptual = std::sqrt(roughness);
        const double diffuse = OverHemisphere(
            [=](const dvec3& l)
            {
                const double fd90 = 0.5 + perceptual * (1 + glm::dot(l, view));
                const auto scatter = [=](double c)
                {
                    return 1 + (fd90 - 1) * std::pow(1 - c, 5.0);
                };
                return scatter(l.z) * scatter(cosine) / 1.03571 * l.z / k_Pi;
            });
        return dvec3(grazing, all, diffuse - 0.5);
    };
    // 4096 points of a quasi-random sequence, of which the sums are off by some thousandths.
    grid.Add("IntegrateGGXAndDisneyDiffuseFGD(a.x, b.x).xyz", Combine({0.3, 0.8}, {0.25, 0.7}),
             [=](auto& a, auto& b, auto&) { return integral(a.x, b.x); }, {0.0, 4e-3});
    grid.Run();
}

TEST_F(MaterialTerms, RaysMeetTheHeightsTheyLookInto)
{
    FunctionGrid grid(R"(
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
        struct PerPixelHeightDisplacementParam { float2 start; float slope; };
        // A slope along x; 0.6 where it starts
        float ComputePerPixelHeightDisplacement(float2 offset, float lod, PerPixelHeightDisplacementParam p)
        {
            return saturate(0.6 + p.slope * (p.start.x + offset.x));
        }
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/PerPixelDisplacement.hlsl"
        float3 Hit(float3 view, float slope, float lod)
        {
            PerPixelHeightDisplacementParam p;
            p.start = float2(0.1, 0.2);
            p.slope = slope;
            float height;
            float2 offset = ParallaxOcclusionMapping(lod, 4, 16, view, p, height);
            return float3(offset, height);
        })");
    const auto met = [](const dvec4& view, double slope)
    {
        // 1 - t = 0.6 + slope (0.1 - t x / z), where t is how deep the ray is
        const double t = (0.4 - slope * 0.1) / (1 - slope * view.x / view.z);
        return dvec3(-t * view.x / view.z, -t * view.y / view.z, 1 - t);
    };
    std::vector<GridInput> inputs;
    for (const double slope : {0.0, 0.5, -0.75})
    {
        inputs.push_back({dvec4(0.3, 0.1, 1, 0), dvec4(slope, 0, 0, 0)});
        inputs.push_back({dvec4(-0.5, 0.4, 0.8, 0), dvec4(slope, 0, 0, 0)});
    }
    grid.Add("Hit(a.xyz, b.x, 0)", inputs, [=](auto& a, auto& b, auto&) { return met(a, b.x); },
             {1e-4, 1e-4});
    // Between the level where it starts to fade and the next the offset goes to 0.
    grid.Add("Hit(a.xyz, b.x, 4.25)", inputs,
             [=](auto& a, auto& b, auto&)
             {
                 const dvec3 hit = met(a, b.x);
                 return dvec3(dvec2(hit) * 0.75, hit.z);
             },
             {1e-4, 1e-4});
    grid.Run();
}

TEST_F(MaterialTerms, SmallFilesDoWhatTheirNamesSay)
{
    FunctionGrid grid(CoreInclude("Common") + CoreInclude("SpaceFillingCurves") +
                      CoreInclude("SDF2D") + CoreInclude("CommonShadow"));
    const auto interleaved = [](int x, int y, int z, int axes)
    {
        const int of[] = {x, y, z};
        double code = 0;
        for (int bit = 0; bit < 8; ++bit)
        {
            for (int axis = 0; axis < axes; ++axis)
            {
                code += (of[axis] >> bit & 1) * std::pow(2.0, bit * axes + axis);
            }
        }
        return code;
    };
    const auto numbers = CombineVectors({{0, 0, 0}, {1, 2, 3}, {85, 170, 51}, {255, 255, 255}});
    grid.Add("EncodeMorton2D((uint2)a.xy)", numbers,
             [=](auto& a, auto&, auto&) { return interleaved(int(a.x), int(a.y), 0, 2); });
    grid.Add("EncodeMorton3D((uint3)a.xyz)", numbers,
             [=](auto& a, auto&, auto&) { return interleaved(int(a.x), int(a.y), int(a.z), 3); });
    grid.Add("float2(DecodeMorton2D(EncodeMorton2D((uint2)a.xy * 257u)))", numbers,
             [](auto& a, auto&, auto&) { return dvec2(a) * 257.0; });
    grid.Add("float3(DecodeMorton3D(EncodeMorton3D((uint3)a.xyz * 4u)))", numbers,
             [](auto& a, auto&, auto&) { return dvec3(a) * 4.0; });
    const auto places = CombineVectors({{0.5, 0.25, 0}, {-3, 0.5, 0}, {2, -4, 0}, {0.1, 1.5, 0}});
    grid.Add("CircleSDF(a.xy, 1.5)", places,
             [](auto& a, auto&, auto&) { return std::hypot(a.x, a.y) - 1.5; });
    grid.Add("RectangleSDF(a.xy, float2(1, 2))", places,
             [](auto& a, auto&, auto&)
             {
                 const double x = std::abs(a.x) - 1;
                 const double y = std::abs(a.y) - 2;
                 const bool isInside = x < 0 && y < 0;
                 return isInside ? std::max(x, y) : std::hypot(std::max(x, 0.0), std::max(y, 0.0));
             });
    grid.Add("EllipseSDF(a.xy, float2(2, 2))", places, // a circle
             [](auto& a, auto&, auto&) { return std::hypot(a.x, a.y) - 2; });
    grid.Add("GetShadowPosOffset(a.x, float3(0, 1, 0), 1.0 / 512)", places,
             [](auto& a, auto&, auto&) { return dvec3(0, Saturate(1 - a.x) / 256, 0); });
    grid.Run();
}

TEST_F(MaterialTerms, BrightDisplaysGetTheirRange)
{
    FunctionGrid grid(CoreInclude("HDROutput"));
    const auto quantized = [](double nits)
    {
        const double y = std::pow(nits / 10000, 0.1593017578125);
        return std::pow((0.8359375 + 18.8515625 * y) / (1 + 18.6875 * y), 78.84375);
    };
    const auto nits = [](double value)
    {
        const double y = std::pow(value, 1 / 78.84375);
        return 10000 * std::pow(std::max(y - 0.8359375, 0.0) / (18.8515625 - 18.6875 * y),
                                1 / 0.1593017578125);
    };
    const auto levels = Combine({1.0, 80.0, 400.0, 1000.0, 4000.0});
    grid.SetGlobal("_HDREncoding", {0}); // an integer 0: sRGB, as it is
    grid.Add("LinearToPQ(a.x)", levels, [=](auto& a, auto&, auto&) { return quantized(a.x); },
             {1e-4, 1e-6});
    grid.Add("LinearToPQ(a.xxx * 0.01, 100).y", levels,
             [=](auto& a, auto&, auto&) { return quantized(a.x); }, {1e-4, 1e-6});
    grid.Add("GTSApproxLinToPQ(a.xxx * 0.01).x", levels, // fitted, not exact
             [=](auto& a, auto&, auto&) { return quantized(a.x); }, {0.0, 2e-3});
    grid.Add("ReinhardTonemap(a.x, 1000)", levels,
             [](auto& a, auto&, auto&) { return 1 / (1 / a.x + 1 / 1000.0 - 1 / 10000.0); },
             {1e-4, 1e-4});
    const auto reduced = [=](double x)
    {
        // BT.2390, with a Hermite spline from the knee to where 10 000 nits lie
        const double top = quantized(600);
        const double knee = 1.5 * top - 0.5;
        double e = quantized(x);
        if (e > knee)
        {
            const double t = (e - knee) / (1 - knee);
            e = (2 * t * t * t - 3 * t * t + 1) * knee + (t * t * t - 2 * t * t + t) * (1 - knee) +
                (3 * t * t - 2 * t * t * t) * top;
        }
        return nits(e + quantized(0.05) * std::pow(1 - e, 4.0));
    };
    grid.Add("BT2390EETF(a.x, 0.05, 600)", levels,
             [=](auto& a, auto&, auto&) { return reduced(a.x); }, {2e-3, 1e-3});
    // Grey stays grey through ICtCp and back.
    grid.Add("HDRMappingFromRec709(a.xxx, 1, 0.05, 600, HDRRANGEREDUCTION_BT2390, 0)",
             Combine({5.0, 100.0, 500.0}),
             [=](auto& a, auto&, auto&) { return dvec3(reduced(a.x)); }, {1e-2, 1e-2});
    grid.Add("RotateICtCpToRec2020(RotateRec2020ToICtCp(a.rgb))",
             CombineVectors({{100, 20, 5}, {1, 300, 40}}),
             [](auto& a, auto&, auto&) { return dvec3(a); }, {1e-2, 0.1});
    grid.Run();
}

} // namespace
} // namespace limn::test
