#include "library/Formulas.h"
#include "library/FunctionGrid.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <vulkan/GpuTestDevice.h>

// The render-pipelines.core part of the ShaderLibrary against the published formulas.

namespace limn::test
{

namespace
{

#define LIMN_CORE(name)                                                                            \
    "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/" name ".hlsl\"\n"

const std::vector<double> k_Unit = {0.0, 1e-4, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0};
const std::vector<double> k_Signed = {-1e6, -2.5, -1.0, -0.3, 0.0, 0.3, 1.0, 2.5, 1e6};

template <typename Function>
glm::dvec3 Each(const glm::dvec4& v, Function function)
{
    return {function(v.x), function(v.y), function(v.z)};
}

std::uint32_t Jenkins(std::uint32_t x)
{
    x += x << 10u;
    x ^= x >> 6u;
    x += x << 3u;
    x ^= x >> 11u;
    x += x << 15u;
    return x;
}

/// The low 23 bits as the fraction of a number from 1 to 2, less 1.
double Fraction(std::uint32_t bits)
{
    return (bits & 0x7FFFFFu) / 8388608.0;
}

} // namespace

using CoreLibrary = GpuTest;

TEST_F(CoreLibrary, MakesFunctionsOfEachNumberOfComponents)
{
    FunctionGrid grid(LIMN_CORE("Common") R"(
        TEMPLATE_1_REAL(Cubed, x, { return x * x * x; })
        TEMPLATE_2_FLT(Scaled, x, factor, return x * factor)
        TEMPLATE_2_INT(Behind, x, y, return x * 100 + y)
        TEMPLATE_3_REAL(Mixed, x, y, t, return x + (y - x) * t)
        TEMPLATE_SWAP(Exchange)
        float3 Swapped(float3 a, float3 b) { Swap(a, b); return a * 2 + b; }
        int2 Exchanged(int2 a, int2 b) { Exchange(a, b); return a * 100 + b; }
    )");
    const auto pairs = Combine({-2.0, 0.5, 3.0}, {-1.0, 4.0});
    grid.Add("float2(Cubed(a.x), Cubed(a.xxxx).w)", pairs,
             [](auto& a, auto&, auto&) { return glm::dvec2(a.x * a.x * a.x); });
    grid.Add("float3(Scaled(a.x, b.x), Scaled(a.xx, b.xx))", pairs,
             [](auto& a, auto& b, auto&) { return glm::dvec3(a.x * b.x); });
    grid.Add("float2(Behind(3, -4), Behind(uint2(3, 4), 5u).y)", Combine({0.0}),
             [](auto&, auto&, auto&) { return glm::dvec2(296.0, 405.0); });
    grid.Add("Mixed(a.xxx, b.xxx, 0.25)", pairs,
             [](auto& a, auto& b, auto&) { return glm::dvec3(0.75 * a.x + 0.25 * b.x); });
    grid.Add("Swapped(a.xxx, b.xxx)", pairs,
             [](auto& a, auto& b, auto&) { return glm::dvec3(2.0 * b.x + a.x); });
    grid.Add("float2(RangeRemap(1.0, 3.0, a.x), RangeRemapFrom01(b.xx, 9.0.xx, 0.25.xx).y)", pairs,
             [](auto& a, auto& b, auto&)
             { return glm::dvec2(std::clamp((a.x - 1.0) / 2.0, 0.0, 1.0), 0.75 * b.x + 2.25); });
    grid.Add("float2(Exchanged(int2(1, 2), int2(3, 4)))", Combine({0.0}),
             [](auto&, auto&, auto&) { return glm::dvec2(301.0, 402.0); });
    grid.Run();
}

TEST_F(CoreLibrary, DoesArithmeticOfNumbers)
{
    FunctionGrid grid(LIMN_CORE("Common") R"(
        float Swapped(float a, float b) { Swap(a, b); return a - b; }
        uint Bits(uint x) { SetBit(x, 3); ClearBit(x, 0); ToggleBit(x, 1); return x; }
    )");
    const auto pairs = Combine(k_Signed, k_Signed);
    const auto triples = Combine({-2.0, 0.0, 1.5}, {-3.0, 1.5, 4.0}, {0.0, 7.0, -9.0});
    const Tolerance power{2e-5, 1e-6};
    grid.Add("Sq(a.x)", pairs, [](auto& a, auto&, auto&) { return a.x * a.x; });
    grid.Add("Pow4(a.x)", pairs, [](auto& a, auto&, auto&) { return std::pow(a.x, 4.0); });
    grid.Add("Min3(a.x, b.x, c.x)", triples,
             [](auto& a, auto& b, auto& c) {
                 return std::min({a.x, b.x, c.x});
             });
    grid.Add("Max3(a.x, b.x, c.x)", triples,
             [](auto& a, auto& b, auto& c) {
                 return std::max({a.x, b.x, c.x});
             });
    grid.Add("Avg3(a.x, b.x, c.x)", triples,
             [](auto& a, auto& b, auto& c) { return (a.x + b.x + c.x) / 3.0; });
    grid.Add(
        "PositivePow(a.x, b.x)", Combine({-2.0, -0.5, 0.25, 3.0}, {0.0, 0.5, 2.0}),
        [](auto& a, auto& b, auto&) { return std::pow(std::abs(a.x), b.x); }, power);
    grid.Add(
        "SafePositivePow(a.x, 0.5)", Combine({-2.0, 0.0, 9.0}),
        [](auto& a, auto&, auto&)
        { return std::sqrt(std::max(std::abs(a.x), std::pow(2.0, -23.0))); },
        power);
    grid.Add("SafeSqrt(a.x)", pairs,
             [](auto& a, auto&, auto&) { return std::sqrt(std::max(a.x, 0.0)); });
    grid.Add("SafeDiv(a.x, b.x)", Combine({-3.0, 0.0, 2.0}, {-1.0, 2.0, 4.0}),
             [](auto& a, auto& b, auto&) { return a.x == b.x ? 1.0 : a.x / b.x; });
    grid.Add("SafeDiv(a.x, b.x)", Combine({0.0}, {0.0}), [](auto&, auto&, auto&) { return 1.0; });
    grid.Add("SinFromCos(a.x)", Combine({-1.0, -0.5, 0.0, 0.7, 1.0}),
             [](auto& a, auto&, auto&) { return std::sin(std::acos(a.x)); }, {1e-5, 1e-4});
    grid.Add("Remap01(a.x, b.x, c.x)", triples,
             [](auto& a, auto& b, auto& c) { return Saturate(a.x * b.x + c.x); });
    grid.Add("Remap10(a.x, b.x, c.x)", triples,
             [](auto& a, auto& b, auto& c) { return Saturate(c.x - a.x * b.x); });
    grid.Add("Smoothstep01(a.x)", Combine(k_Unit),
             [](auto& a, auto&, auto&) { return a.x * a.x * (3.0 - 2.0 * a.x); });
    grid.Add("Smootherstep(1, 3, a.x)", Combine({0.0, 1.0, 1.7, 2.0, 3.0, 5.0}),
             [](auto& a, auto&, auto&)
             {
                 const double t = Saturate((a.x - 1.0) / 2.0);
                 return 6.0 * std::pow(t, 5.0) - 15.0 * std::pow(t, 4.0) + 10.0 * t * t * t;
             });
    grid.Add("LerpWhiteTo(a.x, b.x)", Combine(k_Unit, k_Unit),
             [](auto& a, auto& b, auto&) { return 1.0 - b.x + b.x * a.x; });
    grid.Add("CopySign(a.x, b.x)", pairs,
             [](auto& a, auto& b, auto&) { return b.x >= 0.0 ? std::abs(a.x) : -std::abs(a.x); });
    grid.Add("FastSign(a.x)", pairs, [](auto& a, auto&, auto&) { return a.x < 0.0 ? -1.0 : 1.0; });
    grid.Add("FastACos(a.x)", Combine({-1.0, -0.4, 0.0, 0.8, 1.0}),
             [](auto& a, auto&, auto&) { return std::acos(a.x); }, {1e-4, 5e-4});
    grid.Add("FastATan(a.x)", Combine({-100.0, -1.0, 0.0, 0.3, 20.0}),
             [](auto& a, auto&, auto&) { return std::atan(a.x); }, {1e-4, 5e-4});
    grid.Add("FastLog2((uint)a.x)", Combine({1.0, 2.0, 3.0, 255.0, 256.0, 65537.0}),
             [](auto& a, auto&, auto&) { return std::floor(std::log2(a.x)); });
    grid.Add("IsPower2((uint)a.x)", Combine({1.0, 2.0, 3.0, 255.0, 256.0}),
             [](auto& a, auto&, auto&) { return a.x == 3.0 || a.x == 255.0 ? 0.0 : 1.0; });
    grid.Add("Swapped(a.x, b.x)", Combine({1.0, 5.0}, {2.0}),
             [](auto& a, auto& b, auto&) { return b.x - a.x; });
    grid.Add("BitFieldExtract((uint)a.x, 4, 3)", Combine({0.0, 16.0, 127.0, 1000.0}),
             [](auto& a, auto&, auto&) { return (static_cast<int>(a.x) / 16) % 8; });
    grid.Add("BitFieldExtractSignExtend((int)a.x, 0, 4)", Combine({0.0, 7.0, 8.0, 15.0}),
             [](auto& a, auto&, auto&) { return a.x < 8.0 ? a.x : a.x - 16.0; });
    grid.Add("Bits((uint)a.x)", Combine({0.0, 1.0, 3.0, 8.0}),
             [](auto& a, auto&, auto&)
             { return static_cast<double>(((static_cast<unsigned>(a.x) | 8u) & ~1u) ^ 2u); });
    grid.Add("float4(DegToRad(a.x), RadToDeg(a.x), ClampToFloat16Max(a.x), 0)", pairs,
             [](auto& a, auto&, auto&) {
                 return glm::dvec4(a.x * M_PI / 180.0, a.x * 180.0 / M_PI, std::min(a.x, 65504.0),
                                   0.0);
             });
    grid.Run();
}

TEST_F(CoreLibrary, TellsNumbersFromWhatIsNone)
{
    FunctionGrid grid(LIMN_CORE("Common"));
    const double infinity = HUGE_VAL;
    const double nan = std::nan("");
    grid.Add("float4(IsNaN(a.x), IsInf(a.x), IsFinite(a.x), AnyIsNaN(a.xyz))",
             Combine({0.0, -1e38, infinity, -infinity, nan}),
             [](auto& a, auto&, auto&) {
                 return glm::dvec4(std::isnan(a.x), std::isinf(a.x), std::isfinite(a.x),
                                   std::isnan(a.x));
             });
    grid.Add("SanitizeFinite(a.x)", Combine({2.0, infinity, nan}),
             [](auto& a, auto&, auto&) { return std::isfinite(a.x) ? a.x : 0.0; });
    grid.Run();
}

TEST_F(CoreLibrary, TurnsAndNormalisesVectors)
{
    FunctionGrid grid(LIMN_CORE("CommonLighting"));
    grid.Add("SafeNormalize(a.xyz)",
             CombineVectors({{0, 0, 0}, {3, 4, 0}, {1e-3, 0, 0}, {-5, 5, 9}}),
             [](auto& a, auto&, auto&)
             {
                 const glm::dvec3 v(a);
                 return glm::length(v) == 0.0 ? glm::dvec3(0.0) : glm::normalize(v);
             });
    grid.Add("RotateByAngle(a.xy, b.x)",
             CombineVectors({{1, 0, 0}, {0.5, -2, 0}}, {{0, 0, 0}, {1, 0, 0}, {-3, 0, 0}}),
             [](auto& a, auto& b, auto&)
             {
                 return glm::dvec2(std::cos(b.x) * a.x - std::sin(b.x) * a.y,
                                   std::sin(b.x) * a.x + std::cos(b.x) * a.y);
             },
             {1e-4, 1e-5, 2.5});
    grid.Add("Rotate(float3(1, 2, 3), a.xyz, b.xyz, 0.7)",
             CombineVectors({{1, 2, 3}, {4, -5, 6}}, UnitVectors()),
             [](auto& a, auto& b, auto&)
             {
                 const glm::dvec3 pivot(1, 2, 3);
                 const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(b));
                 return pivot + glm::dvec3(turn * glm::dvec4(glm::dvec3(a) - pivot, 0.0));
             },
             {1e-5, 1e-4});
    // Any right-angled frame will do: its products are those of a turn.
    grid.Add("mul(GetLocalFrame(a.xyz), a.xyz)", CombineVectors(UnitVectors()),
             [](auto&, auto&, auto&) { return glm::dvec3(0, 0, 1); }, {0, 2e-6});
    grid.Add("float4(determinant(GetLocalFrame(a.xyz)), dot(GetLocalFrame(a.xyz)[0], "
             "GetLocalFrame(a.xyz)[1]), length(GetLocalFrame(a.xyz)[0]), "
             "length(GetLocalFrame(a.xyz)[1]))",
             CombineVectors(UnitVectors()),
             [](auto&, auto&, auto&) { return glm::dvec4(1, 0, 1, 1); }, {0, 2e-6});
    grid.Add("Orthonormalize(float3(1, 2, 0), float3(0, 1, 0))", Combine({0.0}),
             [](auto&, auto&, auto&) { return glm::dvec3(1, 0, 0); });
    grid.Add("CubeMapFaceID(a.xyz)",
             CombineVectors({{2, 1, -1}, {-2, 1, 1}, {0, 3, 1}, {1, -3, 1}, {0, 0, 1}, {1, 0, -4}}),
             [](auto& a, auto&, auto&)
             {
                 const double x = std::abs(a.x);
                 const double y = std::abs(a.y);
                 const double z = std::abs(a.z);
                 const double face = z >= x && z >= y ? (a.z < 0 ? 5 : 4)
                                     : y >= x         ? (a.y < 0 ? 3 : 2)
                                                      : (a.x < 0 ? 1 : 0);
                 return face;
             });
    grid.Run();
}

