#include "arithmetic/ArithmeticTable.h"

#include <algorithm>
#include <bit>
#include <cmath>

// What HLSL's operators and functions of integers give at their edges, in 64 bits.

namespace limn::test
{

namespace
{

const std::vector<std::int64_t> k_Ints = {0,  1,   -1,   7,     -7,           3,         -3,
                                          31, 100, -100, 65536, k_LargestInt, k_LeastInt};
const std::vector<std::int64_t> k_Uints = {
    0, 1, 7, 3, 31, 100, 65536, k_LargestInt, k_LargestInt + 1, k_LargestUint};
const std::vector<std::int64_t> k_Counts = {0, 1, 5, 31, 32, 33, 63, 64, -1};

std::int64_t Whole(const Operand& operand)
{
    return static_cast<std::int64_t>(operand.value);
}
/// What 32 bits keep of it.
double ToInt(std::int64_t value)
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value));
}
double ToUint(std::int64_t value)
{
    return static_cast<std::uint32_t>(value);
}

using WholeFormula = std::function<Outcome(std::int64_t, std::int64_t)>;

void AddWhole(std::vector<ArithmeticRow>& rows, const std::string& hlsl, char result,
              const std::vector<std::vector<Operand>>& lists, WholeFormula formula)
{
    rows.push_back({hlsl, result, Combinations(lists),
                    [formula = std::move(formula)](const Operands& o)
                    {
                        return formula(Whole(o[0]), o.size() > 1 ? Whole(o[1]) : 0);
                    }});
}

void AddSigned(std::vector<ArithmeticRow>& rows)
{
    const auto both = {Ints(k_Ints), Ints(k_Ints)};
    const auto undefined = [](std::int64_t x, std::int64_t y)
    {
        return y == 0                       ? "D3D: an int divided by 0 is undefined"
               : x == k_LeastInt && y == -1 ? "no int is as large"
                                            : nullptr;
    };
    for (const char* hlsl : {"X / Y", "Divided(X, Y)"})
    {
        AddWhole(rows, hlsl, 'i', both,
                 [=](auto x, auto y)
                 {
                     const char* why = undefined(x, y);
                     return why ? Outcome::Open(why) : ToInt(x / y);
                 });
    }
    for (const char* hlsl : {"X % Y", "Assigned(X, Y)"})
    {
        AddWhole(rows, hlsl, 'i', both,
                 [=](auto x, auto y)
                 {
                     const char* why = undefined(x, y);
                     return why ? Outcome::Open(why) : ToInt(x % y);
                 });
    }
    AddWhole(rows, "X + Y", 'i', both, [](auto x, auto y) { return ToInt(x + y); });
    AddWhole(rows, "X - Y", 'i', both, [](auto x, auto y) { return ToInt(x - y); });
    AddWhole(rows, "X * Y", 'i', both,
             [](auto x, auto y)
             {
                 return ToInt(static_cast<std::int64_t>(static_cast<std::uint64_t>(x) *
                                                        static_cast<std::uint64_t>(y)));
             });
    AddWhole(rows, "min(X, Y)", 'i', both, [](auto x, auto y) { return ToInt(std::min(x, y)); });
    AddWhole(rows, "max(X, Y)", 'i', both, [](auto x, auto y) { return ToInt(std::max(x, y)); });
    AddWhole(rows, "clamp(X, -5, Y)", 'i', {Ints(k_Ints), Ints({-5, 0, 50})},
             [](auto x, auto y) { return ToInt(std::clamp<std::int64_t>(x, -5, y)); });
    AddWhole(rows, "mad(X, Y, X)", 'i', both,
             [](auto x, auto y)
             {
                 return ToInt(static_cast<std::int64_t>(static_cast<std::uint64_t>(x) *
                                                        static_cast<std::uint64_t>(y)) +
                              x);
             });
    AddWhole(rows, "(X < Y)", 'u', both, [](auto x, auto y) { return x < y; });
    AddWhole(rows, "(X >= Y)", 'u', both, [](auto x, auto y) { return x >= y; });
    AddWhole(rows, "abs(X)", 'i', {Ints(k_Ints)}, [](auto x, auto) { return ToInt(std::abs(x)); });
    AddWhole(rows, "sign(X)", 'i', {Ints(k_Ints)},
             [](auto x, auto) { return double((x > 0) - (x < 0)); });
    AddWhole(rows, "-X", 'i', {Ints(k_Ints)}, [](auto x, auto) { return ToInt(-x); });
    AddWhole(rows, "~X", 'i', {Ints(k_Ints)}, [](auto x, auto) { return ToInt(~x); });
    AddWhole(rows, "!X", 'u', {Ints(k_Ints)}, [](auto x, auto) { return x == 0; });
    AddWhole(rows, "X & Y", 'i', both, [](auto x, auto y) { return ToInt(x & y); });
    AddWhole(rows, "X | Y", 'i', both, [](auto x, auto y) { return ToInt(x | y); });
    AddWhole(rows, "X ^ Y", 'i', both, [](auto x, auto y) { return ToInt(x ^ y); });
}

