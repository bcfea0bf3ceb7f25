#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vulkan/GpuTestDevice.h>

// Filters of shadows, refraction and polygons of light, against their geometry.

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

using CoreShapes = GpuTest;

/// The share of a tent of half width h that lies over a texel, by sums of thin strips.
double TentOver(double left, double h)
{
    double sum = 0.0;
    const int strips = 4000;
    for (int i = 0; i < strips; ++i)
    {
        sum += std::max(0.0, h - std::abs(left + (i + 0.5) / strips)) / strips;
    }
    return sum / (h * h);
}

TEST_F(CoreShapes, ShadowsAreFilteredByATent)
{
    FunctionGrid grid(CoreInclude("Shadow/ShadowSamplingTent") + R"(
        float4 Three(float o) { float4 w; SampleShadow_GetTexelWeights_Tent_3x3(o, w); return w; }
        float3 Five(float o) { float3 v, w; SampleShadow_GetTexelWeights_Tent_5x5(o, v, w); return v; }
        float4 Seven(float o) { float4 v, w; SampleShadow_GetTexelWeights_Tent_7x7(o, v, w); return w; }
        float3 Fetch(float2 uv, int i)
        {
            float weights[9]; float2 places[9];
            SampleShadow_ComputeSamples_Tent_5x5(float4(1.0 / 64, 1.0 / 32, 64, 32), uv, weights, places);
            return float3(places[i], weights[i]);
        }
        float2 Sums(float2 uv)
        {
            float w3[4]; float2 p3[4]; float w7[16]; float2 p7[16];
            SampleShadow_ComputeSamples_Tent_3x3(float4(1.0 / 64, 1.0 / 32, 64, 32), uv, w3, p3);
            SampleShadow_ComputeSamples_Tent_7x7(float4(1.0 / 64, 1.0 / 32, 64, 32), uv, w7, p7);
            float sum = 0;
            for (int i = 0; i < 16; ++i) sum += w7[i];
            return float2(w3[0] + w3[1] + w3[2] + w3[3], sum);
        })");
    const auto offsets = Combine({-0.5, -0.2, 0.0, 0.3, 0.49});
    const Tolerance strips{1e-5, 1e-6};
    grid.Add(
        "Three(a.x)", offsets,
        [](auto& a, auto&, auto&)
        {
            return dvec4(TentOver(-2 - a.x, 1.5), TentOver(-1 - a.x, 1.5), TentOver(-a.x, 1.5),
                         TentOver(1 - a.x, 1.5));
        },
        strips);
    grid.Add(
        "Five(a.x)", offsets,
        [](auto& a, auto&, auto&) {
            return dvec3(TentOver(-3 - a.x, 2.5), TentOver(-2 - a.x, 2.5), TentOver(-1 - a.x, 2.5));
        },
        strips);
    grid.Add(
        "Seven(a.x)", offsets,
        [](auto& a, auto&, auto&)
        {
            return dvec4(TentOver(-a.x, 3.5), TentOver(1 - a.x, 3.5), TentOver(2 - a.x, 3.5),
                         TentOver(3 - a.x, 3.5));
        },
        strips);
    // A bilinear fetch at the place weighs its two texels as the tent does.
    const auto fetch = [](double texel, int i)
    {
        const double edge = std::floor(texel + 0.5);
        const double first = TentOver(2 * i - 3 - (texel - edge), 2.5);
        const double second = TentOver(2 * i - 2 - (texel - edge), 2.5);
        return dvec2(edge + 2 * i - 2.5 + second / (first + second), first + second);
    };
    const auto places = CombineVectors({{0.5, 0.5, 0}, {0.333, 0.71, 0}, {0.108, 0.29, 0}});
    for (int i = 0; i < 9; i += 4)
    {
        grid.Add("Fetch(a.xy, " + std::to_string(i) + ")", places,
                 [=](auto& a, auto&, auto&)
                 {
                     const dvec2 u = fetch(a.x * 64, i % 3);
                     const dvec2 v = fetch(a.y * 32, i / 3);
                     return dvec3(u.x / 64, v.x / 32, u.y * v.y);
                 },
                 {1e-5, 1e-5});
    }
    grid.Add("Sums(a.xy)", places, [](auto&, auto&, auto&) { return dvec2(1, 1); });
    grid.Run();
}

