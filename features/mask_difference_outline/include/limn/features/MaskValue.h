#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// What tells a group's mask from another's: a number whose digits to the base 5 are 0 and 1. The
/// mean of four such numbers is one of them only if all four are that one, since no digit of their
/// sum carries; so the comparison with the mean of the neighbours overlooks no change. Sums of four
/// are whole numbers below 2^24, exact in a float. There are 1023; then they begin again.
constexpr float IdOfGroup(int group)
{
    int id = 0;
    int digit = 1;
    for (int bits = group % 1023 + 1; bits != 0; bits >>= 1)
    {
        id += (bits & 1) * digit;
        digit *= 5;
    }
    return static_cast<float>(id);
}

/// A bright linear colour; of consecutive groups far apart, by steps of the golden ratio around the
/// circle of hues.
inline glm::vec3 ColorOfGroup(int group)
{
    const double turn = 0.6180339887498949 * group;
    const double hue = 6.0 * (turn - std::floor(turn));
    const glm::dvec3 offsets(3.0, 2.0, 4.0);
    const glm::dvec3 signs(1.0, -1.0, -1.0);
    const glm::dvec3 starts(-1.0, 2.0, 2.0);
    return glm::vec3(
        glm::clamp(starts + signs * glm::abs(hue - offsets), glm::dvec3(0.0), glm::dvec3(1.0)));
}

} // namespace limn
