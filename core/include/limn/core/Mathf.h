#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn
{

/// Unity's float functions under their names, so that lines of C# can be ported as they are. A
/// comment documents a function that differs from the one of std::. Angles are in radians.
/// Unity: UnityEngine.Mathf (2022.3).
struct Mathf
{
    static constexpr float PI = 3.14159265358979f;
    static constexpr float Deg2Rad = PI / 180.0f;
    static constexpr float Rad2Deg = 180.0f / PI;
    static constexpr float Infinity = std::numeric_limits<float>::infinity();
    static constexpr float NegativeInfinity = -Infinity;
    /// The smallest float above 0, denormalised ones included: C#'s float.Epsilon, not C++'s.
    static constexpr float Epsilon = std::numeric_limits<float>::denorm_min();

    static float Sin(float x) { return std::sin(x); }
    static float Cos(float x) { return std::cos(x); }
    static float Tan(float x) { return std::tan(x); }
    static float Asin(float x) { return std::asin(x); }
    static float Acos(float x) { return std::acos(x); }
    static float Atan(float x) { return std::atan(x); }
    static float Atan2(float y, float x) { return std::atan2(y, x); }
    static float Sqrt(float x) { return std::sqrt(x); }
    static float Pow(float x, float power) { return std::pow(x, power); }
    static float Exp(float x) { return std::exp(x); }
    static float Log(float x) { return std::log(x); }
    static float Log(float x, float base) { return std::log(x) / std::log(base); }
    static float Log10(float x) { return std::log10(x); }

    template <typename T>
    static T Abs(T x)
    {
        return std::abs(x);
    }
    template <typename T>
    static constexpr T Min(T a, T b)
    {
        return a < b ? a : b;
    }
    template <typename T>
    static constexpr T Max(T a, T b)
    {
        return a > b ? a : b;
    }
    /// Returns x clamped to the range; `minimum` wins if the two are the wrong way round; NaN
    /// stays.
    template <typename T>
    static constexpr T Clamp(T x, T minimum, T maximum)
    {
        return x < minimum ? minimum : x > maximum ? maximum : x;
    }
    static constexpr float Clamp01(float x) { return Clamp(x, 0.0f, 1.0f); }

    static float Floor(float x) { return std::floor(x); }
    static float Ceil(float x) { return std::ceil(x); }
    /// Returns the nearest whole number; halves go to the even neighbour: 0.5 gives 0, 1.5 and 2.5
    /// give 2.
    static float Round(float x) { return x - std::remainder(x, 1.0f); }
    /// Returns the number as an int: the nearest int if none holds it, and 0 for NaN. C# leaves
    /// these undefined.
    static int ToInt(float whole)
    {
        constexpr double k_Low = std::numeric_limits<int>::min();
        constexpr double k_High = std::numeric_limits<int>::max();
        return std::isnan(whole) ? 0 : static_cast<int>(Clamp<double>(whole, k_Low, k_High));
    }
    static int FloorToInt(float x) { return ToInt(Floor(x)); }
    static int CeilToInt(float x) { return ToInt(Ceil(x)); }
    static int RoundToInt(float x) { return ToInt(Round(x)); }

    /// Returns 1 for numbers from 0 on, and -1 below.
    static constexpr float Sign(float x) { return x >= 0.0f ? 1.0f : -1.0f; }

    /// Interpolates between a and b; t is clamped to 0...1.
    static constexpr float Lerp(float a, float b, float t) { return a + (b - a) * Clamp01(t); }
    static constexpr float LerpUnclamped(float a, float b, float t) { return a + (b - a) * t; }
    /// Returns the place of x between the two, 0...1; 0 if they are equal.
    static constexpr float InverseLerp(float a, float b, float x)
    {
        return a == b ? 0.0f : Clamp01((x - a) / (b - a));
    }
    /// Interpolates smoothly from one value to another. It is not HLSL's smoothstep, which takes
    /// the ends of x.
    static constexpr float SmoothStep(float from, float to, float t)
    {
        const float x = Clamp01(t);
        const float y = x * x * (3.0f - 2.0f * x);
        return to * y + from * (1.0f - y);
    }
    static float MoveTowards(float current, float target, float maxDelta)
    {
        return std::abs(target - current) <= maxDelta ? target
                                                      : current + Sign(target - current) * maxDelta;
    }
    /// Returns x modulo `length`, which is never below 0.
    static float Repeat(float x, float length)
    {
        return Clamp(x - std::floor(x / length) * length, 0.0f, length);
    }
    static float PingPong(float x, float length)
    {
        return length - std::abs(Repeat(x, 2.0f * length) - length);
    }
    /// Returns whether the two differ by at most a millionth of the larger one, or by eight times
    /// Epsilon.
    static bool Approximately(float a, float b)
    {
        return std::abs(b - a) < Max(1e-6f * Max(std::abs(a), std::abs(b)), Epsilon * 8.0f);
    }

    static constexpr bool IsPowerOfTwo(int x) { return x > 0 && (x & (x - 1)) == 0; }
    /// Returns the least power of two that is at least x; 0 if x is not above 0 or is above 2^30.
    static constexpr int NextPowerOfTwo(int x)
    {
        if (x <= 0 || x > (1 << 30))
        {
            return 0;
        }
        int power = 1;
        while (power < x)
        {
            power *= 2;
        }
        return power;
    }
};

} // namespace limn