void AddUnsigned(std::vector<ArithmeticRow>& rows)
{
    const auto both = {Uints(k_Uints), Uints(k_Uints)};
    // D3D: udiv by 0 gives 0xffffffff twice.
    AddWhole(rows, "X / Y", 'u', both,
             [](auto x, auto y) { return ToUint(y == 0 ? k_LargestUint : x / y); });
    for (const char* hlsl : {"X % Y", "Assigned(X, Y)"})
    {
        AddWhole(rows, hlsl, 'u', both,
                 [](auto x, auto y) { return ToUint(y == 0 ? k_LargestUint : x % y); });
    }
    AddWhole(rows, "X - Y", 'u', both, [](auto x, auto y) { return ToUint(x - y); });
    AddWhole(rows, "X * Y", 'u', both,
             [](auto x, auto y)
             {
                 return ToUint(static_cast<std::int64_t>(static_cast<std::uint64_t>(x) *
                                                         static_cast<std::uint64_t>(y)));
             });
    AddWhole(rows, "min(X, Y)", 'u', both, [](auto x, auto y) { return ToUint(std::min(x, y)); });
    AddWhole(rows, "max(X, Y)", 'u', both, [](auto x, auto y) { return ToUint(std::max(x, y)); });
    AddWhole(rows, "mad(X, Y, X)", 'u', both,
             [](auto x, auto y)
             {
                 const auto factor = static_cast<std::uint64_t>(x);
                 return ToUint(static_cast<std::int64_t>(factor * static_cast<std::uint64_t>(y) +
                                                         factor)); // modulo 2^64
             });
    AddWhole(rows, "(X < Y)", 'u', both, [](auto x, auto y) { return x < y; });
    AddWhole(rows, "-X", 'u', {Uints(k_Uints)}, [](auto x, auto) { return ToUint(-x); });
    AddWhole(rows, "abs(X)", 'u', {Uints(k_Uints)}, [](auto x, auto) { return ToUint(x); });
    // An int beside a uint counts as one.
    const auto mixed = {Ints({-7, -1, 5, 7}), Uints({1, 2, 3, 10})};
    AddWhole(rows, "X / Y", 'u', mixed,
             [](auto x, auto y) { return ToUint((x & k_LargestUint) / y); });
    AddWhole(rows, "X % Y", 'u', mixed,
             [](auto x, auto y) { return ToUint((x & k_LargestUint) % y); });
    AddWhole(rows, "max(X, Y)", 'u', mixed,
             [](auto x, auto y) { return ToUint(std::max(x & k_LargestUint, y)); });
    AddWhole(rows, "(X < Y)", 'u', mixed, [](auto x, auto y) { return (x & k_LargestUint) < y; });
}

void AddShifts(std::vector<ArithmeticRow>& rows)
{
    // D3D: of the count the lowest five bits are taken.
    for (const auto& counts : {Ints(k_Counts), Uints({0, 1, 31, 32, 33, 64, k_LargestUint})})
    {
        AddWhole(rows, "X << Y", 'i', {Ints(k_Ints), counts},
                 [](auto x, auto y) { return ToInt(x * (std::int64_t{1} << (y & 31))); });
        AddWhole(rows, "X >> Y", 'i', {Ints(k_Ints), counts},
                 [](auto x, auto y) { return ToInt(x >> (y & 31)); });
        AddWhole(rows, "X << Y", 'u', {Uints(k_Uints), counts},
                 [](auto x, auto y) { return ToUint(x << (y & 31)); });
        AddWhole(rows, "X >> Y", 'u', {Uints(k_Uints), counts},
                 [](auto x, auto y) { return ToUint(x >> (y & 31)); });
    }
    AddWhole(rows, "ShiftedLeft(X, Y)", 'i', {Ints(k_Ints), Ints(k_Counts)},
             [](auto x, auto y) { return ToInt(x * (std::int64_t{1} << (y & 31))); });
    AddWhole(rows, "ShiftedRight(X, Y)", 'i', {Ints(k_Ints), Ints(k_Counts)},
             [](auto x, auto y) { return ToInt(x >> (y & 31)); });
}

void AddBits(std::vector<ArithmeticRow>& rows)
{
    const auto word = [](std::int64_t x)
    {
        return static_cast<std::uint32_t>(x);
    };
    const auto lowest = [=](auto x, auto)
    {
        return word(x) == 0 ? -1.0 : std::countr_zero(word(x));
    };
    const auto reversed = [=](std::int64_t x)
    {
        std::uint32_t result = 0;
        for (int bit = 0; bit < 32; ++bit)
        {
            result |= (word(x) >> bit & 1u) << (31 - bit);
        }
        return result;
    };
    const std::vector<std::int64_t> uints = {
        0, 1, 8, 12, 0x80000000ll, 0x7fffffff, k_LargestUint, 0x00f0ff00};
    const std::vector<std::int64_t> ints = {0, 1, 8, 12, k_LargestInt, k_LeastInt, -1, -2, -8, -9};
    AddWhole(rows, "countbits(X)", 'u', {Uints(uints)},
             [=](auto x, auto) { return std::popcount(word(x)); });
    AddWhole(rows, "countbits(X)", 'u', {Ints(ints)},
             [=](auto x, auto) { return std::popcount(word(x)); });
    AddWhole(rows, "firstbitlow(X)", 'i', {Uints(uints)}, lowest);
    AddWhole(rows, "firstbitlow(X)", 'i', {Ints(ints)}, lowest);
    // HLSL: from the lowest bit; -1 where there is none. Of a negative number the first 0.
    AddWhole(rows, "firstbithigh(X)", 'i', {Uints(uints)},
             [=](auto x, auto) { return 31.0 - std::countl_zero(word(x)); });
    AddWhole(rows, "firstbithigh(X)", 'i', {Ints(ints)},
             [=](auto x, auto) { return 31.0 - std::countl_zero(word(x < 0 ? ~x : x)); });
    AddWhole(rows, "reversebits(X)", 'u', {Uints(uints)},
             [=](auto x, auto) { return ToUint(reversed(x)); });
    AddWhole(rows, "reversebits(X)", 'i', {Ints(ints)},
             [=](auto x, auto) { return ToInt(reversed(x)); });
}

} // namespace

void AddIntegerRows(std::vector<ArithmeticRow>& rows)
{
    AddSigned(rows);
    AddUnsigned(rows);
    AddShifts(rows);
    AddBits(rows);
}

} // namespace limn::test
