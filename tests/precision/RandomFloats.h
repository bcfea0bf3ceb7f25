#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace limn::test
{

/// The distance to the next float away from zero, in double.
inline double Ulp(float value)
{
    constexpr float k_Largest = std::numeric_limits<float>::max();
    const float size = std::min(std::abs(value), std::nextafter(k_Largest, 0.0f));
    const float next = std::nextafter(size, k_Largest);
    return static_cast<double>(next) - static_cast<double>(size);
}

/// Finite floats of all sizes: ordinary ones, random bits (every exponent is as likely), the ends
/// of the ranges, zeros of both signs, and neighbours and copies of what came before. The same ones
/// in every run.
class RandomFloats
{
public:
    explicit RandomFloats(std::uint64_t seed) : m_Random(seed) {}

    float Any()
    {
        const std::uint64_t bits = m_Random();
        const auto high = static_cast<std::uint32_t>(bits >> 32);
        switch (bits % 8)
        {
        case 0:
            return m_Last = k_Special[high % k_Special.size()];
        case 1:
            return m_Last; // equal to the one before
        case 2:
            return m_Last = Finite(std::nextafter(m_Last, high % 2 == 0 ? -k_Huge : k_Huge));
        case 3:
        case 4:
            return m_Last = Finite(std::bit_cast<float>(high));
        default:
            return m_Last = Between(-100.0f, 100.0f);
        }
    }

    /// 0...1, both ends, their neighbours and tiny ones among them.
    float Share()
    {
        const std::uint64_t bits = m_Random();
        const auto high = static_cast<std::uint32_t>(bits >> 32);
        switch (bits % 8)
        {
        case 0:
            return k_Shares[high % k_Shares.size()];
        case 1:
            return std::bit_cast<float>(high % (std::bit_cast<std::uint32_t>(1.0f) + 1));
        default:
            return Between(0.0f, 1.0f);
        }
    }

    float Between(float low, float high)
    {
        const auto share = static_cast<float>(m_Random() >> 40) * 0x1p-24f;
        return low + (high - low) * share;
    }

    /// 0...count - 1
    int Below(int count)
    {
        return static_cast<int>((m_Random() >> 33) % static_cast<std::uint64_t>(count));
    }

private:
    static constexpr float k_Huge = std::numeric_limits<float>::max();
    static constexpr float k_Small = std::numeric_limits<float>::min();
    static constexpr float k_Least = std::numeric_limits<float>::denorm_min();
    static constexpr float k_Ulp = std::numeric_limits<float>::epsilon();
    static constexpr std::array<float, 20> k_Special{
        0.0f,  -0.0f,         k_Least, -k_Least,   k_Small,           -k_Small, 1.0f,
        -1.0f, 1.0f + k_Ulp,  k_Huge,  -k_Huge,    k_Small - k_Least, 0.1f,     16777216.0f,
        1e-6f, -1.0f + k_Ulp, 1e4f,    k_Huge / 2, -k_Huge / 2,       3.0f};
    static constexpr std::array<float, 10> k_Shares{
        0.0f, 1.0f, 1.0f - k_Ulp / 2, 1.0f - k_Ulp, k_Ulp, k_Least, k_Small, 0.25f, 0.5f, 1e-7f};

    static float Finite(float value) { return std::isfinite(value) ? value : k_Huge; }

    std::mt19937_64 m_Random; // its numbers are fixed by the standard
    float m_Last = 0.0f;
};

} // namespace limn::test
