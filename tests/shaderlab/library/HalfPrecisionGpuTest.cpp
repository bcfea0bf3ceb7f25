#include "SpirvTestSupport.h"
#include "library/FunctionGrid.h"

#include <cmath>
#include <gmock/gmock.h>
#include <vulkan/GpuTestDevice.h>

namespace limn::test
{
namespace
{

ShaderCompilerOptions SmallHalf()
{
    ShaderCompilerOptions options;
    options.halfIs16Bit = true;
    return options;
}

/// To the nearest number of 16 bits, of two as near the even one. What is computed from such
/// numbers by one of + - * / and rounded to double first does not come out otherwise.
double RoundedToHalf(double x)
{
    if (x == 0.0 || !std::isfinite(x))
    {
        return x;
    }
    const int exponent = std::max(std::ilogb(x), -14);
    const double step = std::ldexp(1.0, exponent - 10);
    const double rounded = std::nearbyint(x / step) * step;
    return std::abs(rounded) > 65504.0 ? std::copysign(HUGE_VAL, x) : rounded;
}

constexpr const char* k_Functions = R"(
float Assigned(float x) { half h = x; return h; }
float Passed(half h) { return h; }
half Returned(float x) { return x; }
half Sum(half x, half y) { return x + y; }
half Difference(half x, half y) { return x - y; }
half Product(half x, half y) { return x * y; }
half Quotient(half x, half y) { return x / y; }
half Root(half x) { return sqrt(x); }
half TwiceMore(half x) { half y = x + 0.00048828125; return y + 0.00048828125; }
float Promoted(half x, float y) { return x * y; }
float Squared(half2 p) { return dot(p, p); }
float2 Parts(float x, float y) { half4 v = half4(x, y, 0, 0); half2 w = v.yx; return w; }
struct Pair { half small; float large; };
float2 Both(float x) { Pair pair; pair.small = x; pair.large = x; return float2(pair.small, pair.large); }
float Elements(float x) { half all[3] = {x, 0.1, x}; return all[2]; }
float Chosen(float x) { half h = x; return h > 0.1 ? h : 0.1; }
half Mixed(half x, half y, half t) { return lerp(x, y, t); }
void Out(float x, out half y) { y = x; }
float ByReference(float x) { half y; Out(x, y); return y; }
)";

// Not between 65504, the largest half, and 65520: SPIR-V lets infinity come of it.
const std::vector<double> k_Numbers = {
    0.0,    1.0,     -1.0,   1.0 / 3.0, 1.00048828125, 1.00146484375, 0.1,   -2.7,   100.3,
    2048.0, 2049.0,  2051.0, 65504.0,   65520.0,       1e6,           -1e30, 6.2e-5, 0x1p-14,
    3e-3,   0x1p-10, 255.0,  256.0,     257.1,         1023.9,        33.3,  0.49999};

class HalfPrecisionGpu : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        const auto& missing = SharedDevice().missingShaderFeatures();
        if (std::ranges::count(missing, "native16bit") > 0)
        {
            GTEST_SKIP() << "the device has no 16-bit floats";
        }
    }
};

TEST_F(HalfPrecisionGpu, RoundsInProgramsOfUrpToo)
{
    // URP's Common.hlsl says that min16float is float where there is no half.
    FunctionGrid grid(
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "float Rounded(float x) { half h = x; return h; }\n");
    grid.options = SmallHalf();
    grid.Add(
        "Rounded(a.x)", Combine(k_Numbers),
        [](const glm::dvec4& a, const glm::dvec4&, const glm::dvec4&)
        { return Values(RoundedToHalf(a.x)); },
        Tolerance{0.0, 1e-30});
    grid.Run();
}

