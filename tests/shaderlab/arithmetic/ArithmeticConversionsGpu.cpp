#include "arithmetic/ArithmeticTable.h"

#include <algorithm>
#include <cmath>

// What numbers become when HLSL makes others of them.

namespace limn::test
{

namespace
{

const std::vector<double> k_Floats = {
    0.0,  -0.0,         0.5,          -0.5,          0.999,         2.7,          -2.7,         1e9,
    -1e9, 2147483520.0, 2147483648.0, -2147483648.0, -2147483904.0, 4294967040.0, 4294967296.0, 3e9,
    1e20, -1e20,        HUGE_VAL,     -HUGE_VAL,     NAN,           -1.0,         -1.5};

using ConversionFormula = std::function<Outcome(double)>;

void AddConversion(std::vector<ArithmeticRow>& rows, const std::string& hlsl, char result,
                   const std::vector<Operand>& operands, ConversionFormula formula)
{
    rows.push_back({hlsl, result, Combinations({operands}),
                    [formula = std::move(formula)](const Operands& o)
                    {
                        return formula(o[0].value);
                    }});
}

/// D3D: cut towards 0; what is out of range becomes the nearest, NaN 0.
double Cut(double x, double least, double most)
{
    return std::isnan(x) ? 0.0 : std::clamp(std::trunc(x), least, most);
}

/// A float of 16 bits, denormal ones as well.
double FromHalf(std::uint32_t bits)
{
    const double sign = (bits & 0x8000u) != 0 ? -1.0 : 1.0;
    const int exponent = static_cast<int>(bits >> 10 & 31u);
    const double fraction = (bits & 1023u) / 1024.0;
    return exponent == 31  ? (fraction == 0.0 ? sign * HUGE_VAL : NAN)
           : exponent == 0 ? sign * std::ldexp(fraction, -14)
                           : sign * std::ldexp(1.0 + fraction, exponent - 15);
}

/// D3D leaves open which neighbour a value between two becomes.
Outcome ToHalf(double x)
{
    if (std::isnan(x))
    {
        return Outcome::Open("which NaN it is");
    }
    if (std::isinf(x))
    {
        return Outcome::ByDriver(x > 0 ? 0x7c00 : 0xfc00, "SwiftShader gives more than 16 bits");
    }
    for (std::uint32_t bits = 0; bits <= 0x7c00u; ++bits)
    {
        if (FromHalf(bits) == std::abs(x))
        {
            return double(bits | (std::signbit(x) ? 0x8000u : 0u));
        }
    }
    return Outcome::Open("D3D: either neighbour");
}

} // namespace

void AddConversionRows(std::vector<ArithmeticRow>& rows)
{
    const auto toInt = [](double x)
    {
        return Cut(x, double(k_LeastInt), double(k_LargestInt));
    };
    const auto toUint = [](double x)
    {
        return Cut(x, 0.0, double(k_LargestUint));
    };
    const auto unequal = [](double x)
    {
        return x != 0.0 ? 1.0 : 0.0;
    };
    for (const char* hlsl : {"(INT)(X)", "GivenInt(X)"})
    {
        AddConversion(rows, hlsl, 'i', Floats(k_Floats), toInt);
    }
    for (const char* hlsl : {"(UINT)(X)", "GivenUint(X)"})
    {
        AddConversion(rows, hlsl, 'u', Floats(k_Floats), toUint);
    }
    AddConversion(rows, "(BOOL)(X)", 'u', Floats(k_Floats), unequal); // NaN differs from 0
    AddConversion(rows, "!X", 'u', Floats(k_Floats), [=](double x) { return 1.0 - unequal(x); });
    AddConversion(rows, "isnan(X)", 'u', Floats(k_Floats), [](double x) { return std::isnan(x); });
    AddConversion(rows, "isinf(X)", 'u', Floats(k_Floats), [](double x) { return std::isinf(x); });
    AddConversion(rows, "isfinite(X)", 'u', Floats(k_Floats),
                  [](double x) { return std::isfinite(x); });
    AddConversion(rows, "sign(X)", 'i', Floats(k_Floats),
                  [](double x)
                  {
                      return std::isnan(x) ? Outcome::Open("HLSL: smaller, equal or greater than 0")
                                           : Outcome((x > 0) - (x < 0));
                  });
    const auto ints = Ints({0, 1, -1, 16777217, 16777219, -16777217, k_LargestInt, k_LeastInt});
    const auto uints =
        Uints({0, 1, 16777217, k_LargestInt, k_LargestUint, 2147483648ll, 4294967167ll});
    const auto nearest = [](double x)
    {
        return static_cast<double>(static_cast<float>(x));
    };
    AddConversion(rows, "(FLOAT)(X)", 'f', ints, nearest);
    AddConversion(rows, "(FLOAT)(X)", 'f', uints,
                  [=](double x)
                  {
                      return x > 2147483648.0
                                 ? Outcome::ByDriver(nearest(x), "SwiftShader rounds it twice")
                                 : Outcome(nearest(x));
                  });
    AddConversion(rows, "(BOOL)(X)", 'u', ints, unequal);
    AddConversion(rows, "(BOOL)(X)", 'u', uints, unequal);
    AddConversion(rows, "(FLOAT)(X != 0)", 'f', ints, unequal);
    AddConversion(rows, "(INT)(X != 0)", 'i', ints, unequal);
    AddConversion(rows, "(UINT)(X)", 'u', ints,
                  [](double x) { return x < 0 ? x + 4294967296.0 : x; });
    AddConversion(rows, "(INT)(X)", 'i', uints,
                  [](double x) { return x > double(k_LargestInt) ? x - 4294967296.0 : x; });
    // Bits stay what they are.
    rows.push_back({"asuint(X)", 'u',
                    Combinations({Floats({0.0, -0.0, 1.0, -2.5, 1e30, HUGE_VAL, -HUGE_VAL})}),
                    [](const Operands& o)
                    {
                        return double(o[0].bits);
                    }});
    rows.push_back({"asint(X)", 'i',
                    Combinations({Floats({0.0, -0.0, 1.0, -2.5, 1e30, HUGE_VAL, -HUGE_VAL})}),
                    [](const Operands& o)
                    {
                        return double(static_cast<std::int32_t>(o[0].bits));
                    }});
    rows.push_back(
        {"asuint(asfloat(X))", 'u',
         Combinations({Uints({0, 0x80000000ll, 0x3f800000, 0x7f800000, 0x00800000, 0xff800000ll})}),
         [](const Operands& o)
         {
             return double(o[0].bits);
         }});
    const auto halves = Uints({0, 0x8000, 0x3c00, 0xbc00, 0x7bff, 0x7c00, 0xfc00, 0x7e00, 0x0400,
                               0x0001, 0x83ff, 0x3555, 0xffff3c00ll});
    rows.push_back({"f16tof32(X)", 'f', Combinations({halves}),
                    [](const Operands& o)
                    {
                        return FromHalf(o[0].bits & 0xffffu);
                    }});
    AddConversion(rows, "f32tof16(X)", 'u',
                  Floats({0.0, -0.0, 1.0, -1.0, 65504.0, 0.333251953125, HUGE_VAL, -HUGE_VAL, NAN,
                          0x1p-14, 0x1p-24, 0x1.8p-20, 1.0005, 100.3}),
                  ToHalf);
}

} // namespace limn::test
