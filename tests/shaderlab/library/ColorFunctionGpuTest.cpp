#include "library/FunctionGrid.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
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

glm::dvec3 Xyz(glm::dvec2 xy)
{
    return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y};
}

/// RGB to XYZ from chromaticities (SMPTE RP 177).
glm::dmat3 ToXyz(glm::dvec2 r, glm::dvec2 g, glm::dvec2 b, glm::dvec2 white)
{
    const glm::dmat3 primaries(Xyz(r), Xyz(g), Xyz(b));
    const glm::dvec3 scale = glm::inverse(primaries) * Xyz(white);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

const glm::dvec2 k_D60(0.32168, 0.33767);
const glm::dvec2 k_D65(0.3127, 0.3290);

glm::dmat3 Ap0ToXyz()
{
    return ToXyz({0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, k_D60);
}
glm::dmat3 Ap1ToXyz()
{
    return ToXyz({0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, k_D60);
}
glm::dmat3 Rec709ToXyz()
{
    return ToXyz({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, k_D65);
}

/// Bradford's adaptation.
glm::dmat3 Adaptation(glm::dvec2 from, glm::dvec2 to)
{
    const glm::dmat3 cones = glm::transpose(
        glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
    const glm::dvec3 ratio = cones * Xyz(to) / (cones * Xyz(from));
    glm::dmat3 scale(0.0);
    for (int i = 0; i < 3; ++i)
    {
        scale[i][i] = ratio[i];
    }
    return glm::inverse(cones) * scale * cones;
}

double Luma(const glm::dvec3& ap1)
{
    return (Ap1ToXyz() * ap1).y;
}

double Saturation(const glm::dvec3& c)
{
    const double high = std::max({c.x, c.y, c.z});
    const double low = std::min({c.x, c.y, c.z});
    return (std::max(high, 1e-4) - std::max(low, 1e-4)) / std::max(high, 1e-2);
}

/// Of the reference rendering transform: what is dark and colourful glows.
double Glow(const glm::dvec3& c)
{
    const double x = (Saturation(c) - 0.4) / 0.2;
    const double t = std::max(1.0 - std::abs(x) / 2.0, 0.0);
    const double shape = (1.0 + (x > 0 ? 1 : x < 0 ? -1 : 0) * (1.0 - t * t)) / 2.0;
    const double chroma =
        std::sqrt(c.z * (c.z - c.y) + c.y * (c.y - c.x) + c.x * (c.x - c.z) + 1e-300);
    const double yc = (c.x + c.y + c.z + 1.75 * chroma) / 3.0;
    const double gain = 0.05 * shape;
    return yc <= 0.08 * 2 / 3 ? gain : yc >= 0.16 ? 0.0 : gain * (0.08 / yc - 0.5);
}

glm::dvec3 RedModified(glm::dvec3 c, double saturation)
{
    const double hue =
        std::atan2(std::sqrt(3.0) * (c.y - c.z), 2 * c.x - c.y - c.z) * 180.0 / std::acos(-1.0);
    const double t = std::max(1.0 - std::abs(hue) * 2.0 / 135.0, 0.0);
    const double weight = (3 - 2 * t) * t * t;
    c.x += weight * weight * saturation * (0.03 - c.x) * 0.18;
    return c;
}

/// `color` in ACES2065-1.
glm::dvec3 Tonemap(const glm::dvec3& color)
{
    const glm::dvec3 aces = RedModified(color * (1.0 + Glow(color)), Saturation(color));
    glm::dvec3 x = glm::inverse(Ap1ToXyz()) * Ap0ToXyz() * aces;
    x = glm::max(x, 0.0);
    x = glm::mix(glm::dvec3(Luma(x)), x, 0.96);
    x = x * (278.5085 * x + 10.7772) / (x * (293.6045 * x + 88.7122) + 80.6889);
    // The chromaticity stays, the luminance goes to the power.
    const double luminance = Luma(x);
    x *= luminance > 0 ? std::pow(luminance, 0.9811) / luminance : 0.0;
    x = glm::mix(glm::dvec3(Luma(x)), x, 0.93);
    return glm::inverse(Rec709ToXyz()) * Adaptation(k_D60, k_D65) * Ap1ToXyz() * x;
}

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
        "AcesTonemap(a.xyz)", inputs, [](auto& a, auto&, auto&) { return Tonemap(a); }, digits);
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
             [](auto& a, auto&, auto&) { return Tonemap(a); }, {5e-3, 0});
    grid.Run();
}

} // namespace limn::test