TEST_F(HalfPrecisionGpu, RoundsWhatIsAssignedPassedAndReturned)
{
    FunctionGrid grid(k_Functions);
    grid.options = SmallHalf();
    const auto exactly = Tolerance{0.0, 1e-30};
    const auto rounded = [](const glm::dvec4& a, const glm::dvec4&, const glm::dvec4&)
    {
        return Values(RoundedToHalf(a.x));
    };
    for (const char* call :
         {"Assigned(a.x)", "Passed(a.x)", "Returned(a.x)", "Elements(a.x)", "ByReference(a.x)"})
    {
        grid.Add(call, Combine(k_Numbers), rounded, exactly);
    }
    grid.Add(
        "Parts(a.x, b.x)", Combine(k_Numbers, {0.7}),
        [](const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4&)
        { return glm::dvec2(RoundedToHalf(b.x), RoundedToHalf(a.x)); },
        exactly);
    grid.Add(
        "Both(a.x)", Combine(k_Numbers),
        [](const glm::dvec4& a, const glm::dvec4&, const glm::dvec4&)
        { return glm::dvec2(RoundedToHalf(a.x), a.x); },
        exactly);
    grid.Add(
        "Chosen(a.x)", Combine(k_Numbers),
        [](const glm::dvec4& a, const glm::dvec4&, const glm::dvec4&)
        { return std::max(RoundedToHalf(a.x), RoundedToHalf(0.1f)); },
        exactly);
    grid.Run();
}

TEST_F(HalfPrecisionGpu, ComputesHalvesWithHalvesInSixteenBits)
{
    FunctionGrid grid(k_Functions);
    grid.options = SmallHalf();
    const auto exactly = Tolerance{0.0, 1e-30};
    const std::vector<double> some = {1.0, 1.0 / 3.0, 1.00048828125, 2049.0, -3.3, 40000.0};
    const auto add = [&](const char* call, double (*function)(double, double))
    {
        grid.Add(
            call, Combine(some, some),
            [function](const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4&)
            { return RoundedToHalf(function(RoundedToHalf(a.x), RoundedToHalf(b.x))); },
            exactly);
    };
    add("Sum(a.x, b.x)", [](double x, double y) { return x + y; });
    add("Difference(a.x, b.x)", [](double x, double y) { return x - y; });
    add("Product(a.x, b.x)", [](double x, double y) { return x * y; });
    // Vulkan asks for 2.5 units in the last place of a division, and of a root nothing better.
    const auto nearly = Tolerance{3.0 * 0x1p-10, 1e-7};
    grid.Add(
        "Quotient(a.x, b.x)", Combine(some, some),
        [](const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4&)
        { return RoundedToHalf(RoundedToHalf(a.x) / RoundedToHalf(b.x)); },
        nearly);
    grid.Add(
        "Root(a.x)", Combine({1.0, 2.0, 1000.3, 65504.0}),
        [](const glm::dvec4& a, const glm::dvec4&, const glm::dvec4&)
        { return RoundedToHalf(std::sqrt(RoundedToHalf(a.x))); },
        nearly);
    grid.Add(
        "Mixed(a.x, b.x, c.x)", Combine({1.0, 7.3}, {0.0, 2.1}, {0.0, 0.5, 1.0}),
        [](const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c)
        { return std::lerp(RoundedToHalf(a.x), RoundedToHalf(b.x), RoundedToHalf(c.x)); },
        nearly);
    // 1 + 2^-11 is halfway to the next number and rounds to even, twice; taken together, not.
    grid.Add(
        "TwiceMore(a.x)", Combine({1.0}),
        [](const glm::dvec4&, const glm::dvec4&, const glm::dvec4&) { return 1.0; }, exactly);
    // A float makes it an operation on floats.
    grid.Add(
        "Promoted(a.x, b.x)", Combine({1.0, 3.0}, {1.00048828125, 70000.0}),
        [](const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4&)
        { return RoundedToHalf(a.x) * b.x; },
        exactly);
    // Distances of more than 255 pixels have no square.
    grid.Add(
        "Squared(a.xy)", {{{255.0, 0, 0, 0}}, {{256.0, 0, 0, 0}}, {{200.0, 200.0, 0, 0}}},
        [](const glm::dvec4& a, const glm::dvec4&, const glm::dvec4&)
        { return RoundedToHalf(a.x * a.x + a.y * a.y); },
        exactly);
    grid.Run();
}

TEST_F(HalfPrecisionGpu, LeavesFloatsAndWithoutTheSwitchHalvesAlone)
{
    FunctionGrid grid(k_Functions);
    grid.Add("Assigned(a.x)", Combine(k_Numbers),
             [](const glm::dvec4& a, const glm::dvec4&, const glm::dvec4&) { return a.x; },
             {0.0, 1e-30});
    grid.Add("TwiceMore(a.x)", Combine({1.0}),
             [](const glm::dvec4&, const glm::dvec4&, const glm::dvec4&) { return 1.0009765625; },
             {0.0, 1e-30});
    grid.Run();
}

} // namespace
} // namespace limn::test
