#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

// The Academy's colour spaces by their primaries, and its tone scale, in double precision.

namespace limn::test
{

inline glm::dvec3 Xyz(glm::dvec2 xy)
{
    return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y};
}

/// RGB to XYZ from chromaticities (SMPTE RP 177).
inline glm::dmat3 ToXyz(glm::dvec2 r, glm::dvec2 g, glm::dvec2 b, glm::dvec2 white)
{
    const glm::dmat3 primaries(Xyz(r), Xyz(g), Xyz(b));
    const glm::dvec3 scale = glm::inverse(primaries) * Xyz(white);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

inline const glm::dvec2 k_D60(0.32168, 0.33767);
inline const glm::dvec2 k_D65(0.3127, 0.3290);

inline glm::dmat3 Ap0ToXyz()
{
    return ToXyz({0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, k_D60);
}
inline glm::dmat3 Ap1ToXyz()
{
    return ToXyz({0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, k_D60);
}
inline glm::dmat3 Rec709ToXyz()
{
    return ToXyz({0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, k_D65);
}

/// Bradford's adaptation.
inline glm::dmat3 Adaptation(glm::dvec2 from, glm::dvec2 to)
{
    const glm::dmat3 cones = glm::transpose(
        glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
    const glm::dvec3 ratio = cones * Xyz(to) / (cones * Xyz(from));
    glm::dmat3 scale(0.0);
    for (int i = 0; i < 3; ++i)
    {
        scale[i][i] = ratio[i];
    }
    return glm::inverse(cones) * scale * cones;
}

inline double Luma(const glm::dvec3& ap1)
{
    return (Ap1ToXyz() * ap1).y;
}

inline double Saturation(const glm::dvec3& c)
{
    const double high = std::max({c.x, c.y, c.z});
    const double low = std::min({c.x, c.y, c.z});
    return (std::max(high, 1e-4) - std::max(low, 1e-4)) / std::max(high, 1e-2);
}

/// Of the reference rendering transform: what is dark and colourful glows.
inline double Glow(const glm::dvec3& c)
{
    const double x = (Saturation(c) - 0.4) / 0.2;
    const double t = std::max(1.0 - std::abs(x) / 2.0, 0.0);
    const double shape = (1.0 + (x > 0 ? 1 : x < 0 ? -1 : 0) * (1.0 - t * t)) / 2.0;
    const double chroma =
        std::sqrt(c.z * (c.z - c.y) + c.y * (c.y - c.x) + c.x * (c.x - c.z) + 1e-300);
    const double yc = (c.x + c.y + c.z + 1.75 * chroma) / 3.0;
    const double gain = 0.05 * shape;
    return yc <= 0.08 * 2 / 3 ? gain : yc >= 0.16 ? 0.0 : gain * (0.08 / yc - 0.5);
}

inline glm::dvec3 RedModified(glm::dvec3 c, double saturation)
{
    const double hue =
        std::atan2(std::sqrt(3.0) * (c.y - c.z), 2 * c.x - c.y - c.z) * 180.0 / std::acos(-1.0);
    const double t = std::max(1.0 - std::abs(hue) * 2.0 / 135.0, 0.0);
    const double weight = (3 - 2 * t) * t * t;
    c.x += weight * weight * saturation * (0.03 - c.x) * 0.18;
    return c;
}

/// `color` in ACES2065-1.
inline glm::dvec3 AcesReference(const glm::dvec3& color)
{
    const glm::dvec3 aces = RedModified(color * (1.0 + Glow(color)), Saturation(color));
    glm::dvec3 x = glm::inverse(Ap1ToXyz()) * Ap0ToXyz() * aces;
    x = glm::max(x, 0.0);
    x = glm::mix(glm::dvec3(Luma(x)), x, 0.96);
    x = x * (278.5085 * x + 10.7772) / (x * (293.6045 * x + 88.7122) + 80.6889);
    // The chromaticity stays, the luminance goes to the power.
    const double luminance = Luma(x);
    x *= luminance > 0 ? std::pow(luminance, 0.9811) / luminance : 0.0;
    x = glm::mix(glm::dvec3(Luma(x)), x, 0.93);
    return glm::inverse(Rec709ToXyz()) * Adaptation(k_D60, k_D65) * Ap1ToXyz() * x;
}

} // namespace limn::test
