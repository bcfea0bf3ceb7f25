#include "arithmetic/ArithmeticTable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// What HLSL's functions of floats give at their edges. "D3D" is the Direct3D 11.3 functional
// specification, "HLSL" Microsoft's reference of the language.

namespace limn::test
{

namespace
{

constexpr double k_Infinity = HUGE_VAL;
const double k_NoNumber = std::nan("");

const std::vector<double> k_Edges = {
    0.0,  -0.0,  0.5,   -0.5,       1.0,        -1.0,        1.5,
    -1.5, 2.5,   -2.5,  3.5,        -3.5,       0.25,        -1.25,
    0.75, 2.0,   -3.0,  0.49999997, 8388607.5,  -8388607.5,  16777217.0,
    1e10, -1e10, 100.3, -0.001,     k_Infinity, -k_Infinity, k_NoNumber};

/// Where functions that devices approximate are right to a few bits.
constexpr double k_Near = 2e-6;
constexpr double k_Trigonometry = 4e-4; // Vulkan's and D3D's own limit is 2^-11, absolute

void Add1(std::vector<ArithmeticRow>& rows, const std::string& hlsl,
          const std::vector<double>& values, std::function<Outcome(double)> formula,
          double tolerance = 0.0, double absolute = 0.0)
{
    rows.push_back({hlsl, 'f', Combinations({Floats(values)}),
                    [formula = std::move(formula)](const Operands& o)
                    { return formula(o[0].value); },
                    tolerance, absolute});
}

void Add2(std::vector<ArithmeticRow>& rows, const std::string& hlsl, const std::vector<double>& xs,
          const std::vector<double>& ys, std::function<Outcome(double, double)> formula,
          double tolerance = 0.0, double absolute = 0.0)
{
    rows.push_back({hlsl, 'f', Combinations({Floats(xs), Floats(ys)}),
                    [formula = std::move(formula)](const Operands& o)
                    { return formula(o[0].value, o[1].value); },
                    tolerance, absolute});
}

void Add3(std::vector<ArithmeticRow>& rows, const std::string& hlsl, const std::vector<double>& xs,
          const std::vector<double>& ys, const std::vector<double>& zs,
          std::function<Outcome(double, double, double)> formula, double tolerance = 0.0,
          double absolute = 0.0)
{
    rows.push_back({hlsl, 'f', Combinations({Floats(xs), Floats(ys), Floats(zs)}),
                    [formula = std::move(formula)](const Operands& o)
                    { return formula(o[0].value, o[1].value, o[2].value); },
                    tolerance, absolute});
}

Outcome NoNumberByDriver()
{
    return Outcome::ByDriver(k_NoNumber, "Vulkan does not make drivers keep NaN and infinity");
}

/// Of what functions that devices approximate give.
Outcome ByDriverOfNaN(double operand, double wanted)
{
    return std::isnan(operand) ? NoNumberByDriver() : Outcome(wanted);
}

Outcome Logarithm(double x, double (*formula)(double))
{
    return x < 0.0 ? Outcome::ByDriver(k_NoNumber, "to Vulkan it is undefined")
                   : ByDriverOfNaN(x, formula(x));
}

double RoundToEven(double x)
{
    const double below = std::floor(x);
    const double fraction = x - below;
    const bool isBelowEven = std::fmod(below, 2.0) == 0.0;
    return !std::isfinite(x) || fraction == 0.0                 ? x
           : fraction < 0.5 || (fraction == 0.5 && isBelowEven) ? below
                                                                : below + 1.0;
}

/// HLSL: x = i * y + f, f has the sign of x and is smaller than y.
Outcome Remainder(double x, double y)
{
    if (y == 0.0 || !std::isfinite(x) || !std::isfinite(y))
    {
        return Outcome::Open("HLSL: a finite x and a y that divides it are meant");
    }
    if (std::isnan(x) || std::isnan(y))
    {
        return k_NoNumber;
    }
    if (std::abs(x / y) >= 0x1p22)
    {
        return Outcome::Open("a float holds no fraction of so large a quotient");
    }
    // y * trunc(x / y) is rounded where it is no whole number.
    const bool isExact = x == std::trunc(x) && y == std::trunc(y);
    return Outcome::Rest(std::fmod(x, y), x, y, isExact ? 0.0 : std::abs(x) * 0x1p-23);
}

/// D3D: of a number and NaN it is the number.
double Lesser(double a, double b)
{
    return std::isnan(a) ? b : std::isnan(b) ? a : std::min(a, b);
}
double Greater(double a, double b)
{
    return std::isnan(a) ? b : std::isnan(b) ? a : std::max(a, b);
}

void AddRounding(std::vector<ArithmeticRow>& rows)
{
    Add1(rows, "round(X)", k_Edges, RoundToEven);
    Add1(rows, "floor(X)", k_Edges, [](double x) { return std::floor(x); });
    Add1(rows, "ceil(X)", k_Edges, [](double x) { return std::ceil(x); });
    Add1(rows, "trunc(X)", k_Edges, [](double x) { return std::trunc(x); });
    Add1(rows, "frac(X)", k_Edges,
         [](double x)
         { return std::isfinite(x) ? Outcome(x - std::floor(x)) : NoNumberByDriver(); }); // D3D
    Add1(rows, "Rest(X)", k_Edges,
         [](double x)
         {
             return std::isinf(x)   ? Outcome::Open("HLSL: of finite numbers")
                    : std::isnan(x) ? NoNumberByDriver()
                                    : Outcome(x - std::trunc(x));
         });
    Add1(rows, "Whole(X)", k_Edges,
         [](double x)
         { return std::isinf(x) ? Outcome::Open("HLSL: of finite numbers") : std::trunc(x); });
    Add1(rows, "abs(X)", k_Edges, [](double x) { return std::abs(x); });
    Add1(rows, "-X", k_Edges, [](double x) { return -x; });
    Add1(rows, "saturate(X)", k_Edges,
         [](double x) // D3D: NaN becomes 0
         { return std::isnan(x) ? 0.0 : std::clamp(x, 0.0, 1.0); });
}

void AddRemainders(std::vector<ArithmeticRow>& rows)
{
    const std::vector<double> xs = {-1.3,    1.3,       5.0,       -5.0,       5.5,       -5.5,
                                    6.0,     -6.0,      0.3,       7.0,        -7.0,      1000.7,
                                    -1000.7, 1e5,       1e6,       0.0,        -0.0,      5.9999995,
                                    100.3,   6.2831845, 12345.678, k_Infinity, k_NoNumber};
    const std::vector<double> ys = {1.0,  -1.0,      3.0, -3.0, 2.0,       0.1,
                                    -0.7, 6.2831855, 1e7, 0.0,  k_Infinity};
    for (const char* hlsl : {"fmod(X, Y)", "X % Y", "Assigned(X, Y)"})
    {
        Add2(rows, hlsl, xs, ys, Remainder);
    }
}

void AddChoices(std::vector<ArithmeticRow>& rows)
{
    const std::vector<double> some = {0.0, 1.0, -1.0, 2.5, k_Infinity, -k_Infinity, k_NoNumber};
    Add2(rows, "min(X, Y)", some, some, Lesser);
    Add2(rows, "max(X, Y)", some, some, Greater);
    Add3(rows, "clamp(X, Y, Z)", {-3.0, 0.0, 0.5, 7.0, k_Infinity, -k_Infinity, k_NoNumber},
         {-1.0, 0.25}, {1.0, 0.0},
         [](double x, double low, double high)
         {
             return std::isnan(x) ? Outcome::Open("HLSL: of NaN it is undefined")
                    : low > high  ? Outcome::Open("HLSL: the bounds are in order")
                                  : Outcome(std::clamp(x, low, high));
         });
    // HLSL: 1 where x is greater than or equal to y, otherwise 0.
    Add2(rows, "step(X, Y)", some, some, [](double y, double x) { return x >= y ? 1.0 : 0.0; });
    for (const auto& [sign, compare] :
         std::initializer_list<std::pair<const char*, bool (*)(double,
                                                               double)>>{{"<",
                                                                          [](double a, double b)
                                                                          {
                                                                              return a < b;
                                                                          }},
                                                                         {"<=",
                                                                          [](double a, double b)
                                                                          {
                                                                              return a <= b;
                                                                          }},
                                                                         {">",
                                                                          [](double a, double b)
                                                                          {
                                                                              return a > b;
                                                                          }},
                                                                         {">=",
                                                                          [](double a, double b)
                                                                          {
                                                                              return a >= b;
                                                                          }},
                                                                         {"==",
                                                                          [](double a, double b)
                                                                          {
                                                                              return a == b;
                                                                          }},
                                                                         {"!=",
                                                                          [](double a, double b)
                                                                          {
                                                                              return a != b;
                                                                          }}})
    {
        Add2(rows, std::string("(X ") + sign + " Y)", some, some,
             [compare = compare](double x, double y) { return compare(x, y) ? 1.0 : 0.0; });
        rows.back().result = 'u';
    }
}

void AddBlends(std::vector<ArithmeticRow>& rows)
{
    Add3(
        rows, "lerp(X, Y, Z)", {0.0, 1.0, -4.0}, {2.0, 0.5}, {0.0, 1.0, 0.25, -1.0, 3.0},
        [](double x, double y, double s) { return x + s * (y - x); }, k_Near);
    Add3(
        rows, "smoothstep(X, Y, Z)", {0.0, 1.0, -2.0}, {1.0, 0.0, 4.0},
        {-5.0, 0.0, 0.25, 0.5, 1.0, 3.0, 9.0, k_Infinity, -k_Infinity},
        [](double low, double high, double x)
        {
            if (low == high)
            {
                return Outcome::Open("HLSL: the range is empty");
            }
            const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
            return Outcome(t * t * (3.0 - 2.0 * t));
        },
        k_Near, 1e-6);
    Add3(rows, "mad(X, Y, Z)", {0.0, 1.5, -2.0}, {3.0, -0.5}, {1.0, -7.25},
         [](double x, double y, double z) { return x * y + z; });
    Add1(
        rows, "degrees(X)", {0.0, 1.0, -2.0, k_Infinity},
        [](double x) { return x * 180.0 / std::numbers::pi; }, k_Near);
    Add1(
        rows, "radians(X)", {0.0, 180.0, -90.0, k_Infinity},
        [](double x) { return x * std::numbers::pi / 180.0; }, k_Near);
}

void AddPowers(std::vector<ArithmeticRow>& rows)
{
    const std::vector<double> values = {0.0,   -0.0,       0.25,        1.0,       2.0,
                                        4.0,   9.0,        1e10,        -1.0,      -4.0,
                                        1e-10, k_Infinity, -k_Infinity, k_NoNumber};
    Add1(
        rows, "sqrt(X)", values, [](double x) { return std::sqrt(x); }, k_Near);
    Add1(
        rows, "rsqrt(X)", values, [](double x) { return 1.0 / std::sqrt(x); }, k_Near);
    Add1(
        rows, "rcp(X)", values, [](double x) { return 1.0 / x; }, k_Near);
    Add1(
        rows, "log2(X)", values,
        [](double x) { return Logarithm(x, [](double v) { return std::log2(v); }); }, k_Near, 1e-5);
    Add1(
        rows, "log(X)", values,
        [](double x) { return Logarithm(x, [](double v) { return std::log(v); }); }, k_Near, 1e-5);
    Add1(
        rows, "log10(X)", values,
        [](double x) { return Logarithm(x, [](double v) { return std::log10(v); }); }, k_Near,
        1e-5);
    const std::vector<double> exponents = {0.0,   1.0,    -1.0,       0.5,         10.0,      -20.0,
                                           200.0, -200.0, k_Infinity, -k_Infinity, k_NoNumber};
    Add1(
        rows, "exp2(X)", exponents, [](double x) { return ByDriverOfNaN(x, std::exp2(x)); }, 1e-5,
        1e-37);
    Add1(
        rows, "exp(X)", exponents,
        [](double x) { return ByDriverOfNaN(x, static_cast<float>(std::exp(x))); }, 2e-5, 1e-37);
    Add2(
        rows, "pow(X, Y)", {0.0, 0.25, 1.0, 2.0, 10.0, -2.0}, {0.0, 1.0, 2.0, -1.0, 0.5, 3.0, -2.5},
        [](double x, double y)
        {
            if (x < 0.0)
            {
                const bool isWhole = y == std::trunc(y);
                return isWhole
                           ? Outcome::Open("HLSL: NaN; Microsoft's compiler multiplies where the "
                                           "exponent is a whole constant")
                           : Outcome::ByDriver(k_NoNumber, "to Vulkan it is undefined");
            }
            return x == 0.0 && y == 0.0 ? Outcome::Open("HLSL: 1 or NaN, by the device")
                                        : Outcome(std::pow(x, y));
        },
        2e-5, 1e-18);
    rows.push_back(
        {"ldexp(X, Y)", 'f',
         Combinations({Floats({0.0, 1.0, -3.5, k_Infinity}), Floats({0.0, 1.0, 3.0, -2.0, 10.0})}),
         [](const Operands& o) { return o[0].value * std::exp2(o[1].value); }, 1e-5});
    Add1(rows, "Mantissa(X)", {0.0, 1.0, 0.75, 10.0, -3.0, 1e-3, -0.5},
         [](double x)
         {
             int e = 0;
             return std::frexp(x, &e);
         });
    Add1(rows, "Exponent(X)", {0.0, 1.0, 0.75, 10.0, -3.0, 1e-3, -0.5},
         [](double x)
         {
             int e = 0;
             std::frexp(x, &e);
             return double(e);
         });
}

void AddAngles(std::vector<ArithmeticRow>& rows)
{
    const std::vector<double> angles = {0.0, 0.5, -1.0, 1.5707964, 3.0, k_Infinity, k_NoNumber};
    Add1(
        rows, "sin(X)", angles, [](double x) { return std::sin(x); }, 0.0, k_Trigonometry);
    Add1(
        rows, "cos(X)", angles, [](double x) { return std::cos(x); }, 0.0, k_Trigonometry);
    Add1(
        rows, "Sine(X)", angles, [](double x) { return std::sin(x); }, 0.0, k_Trigonometry);
    Add1(
        rows, "Cosine(X)", angles, [](double x) { return std::cos(x); }, 0.0, k_Trigonometry);
    Add1(
        rows, "tan(X)", {0.0, 0.5, -1.0, 1.25, k_Infinity}, [](double x) { return std::tan(x); },
        1e-3, k_Trigonometry);
    const std::vector<double> sines = {0.0,   1.0, -1.0, 0.5,        -0.25,
                                       0.999, 1.5, -2.0, k_Infinity, k_NoNumber};
    Add1(
        rows, "asin(X)", sines, [](double x) { return std::asin(x); }, 0.0, 1e-3);
    Add1(
        rows, "acos(X)", sines, [](double x) { return std::acos(x); }, 0.0, 1e-3);
    Add1(
        rows, "atan(X)", {0.0, 1.0, -1.0, 10.0, -1e10, k_Infinity, -k_Infinity, k_NoNumber},
        [](double x)
        {
            return std::isnan(x) ? Outcome::Open("HLSL: of angles; Microsoft's compiler drops NaN")
                                 : Outcome(std::atan(x));
        },
        0.0, k_Trigonometry);
    Add2(
        rows, "atan2(X, Y)", {0.0, 1.0, -1.0, 1e10}, {0.0, 1.0, -1.0, -1e10},
        [](double y, double x)
        {
            return x == 0.0 && y == 0.0 ? Outcome::Open("HLSL: not defined at the origin")
                                        : Outcome(std::atan2(y, x));
        },
        0.0, 1e-3);
    const std::vector<double> some = {0.0,  1.0,        -1.0,        5.0,
                                      -5.0, k_Infinity, -k_Infinity, k_NoNumber};
    Add1(
        rows, "sinh(X)", some, [](double x) { return std::sinh(x); }, 1e-5, 1e-5);
    Add1(
        rows, "cosh(X)", some, [](double x) { return ByDriverOfNaN(x, std::cosh(x)); }, 1e-5);
    Add1(
        rows, "tanh(X)",
        {0.0, 1.0, -1.0, 5.0, -5.0, 20.0, 100.0, -100.0, k_Infinity, -k_Infinity, k_NoNumber},
        [](double x)
        {
            return std::abs(x) > 88.0 ? Outcome::Open("Microsoft's compiler divides e^x, which is "
                                                      "infinite, by itself")
                                      : ByDriverOfNaN(x, std::tanh(x));
        },
        1e-5, 1e-5);
}

void AddVectors(std::vector<ArithmeticRow>& rows)
{
    const std::vector<double> some = {0.0, 1.0, -2.0, 3.0};
    const auto whole = [&](const char* hlsl, std::function<Outcome(double, double)> formula)
    {
        Add2(rows, hlsl, some, some, std::move(formula), k_Near, 1e-6);
        rows.back().isComponentwise = false;
    };
    whole("dot(float2(X, Y), float2(Y, 1))", [](double x, double y) { return x * y + y; });
    whole("length(float2(X, Y))", [](double x, double y) { return std::hypot(x, y); });
    whole("length(X) + Y", [](double x, double y) { return std::abs(x) + y; });
    whole("distance(float3(X, Y, 1), float3(1, X, Y))",
          [](double x, double y) { return std::hypot(x - 1, y - x, 1 - y); });
    whole("cross(float3(X, Y, 1), float3(1, X, Y)).y",
          [](double x, double y) { return 1.0 - x * y; });
    whole("normalize(float2(X, Y)).x",
          [](double x, double y)
          {
              return x == 0 && y == 0 ? Outcome::Open("HLSL: of a zero vector it is indefinite")
                                      : Outcome(x / std::hypot(x, y));
          });
    whole("reflect(float2(X, Y), float2(0, 1)).y", [](double, double y) { return -y; });
    // HLSL: where all is reflected, 0.
    whole("refract(normalize(float2(X, -4)), float2(0, 1), 3.0 + 0 * Y).x",
          [](double x, double)
          {
              const double length = std::hypot(x, 4.0);
              const double cosine = 4.0 / length;
              const double k = 1.0 - 9.0 * (1.0 - cosine * cosine);
              return k < 0 ? 0.0 : 3.0 * x / length;
          });
    whole("faceforward(float2(1, 2), float2(X, Y), float2(1, 1)).y",
          [](double x, double y) { return x + y < 0.0 ? 2.0 : -2.0; });
    whole("any(float2(X, Y)) ? 1 : 0", [](double x, double y) { return x != 0 || y != 0; });
    whole("all(float2(X, Y)) ? 1 : 0", [](double x, double y) { return x != 0 && y != 0; });
    whole("dst(float4(1, X, 2, 3), float4(4, Y, 5, 6)).y",
          [](double x, double y) { return x * y; });
    // HLSL: (1, max(n·l, 0), n·l < 0 || n·h < 0 ? 0 : (n·h)^m, 1)
    whole("lit(X, Y, 2).y", [](double x, double) { return std::max(x, 0.0); });
    whole("lit(X, Y, 2).z",
          [](double x, double y) { return x < 0 || y < 0 ? Outcome(0.0) : Outcome(y * y); });
    whole("determinant(float2x2(X, Y, 3, 1))", [](double x, double y) { return x - 3 * y; });
}

} // namespace

void AddFloatRows(std::vector<ArithmeticRow>& rows)
{
    AddRounding(rows);
    AddRemainders(rows);
    AddChoices(rows);
    AddBlends(rows);
    AddPowers(rows);
    AddAngles(rows);
    AddVectors(rows);
}

} // namespace limn::test