TEST_F(CoreLibrary, MakesTheSameNoiseAsTheReference)
{
    FunctionGrid grid(LIMN_CORE("Random") LIMN_CORE("Common") R"(
        float Shifted(uint x) { uint state = x; return ConstructFloat(XorShift(state)); }
    )");
    const std::vector<double> seeds = {0.0, 1.0, 2.0, 77.0, 65535.0, 1048577.0};
    grid.Add("GenerateHashedRandomFloat((uint)a.x)", Combine(seeds),
             [](auto& a, auto&, auto&)
             { return Fraction(Jenkins(static_cast<std::uint32_t>(a.x))); },
             {0, 1e-7});
    grid.Add("GenerateHashedRandomFloat(uint2(a.x, b.x))", Combine(seeds, seeds),
             [](auto& a, auto& b, auto&)
             {
                 return Fraction(Jenkins(static_cast<std::uint32_t>(a.x) ^
                                         Jenkins(static_cast<std::uint32_t>(b.x))));
             },
             {0, 1e-7});
    grid.Add("Shifted((uint)a.x)", Combine(seeds),
             [](auto& a, auto&, auto&)
             {
                 auto x = static_cast<std::uint32_t>(a.x);
                 x ^= x << 13u;
                 x ^= x >> 17u;
                 x ^= x << 5u;
                 return Fraction(x);
             },
             {0, 1e-7});
    grid.Add("InterleavedGradientNoise(a.xy, 0)",
             CombineVectors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {13, 7, 0}}),
             [](auto& a, auto&, auto&)
             {
                 const double sum = 0.06711056 * a.x + 0.00583715 * a.y;
                 const double large = 52.9829189 * (sum - std::floor(sum));
                 return large - std::floor(large);
             },
             {0, 1e-4});
    grid.Run();
}

