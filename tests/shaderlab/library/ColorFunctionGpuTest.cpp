#include "library/AcesReference.h"
#include "library/FunctionGrid.h"

#include <vulkan/GpuTestDevice.h>

// The Academy's colour spaces against what follows from their primaries, and its tone scale.

namespace limn::test
{

namespace
{

using ColorFunctions = GpuTest;

const std::string k_Color =
    "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl\"\n";
const std::string k_PostProcessing =
    "#include "
    "\"Packages/com.unity.render-pipelines.universal/Shaders/PostProcessing/Common.hlsl\"\n";

std::vector<GridInput> Bounded()
{
    return CombineVectors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0.2, 0.5, 0.8}});
}

} // namespace

TEST_F(ColorFunctions, SpacesOfTheAcademy)
{
    FunctionGrid grid(k_Color);
    const glm::dmat3 toAp1 = glm::inverse(Ap1ToXyz()) * Ap0ToXyz();
    const glm::dmat3 toAp0 = glm::inverse(toAp1);
    const auto times = [](const glm::dmat3& m)
    {
        return [m](const glm::dvec4& a, auto&, auto&)
        {
            return m * glm::dvec3(a);
        };
    };
    grid.Add("ACES_to_ACEScg(a.xyz)", Bounded(), times(toAp1), {0, 2e-6});
    grid.Add("ACEScg_to_ACES(a.xyz)", Bounded(), times(toAp0), {0, 2e-6});
    // The published matrices are rounded and were adapted by another method than Bradford's.
    const Tolerance published{0, 6e-4};
    const glm::dmat3 rec709 = Adaptation(k_D65, k_D60) * Rec709ToXyz();
    const glm::dmat3 toAces = glm::inverse(Ap0ToXyz()) * rec709;
    const glm::dmat3 toAcesCg = glm::inverse(Ap1ToXyz()) * rec709;
    grid.Add("unity_to_ACES(a.xyz)", Bounded(), times(toAces), published);
    grid.Add("unity_to_ACEScg(a.xyz)", Bounded(), times(toAcesCg), published);
    grid.Add("ACES_to_unity(a.xyz)", Bounded(), times(glm::inverse(toAces)), published);
    grid.Add("ACEScg_to_unity(a.xyz)", Bounded(), times(glm::inverse(toAcesCg)), published);
    grid.Add("AcesLuminance(a.xyz)", Bounded(), [](auto& a, auto&, auto&) { return Luma(a); },
             {0, 2e-6});
    grid.Run();
}

TEST_F(ColorFunctions, LogarithmOfTheAcademy)
{
    FunctionGrid grid(k_Color);
    const double foot = std::exp2(-15.0);
    const auto inputs = Combine({0.0, 1e-7, 1e-5, foot, 1e-4, 0.18, 1.0, 50.0});
    grid.Add("ACES_to_ACEScc(a.xxx)", inputs,
             [=](auto& a, auto&, auto&)
             {
                 const double log = a.x < foot ? std::log2(foot / 2 + a.x / 2) : std::log2(a.x);
                 return glm::dvec3((log + 9.72) / 17.52);
             });
    grid.Add("ACEScc_to_ACES(ACES_to_ACEScc(a.xxx))", inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(a.x); }, {1e-4, 1e-9});
    grid.Run();
}

TEST_F(ColorFunctions, ToneScaleOfTheAcademy)
{
    // Constants of six digits, and differences of them.
    const Tolerance digits{1e-3, 2e-5};
    FunctionGrid grid(k_Color);
    const auto inputs = CombineVectors({{0, 0, 0},
                                        {0.18, 0.18, 0.18},
                                        {1, 1, 1},
                                        {8, 8, 8},
                                        {0.05, 0.02, 0.01},
                                        {0.9, 0.2, 0.1},
                                        {0.2, 0.7, 0.3},
                                        {0.1, 0.2, 0.9},
                                        {0.6, 0.1, 0.5},
                                        {4, 1, 0.2},
                                        {0.02, 0.03, 0.09},
                                        {0.03, 0.01, 0.01}});
    grid.Add(
        "AcesTonemap(a.xyz)", inputs, [](auto& a, auto&, auto&) { return AcesReference(a); },
        digits);
    grid.Run();
}

TEST_F(ColorFunctions, PostProcessingOnes)
{
    FunctionGrid grid("#define _TONEMAP_ACES 1\n" + k_PostProcessing);
    grid.Add("GetLuminance(a.xyz)", Bounded(), [](auto& a, auto&, auto&) { return Luma(a); },
             {0, 2e-6});
    const auto inputs = Combine({0.0, 0.02, 0.5, 1.0});
    grid.Add("GetSRGBToLinear(a.xxx)", inputs,
             [](auto& a, auto&, auto&) {
                 return glm::dvec3(a.x <= 0.04045 ? a.x / 12.92
                                                  : std::pow((a.x + 0.055) / 1.055, 2.4));
             });
    grid.Add("GetLinearToSRGB(float4(a.xxx, 0.3))", inputs,
             [](auto& a, auto&, auto&)
             {
                 const double srgb =
                     a.x <= 0.0031308 ? a.x * 12.92 : 1.055 * std::pow(a.x, 1 / 2.4) - 0.055;
                 return glm::dvec4(srgb, srgb, srgb, 0.3);
             });
    grid.Add("ApplyVignette(float3(1, 2, 3), a.xy, float2(0.5, 0.5), 1.5, 2, 3, float3(0, 0.5, 1))",
             CombineVectors({{0, 0, 0}, {0.5, 0.5, 0}, {0.6, 0.4, 0}, {0.5, 0.9, 0}}),
             [](auto& a, auto&, auto&)
             {
                 const double x = 2 * 1.5 * (a.x - 0.5);
                 const double y = 1.5 * (a.y - 0.5);
                 const double light = std::pow(std::max(1 - x * x - y * y, 0.0), 3.0);
                 return glm::dvec3(light, 2 * (0.5 + 0.5 * light), 3.0);
             },
             {1e-5, 1e-5});
    grid.Add("ApplyTonemap(ACES_to_unity(a.xyz))",
             CombineVectors({{0.18, 0.18, 0.18}, {0.5, 0.4, 0.6}}),
             [](auto& a, auto&, auto&) { return AcesReference(a); }, {5e-3, 0});
    grid.Run();
}

} // namespace limn::test
