#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// Returns the number that distinguishes a group in the mask: its digits to the base 5 are 0 and 1.
/// The mean of four such numbers is one of them only if all four are equal, because no digit of
/// their sum carries; so the comparison with the mean of the neighbours overlooks no change. Sums
/// of four are whole numbers below 2^24, which a float holds exactly. There are 1023 numbers; then
/// they repeat.
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

/// Returns a bright linear colour. The colours of consecutive groups differ strongly, because they
/// step around the circle of hues by the golden ratio.
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