TEST_F(CoreLibrary, ConvertsColours)
{
    FunctionGrid grid(LIMN_CORE("Color"));
    const auto colors = CombineVectors(Colors());
    const Tolerance power{3e-5, 2e-6};
    grid.Add(
        "SRGBToLinear(a.rgb)", colors, [](auto& a, auto&, auto&) { return Each(a, SrgbToLinear); },
        power);
    grid.Add(
        "LinearToSRGB(a.rgb)", colors, [](auto& a, auto&, auto&) { return Each(a, LinearToSrgb); },
        power);
    grid.Add(
        "Gamma22ToLinear(a.rgb)", colors,
        [](auto& a, auto&, auto&) { return Each(a, [](double c) { return std::pow(c, 2.2); }); },
        power);
    grid.Add(
        "LinearToGamma22(a.rgb)", colors,
        [](auto& a, auto&, auto&)
        { return Each(a, [](double c) { return std::pow(c, 1 / 2.2); }); },
        power);
    grid.Add("Luminance(a.rgb)", colors,
             [](auto& a, auto&, auto&)
             { return 0.2126729 * a.x + 0.7151522 * a.y + 0.0721750 * a.z; });
    grid.Add("HsvToRgb(RgbToHsv(a.rgb))", colors,
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {2e-5, 2e-5});
    grid.Add("RgbToHsv(a.rgb)", CombineVectors({{1, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {1, 1, 0}}),
             [](auto& a, auto&, auto&)
             {
                 const double hue = a.y == 1.0   ? 1.0 / 6
                                    : a.x == 1.0 ? 0.0
                                    : a.y > 0    ? 1.0 / 3
                                                 : 2.0 / 3;
                 return glm::dvec3(hue, 1.0, std::max({a.x, a.y, a.z}));
             });
    grid.Add("YCoCgToRGB(RGBToYCoCg(a.rgb))", colors,
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {1e-6, 1e-5});
    grid.Add("LinearToLogC(a.rgb)", colors,
             [](auto& a, auto&, auto&)
             {
                 return Each(a, [](double c)
                             { return 0.244161 * std::log10(5.555556 * c + 0.047996) + 0.386036; });
             },
             {2e-5, 2e-6});
    grid.Add("LogCToLinear(LinearToLogC(a.rgb))", colors,
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {1e-4, 1e-5});
    grid.Add("LinearToPQ(a.rgb, 100)", colors,
             [](auto& a, auto&, auto&)
             {
                 return Each(a,
                             [](double c)
                             {
                                 const double y = std::pow(c / 100.0, 0.1593017578125);
                                 return std::pow((0.8359375 + 18.8515625 * y) / (1 + 18.6875 * y),
                                                 78.84375);
                             });
             },
             {5e-4, 1e-5});
    grid.Add("PQToLinear(a.rgb, 100)", CombineVectors({{0.1, 0.5, 0.9}, {1, 0.7, 0.3}}),
             [](auto& a, auto&, auto&)
             {
                 return Each(a,
                             [](double c)
                             {
                                 const double y = std::pow(c, 1.0 / 78.84375);
                                 return 100.0 * std::pow(std::max(y - 0.8359375, 0.0) /
                                                             (18.8515625 - 18.6875 * y),
                                                         1.0 / 0.1593017578125);
                             });
             },
             {5e-3, 1e-4});
    grid.Add("NeutralTonemap(a.rgb)", colors,
             [](auto& a, auto&, auto&)
             {
                 const auto curve = [](double x)
                 {
                     return (x * (0.2 * x + 0.24 * 0.29) + 0.272 * 0.02) /
                                (x * (0.2 * x + 0.29) + 0.272 * 0.3) -
                            0.02 / 0.3;
                 };
                 const double scale = 1.0 / curve(5.3);
                 return Each(a, [&](double c) { return curve(c * scale) * scale; });
             },
             {1e-4, 1e-5});
    grid.Add("float4(RotateHue(a.x, 0, 1), 0, 0, 0)", Combine({-0.25, 0.0, 0.5, 1.25}),
             [](auto& a, auto&, auto&) { return a.x < 0   ? a.x + 1
                                                : a.x > 1 ? a.x - 1
                                                          : a.x; });
    grid.Add(
        "GetLutStripValue(a.xy, float4(4, 0.5 / 16, 0.5 / 4, 4.0 / 3))",
        CombineVectors({{0.5 / 16, 0.5 / 4, 0}, {5.5 / 16, 3.5 / 4, 0}, {15.5 / 16, 1.5 / 4, 0}}),
        [](auto& a, auto&, auto&)
        {
            const double column = std::floor(a.x * 16);
            return glm::dvec3(std::fmod(column, 4), std::floor(a.y * 4), std::floor(column / 4)) /
                   3.0;
        });
    grid.Run();
}

TEST_F(CoreLibrary, PacksAndUnpacks)
{
    FunctionGrid grid(LIMN_CORE("Packing"));
    const auto normals = CombineVectors(UnitVectors());
    grid.Add("UnpackNormalScale(a, 0.5)",
             {{{0.5, 0.5, 1, 1}}, {{1, 0.5, 0, 1}}, {{0.2, 0.7, 1, 1}}, {{1, 0.7, 1, 0.2}}},
             [](auto& a, auto&, auto&)
             {
                 const double x = a.x * a.w * 2 - 1;
                 const double y = a.y * 2 - 1;
                 return glm::dvec3(x * 0.5, y * 0.5, std::sqrt(std::max(1e-16, 1 - x * x - y * y)));
             });
    grid.Add("UnpackNormalRGB(a, 2)", {{{0.5, 0.25, 1, 1}}, {{0, 1, 0.5, 0}}},
             [](auto& a, auto&, auto&)
             { return glm::dvec3(a.x * 4 - 2, a.y * 4 - 2, a.z * 2 - 1); });
    grid.Add(
        "PackNormalOctQuadEncode(a.xyz)", normals,
        [](auto& a, auto&, auto&)
        {
            const glm::dvec3 n = glm::dvec3(a) / (std::abs(a.x) + std::abs(a.y) + std::abs(a.z));
            // The lower half is folded outwards over the edges of the square.
            const double fold = std::max(-n.z, 0.0);
            return glm::dvec2(n.x + (n.x >= 0 ? fold : -fold), n.y + (n.y >= 0 ? fold : -fold));
        });
    grid.Add("UnpackNormalOctQuadEncode(PackNormalOctQuadEncode(a.xyz))", normals,
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {0, 1e-6});
    grid.Add("UnpackNormalHemiOctEncode(PackNormalHemiOctEncode(float3(a.xy, abs(a.z))))", normals,
             [](auto& a, auto&, auto&) { return glm::dvec3(a.x, a.y, std::abs(a.z)); }, {0, 1e-6});
    grid.Add("UnpackNormalMaxComponent(PackNormalMaxComponent(a.xyz))", normals,
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {0, 1e-6});
    grid.Add("PackFloat2To888(float2(a.x, b.x)) * 255", Combine(k_Unit, {0.0, 0.3, 1.0}),
             [](auto& a, auto& b, auto&)
             {
                 const int x = static_cast<int>(a.x * 4095.5);
                 const int y = static_cast<int>(b.x * 4095.5);
                 return glm::dvec3(x % 256, y % 256, x / 256 + y / 256 * 16);
             },
             {0, 1e-4});
    grid.Add("Unpack888ToFloat2(PackFloat2To888(float2(a.x, b.x)))", Combine(k_Unit, k_Unit),
             [](auto& a, auto& b, auto&) { return glm::dvec2(a.x, b.x); }, {0, 1.0 / 4095});
    const std::vector<double> noTies = {0.0, 0.11, 0.31, 0.62, 1.0}; // of 15 steps
    grid.Add("Unpack8ToFloat2(PackFloat2To8(float2(a.x, b.x)))", Combine(noTies, noTies),
             [](auto& a, auto& b, auto&)
             { return glm::dvec2(std::round(a.x * 15), std::round(b.x * 15)) / 15.0; });
    grid.Add("UnpackShort(PackShort((uint)a.x))", Combine({0.0, 1.0, 255.0, 40000.0, 65535.0}),
             [](auto& a, auto&, auto&) { return a.x; });
    grid.Add("UnpackFromR11G11B10f(PackToR11G11B10f(a.xyz))",
             CombineVectors({{0, 0, 0}, {1, 2, 4}, {0.5, 1.5, 1000}, {0.3, 0.7, 11.3}}),
             [](auto& a, auto&, auto&) { return glm::dvec3(a); }, {1.0 / 32, 1e-7});
    grid.Run();
}

TEST_F(CoreLibrary, MixesNormalsAndRoughness)
{
    FunctionGrid grid(LIMN_CORE("CommonMaterial") LIMN_CORE("NormalSurfaceGradient")
                          LIMN_CORE("ParallaxMapping"));
    const std::vector<glm::dvec3> up = {{0, 0, 1}, {0.6, 0, 0.8}, {-0.3, 0.4, std::sqrt(0.75)}};
    const auto pairs = CombineVectors(up, up);
    grid.Add("float3(PerceptualRoughnessToRoughness(a.x), RoughnessToPerceptualRoughness(a.x), "
             "PerceptualSmoothnessToRoughness(a.x))",
             Combine(k_Unit),
             [](auto& a, auto&, auto&)
             { return glm::dvec3(a.x * a.x, std::sqrt(a.x), (1 - a.x) * (1 - a.x)); });
    grid.Add("ComputeDiffuseColor(a.rgb, 0.25) + ComputeFresnel0(a.rgb, 0.25, 0.04)",
             CombineVectors(Colors()),
             [](auto& a, auto&, auto&)
             { return glm::dvec3(a) * 0.75 + glm::dvec3(a) * 0.25 + glm::dvec3(0.03); });
    grid.Add("BlendNormal(a.xyz, b.xyz)", pairs,
             [](auto& a, auto& b, auto&) {
                 return glm::normalize(
                     glm::dvec3(a.x * b.z + b.x * a.z, a.y * b.z + b.y * a.z, a.z * b.z));
             });
    // Reoriented: the turn that takes z to n1, applied to n2.
    grid.Add("BlendNormalRNM(a.xyz, b.xyz)", pairs,
             [](auto& a, auto& b, auto&)
             {
                 const glm::dvec3 z(0, 0, 1);
                 const glm::dvec3 n1(a);
                 const glm::dvec3 axis = glm::cross(z, n1);
                 const double angle = std::acos(std::min(glm::dot(z, n1), 1.0));
                 const glm::dvec3 n2(b);
                 return glm::length(axis) < 1e-9
                            ? n2
                            : glm::dvec3(glm::rotate(glm::dmat4(1.0), angle, axis) *
                                         glm::dvec4(n2, 0));
             },
             {0, 2e-6});
    grid.Add("BlendNormalWorldspaceRNM(a.xyz, b.xyz, float3(0, 0, 1))", pairs,
             [](auto& a, auto& b, auto&)
             {
                 const glm::dvec3 n2(b);
                 const glm::dvec3 axis = glm::cross(glm::dvec3(0, 0, 1), n2);
                 const double angle = std::acos(std::min(n2.z, 1.0));
                 return glm::length(axis) < 1e-9
                            ? glm::dvec3(a)
                            : glm::dvec3(glm::rotate(glm::dmat4(1.0), angle, axis) *
                                         glm::dvec4(glm::dvec3(a), 0));
             },
             {0, 2e-6});
    grid.Add("SurfaceGradientResolveNormal(float3(0, 0, 1), SurfaceGradientFromTBN(a.xy, "
             "float3(1, 0, 0), float3(0, 1, 0)))",
             CombineVectors({{0, 0, 0}, {0.5, 0, 0}, {-1, 2, 0}}),
             [](auto& a, auto&, auto&) { return glm::normalize(glm::dvec3(-a.x, -a.y, 1)); });
    grid.Add("ParallaxOffset1Step(a.x, 0.1, b.xyz)",
             {{{0.0, 0, 0, 0}, {0, 0, 1, 0}}, {{1.0, 0, 0, 0}, {3, 4, 12, 0}}},
             [](auto& a, auto& b, auto&)
             {
                 const glm::dvec3 v = glm::normalize(glm::dvec3(b));
                 return glm::dvec2(v.x, v.y) * ((a.x * 0.1 - 0.05) / (v.z + 0.42));
             });
    grid.Add("ComputeTriplanarWeights(a.xyz)", CombineVectors(UnitVectors()),
             [](auto& a, auto&, auto&)
             {
                 const glm::dvec3 w = Each(
                     a, [](double c) { return std::pow(std::max(std::abs(c) - 0.2, 0.0), 3.0); });
                 return w / (w.x + w.y + w.z);
             });
    grid.Run();
}

} // namespace limn::test