TEST_F(CoreShapes, RefractionAndPolygonsFollowTheirGeometry)
{
    FunctionGrid grid(CoreInclude("AreaLighting") + CoreInclude("Refraction") + R"(
        float4 Box(float3 V) { RefractionModelResult r = RefractionModelBox(V, float3(1, 2, 3), float3(0, 0, 1), 1.5, 0.4); return float4(r.positionWS, r.dist); }
        float4 Ball(float3 V) { RefractionModelResult r = RefractionModelSphere(V, float3(1, 2, 3), float3(0, 0, 1), 1.5, 0.4); return float4(r.positionWS, r.dist); }
        float3 Ray(float3 V) { return RefractionModelSphere(V, float3(1, 2, 3), float3(0, 0, 1), 1.5, 0.4).rayWS; }
        // A square of half width h at height z above the surface.
        float3 Square(float h, float z)
        {
            float4x3 L = {h, h, z, -h, h, z, -h, -h, z, h, -h, z};
            return PolygonFormFactor(L, float3(0, 0, 1), 4);
        })");
    const auto views = CombineVectors({{0, 0, 1}, {0.6, 0, 0.8}, glm::normalize(dvec3(1, 2, 1))});
    const auto within = [](const dvec4& v)
    {
        const dvec2 side = -dvec2(v) / 1.5; // Snell
        return dvec3(side, -std::sqrt(1 - glm::dot(side, side)));
    };
    grid.Add("Box(a.xyz)", views,
             [=](auto& a, auto&, auto&)
             {
                 const dvec3 ray = within(a);
                 const double length = 0.4 / -ray.z;
                 return dvec4(dvec3(1, 2, 3) + ray * length, length);
             });
    grid.Add("Ball(a.xyz)", views,
             [=](auto& a, auto&, auto&)
             {
                 const dvec3 ray = within(a);
                 const double chord = 0.4 * -ray.z;
                 return dvec4(dvec3(1, 2, 3) + ray * chord, chord);
             });
    grid.Add("Ray(a.xyz)", views,
             [=](auto& a, auto&, auto&)
             {
                 // Out of a ball a ray leaves turned by twice what it turned going in.
                 const double in = std::acos(a.z);
                 const double turned = 2 * (in - std::asin(std::sin(in) / 1.5));
                 const dvec2 side = in > 0 ? dvec2(a) / std::sin(in) : dvec2(0);
                 const double out = in - turned;
                 return dvec3(-side * std::sin(out), -std::cos(out));
             },
             {1e-4, 1e-5});
    // Form factor of a square over a point below its middle (Howell): four times a corner's.
    grid.Add("Square(a.x, b.x)", Combine({0.2, 1.0, 5.0}, {0.5, 2.0}),
             [](auto& a, auto& b, auto&)
             {
                 const double x = a.x / b.x;
                 const double root = std::sqrt(1 + x * x);
                 const double corner = 2 * x / root * std::atan(x / root) / (2 * k_Pi);
                 return dvec3(0, 0, 4 * corner);
             },
             {1e-4, 1e-5});
    grid.Run();
}

// The APEX system: apertures are powers of sqrt 2, times powers of 2, and the exposure value is
// what they add up to.
TEST_F(CoreShapes, ExposuresAddUpAsInTheApexSystem)
{
    FunctionGrid grid(CoreInclude("PhysicalCamera"));
    const Tolerance tolerance{1e-5, 1e-5};
    const auto settings = Combine({0, 2, 8}, {-3, 0, 7}, {-1, 0, 4}); // Av, Tv, Sv over ISO 100
    grid.Add(
        "ComputeEV100(exp2(a.x * 0.5), exp2(-b.x), 100 * exp2(c.x))", settings,
        [](auto& a, auto& b, auto& c) { return a.x + b.x - c.x; }, tolerance);
    grid.Add(
        "ComputeISO(exp2(a.x * 0.5), exp2(-b.x), c.x)", settings,
        [](auto& a, auto& b, auto& c) { return 100 * std::pow(2.0, a.x + b.x - c.x); }, tolerance);
    // A meter with K = 12.5 reads 1/8 cd/m2 at EV 0, and each stop doubles it.
    grid.Add(
        "float2(ComputeEV100FromAvgLuminance(exp2(a.x)), ComputeEV100FromAvgLuminance(exp2(a.x), "
        "50))",
        Combine({-3, 0, 5}), [](auto& a, auto&, auto&) { return dvec2(a.x + 3, a.x + 1); },
        tolerance);
    // A lens that passes 65 % saturates at 78 / 65 of 2^EV.
    grid.Add(
        "float2(ConvertEV100ToExposure(a.x), ConvertEV100ToExposure(a.x, 2))", Combine({-4, 0, 9}),
        [](auto& a, auto&, auto&) { return dvec2(65.0 / 78.0, 0.5) / std::pow(2.0, a.x); },
        tolerance);
    grid.Add(
        "float2(ConvertExposureToEV100(ConvertEV100ToExposure(a.x)), "
        "ConvertExposureToEV100(ConvertEV100ToExposure(a.x, 3), 3))",
        Combine({-4, 0, 9}), [](auto& a, auto&, auto&) { return dvec2(a.x, a.x); }, tolerance);
    // A difference halves every 1 / speed seconds.
    grid.Add(
        "ComputeLuminanceAdaptation(a.x, b.x, 2, 0.5, c.x)", Combine({1, 9}, {1, 9}, {0, 2, 4}),
        [](auto& a, auto& b, auto& c)
        { return b.x + (a.x - b.x) / std::pow(2.0, c.x * (b.x > a.x ? 2 : 0.5)); },
        tolerance);
    grid.Run();
}

} // namespace
} // namespace limn::test
