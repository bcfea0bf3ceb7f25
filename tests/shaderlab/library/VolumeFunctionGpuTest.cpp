#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <cmath>
#include <vulkan/GpuTestDevice.h>

// VolumeRendering.hlsl against the published formulas, and against the integrals that it solves.

namespace limn::test
{

namespace
{

constexpr const char* k_Volume =
    "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/VolumeRendering.hlsl\"\n";
/// Of f from 0 to `end`, by Simpson's rule.
double Integral(const std::function<double(double)>& f, double end)
{
    constexpr int k_Steps = 20000;
    const double h = end / k_Steps;
    double sum = f(0.0) + f(end);
    for (int i = 1; i < k_Steps; ++i)
    {
        sum += f(i * h) * (i % 2 == 1 ? 4.0 : 2.0);
    }
    return sum * h / 3.0;
}

/// Extinction of the fog of the tests: 0.2 up to a height of 1, above it e times less every 2.5.
double HeightFog(double height)
{
    return 0.2 * (height > 1.0 ? std::exp(-(height - 1.0) / 2.5) : 1.0);
}

double HenyeyGreenstein(double g, double cosine)
{
    return (1.0 - g * g) / (4.0 * k_Pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

double CornetteShanks(double g, double cosine)
{
    return 3.0 / (8.0 * k_Pi) * (1.0 - g * g) * (1.0 + cosine * cosine) /
           ((2.0 + g * g) * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

} // namespace

using VolumeFunctions = GpuTest;

TEST_F(VolumeFunctions, AbsorbLight)
{
    FunctionGrid grid(k_Volume);
    const auto depths = Combine({0.0, 0.01, 0.7, 3.0, 9.0});
    const auto media = Combine({0.05, 0.4, 2.0}, {0.1, 1.0, 6.0});
    const Tolerance tolerance{1e-5, 2e-7};
    grid.Add(
        "TransmittanceFromOpticalDepth(a.x)", depths,
        [](auto& a, auto&, auto&) { return std::exp(-a.x); }, tolerance);
    grid.Add(
        "OpacityFromOpticalDepth(a.xxy)", depths,
        [](auto& a, auto&, auto&) { return glm::dvec3(-std::expm1(-a.x), -std::expm1(-a.x), 0.0); },
        tolerance);
    grid.Add(
        "OpticalDepthFromOpacity(a.x)", Combine({0.0, 0.25, 0.5, 0.99}),
        [](auto& a, auto&, auto&) { return -std::log1p(-a.x); }, tolerance);
    grid.Add("OpticalDepthHomogeneousMedium(a.x, b.x)", media,
             [](auto& a, auto& b, auto&) { return a.x * b.x; });
    grid.Add(
        "TransmittanceHomogeneousMedium(a.x, b.x)", media,
        [](auto& a, auto& b, auto&) { return std::exp(-a.x * b.x); }, tolerance);
    grid.Add("TransmittanceIntegralHomogeneousMedium(a.x, b.x)", media,
             [](auto& a, auto& b, auto&)
             { return Integral([&](double t) { return std::exp(-a.x * t); }, b.x); },
             {2e-5, 0});
    // A white light of strength 1 has that colour after that distance.
    grid.Add("TransmittanceColorAtDistanceToAbsorption(a.rgb, b.x)",
             {{{0.9, 0.5, 0.05, 0}, {2, 0, 0, 0}}, {{1.0, 0.25, 0.01, 0}, {0.5, 0, 0, 0}}},
             [](auto& a, auto& b, auto&)
             { return glm::dvec3(-std::log(a.x), -std::log(a.y), -std::log(a.z)) / b.x; },
             {2e-5, 1e-6});
    grid.Run();
}

TEST_F(VolumeFunctions, IntegrateFogThatThinsOutWithHeight)
{
    FunctionGrid grid(k_Volume);
    const auto rays =
        Combine({-1.0, -0.6, -0.1, 0.25, 1.0}, {-1.0, 0.5, 1.0, 3.0}, {0.5, 2.0, 8.0});
    const auto along = [](auto& a, auto& b, auto& c)
    {
        return Integral([&](double t) { return HeightFog(b.x + t * a.x); }, c.x);
    };
    grid.Add("0.2 * ComputeHeightFogMultiplier(a.x, 1, float2(0.4, 2.5))",
             Combine({-5.0, 1.0, 1.5, 20.0}), [](auto& a, auto&, auto&) { return HeightFog(a.x); });
    grid.Add("OpticalDepthHeightFog(0.2, 1, float2(0.4, 2.5), a.x, b.x, c.x)", rays, along,
             {2e-5, 1e-6});
    grid.Add("TransmittanceHeightFog(0.2, 1, float2(0.4, 2.5), a.x, b.x, c.x)", rays,
             [along](auto& a, auto& b, auto& c) { return std::exp(-along(a, b, c)); },
             {2e-5, 1e-6});
    // Without an end: 200 units up there is nothing left that single precision would see.
    const auto upwards = Combine({0.25, 0.5, 1.0}, {-1.0, 0.5, 1.0, 3.0});
    const auto endless = [](auto& a, auto& b, auto&)
    {
        return Integral([&](double t) { return HeightFog(b.x + t * a.x); }, 200.0 / a.x);
    };
    grid.Add("OpticalDepthHeightFog(0.2, 1, float2(0.4, 2.5), a.x, b.x)", upwards, endless,
             {2e-5, 1e-6});
    grid.Add("TransmittanceHeightFog(0.2, 1, float2(0.4, 2.5), a.x, b.x)", upwards,
             [endless](auto& a, auto& b, auto& c) { return std::exp(-endless(a, b, c)); },
             {2e-5, 1e-6});
    grid.Run();
}

TEST_F(VolumeFunctions, ScatterLight)
{
    FunctionGrid grid(k_Volume);
    const auto angles = Combine({-0.8, -0.3, 0.0, 0.5, 0.9}, {-1.0, -0.4, 0.0, 0.7, 1.0});
    const Tolerance tolerance{1e-4, 1e-7}; // 1 + g^2 - 2 g cos cancels
    grid.Add("IsotropicPhaseFunction()", Combine({0.0}),
             [](auto&, auto&, auto&) { return 1.0 / (4.0 * k_Pi); });
    grid.Add("RayleighPhaseFunction(b.x)", angles,
             [](auto&, auto& b, auto&) { return 3.0 / (16.0 * k_Pi) * (1.0 + b.x * b.x); });
    grid.Add(
        "HenyeyGreensteinPhaseFunction(a.x, b.x)", angles,
        [](auto& a, auto& b, auto&) { return HenyeyGreenstein(a.x, b.x); }, tolerance);
    grid.Add(
        "CornetteShanksPhaseFunction(a.x, b.x)", angles,
        [](auto& a, auto& b, auto&) { return CornetteShanks(a.x, b.x); }, tolerance);
    grid.Add(
        "CornetteShanksPhasePartConstant(a.x) * CornetteShanksPhasePartSymmetrical(b.x) * "
        "CornetteShanksPhasePartAsymmetrical(a.x, b.x)",
        angles, [](auto& a, auto& b, auto&) { return CornetteShanks(a.x, b.x); }, tolerance);
    grid.Run();
    // The oracles themselves: all light goes somewhere.
    for (double g : {-0.8, 0.0, 0.5})
    {
        const auto over = [g](auto phase)
        {
            return 2.0 * k_Pi * Integral([&](double x) { return phase(g, x - 1.0); }, 2.0);
        };
        EXPECT_NEAR(over(HenyeyGreenstein), 1.0, 1e-6);
        EXPECT_NEAR(over(CornetteShanks), 1.0, 1e-6);
    }
}

TEST_F(VolumeFunctions, ChooseAPlaceInFogByHowMuchLightComesFromIt)
{
    FunctionGrid grid(k_Volume + std::string(R"(
        float2 Sample(float rnd, float extinction, float length)
        {
            float offset, weight;
            ImportanceSampleHomogeneousMedium(rnd, extinction, length, offset, weight);
            return float2(offset, weight);
        })"));
    grid.Add("Sample(a.x, b.x, c.x)", Combine({0.0, 0.2, 0.5, 0.95, 1.0}, {0.3, 2.0}, {0.5, 4.0}),
             [](auto& a, auto& b, auto& c)
             {
                 // The share of the light that comes from before the place is the random number.
                 const auto light = [&](double end)
                 {
                     return Integral([&](double t) { return std::exp(-b.x * t); }, end);
                 };
                 double low = 0.0;
                 double high = c.x;
                 for (int i = 0; i < 40; ++i)
                 {
                     const double middle = (low + high) / 2.0;
                     (light(middle) < a.x * light(c.x) ? low : high) = middle;
                 }
                 return glm::dvec2(low, light(c.x));
             },
             {1e-4, 1e-6});
    grid.Run();
}

} // namespace limn::test
