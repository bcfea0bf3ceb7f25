#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>
#include <vector>

/// Formulas in double precision that several oracles are built of.
namespace limn::test
{

inline constexpr double k_Pi = std::numbers::pi;

inline double Saturate(double x)
{
    return std::clamp(x, 0.0, 1.0);
}

/// IEC 61966-2-1, one channel.
inline double SrgbToLinear(double c)
{
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
inline double LinearToSrgb(double c)
{
    return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

/// Column by column, as a uniform takes it.
inline std::vector<float> Floats(const glm::mat4& m)
{
    const float* first = glm::value_ptr(m);
    return {first, first + 16};
}

} // namespace limn::test
