#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <limn/core/DrawingSettings.h>
#include <vector>

namespace limn
{

/// An element to be sorted.
struct SortEntry
{
    std::uint64_t key = 0;   ///< queue and distance
    std::uint32_t state = 0; ///< decides between equal keys
    std::uint32_t index = 0; ///< of the element
};

/// Sorts by key, then by the lowest bits of the state; the sort is stable. Digits in which all are
/// equal take no time.
/// @param spare      has room for as many
/// @param stateBits  the number of bits of the state that count
void RadixSort(std::vector<SortEntry>& entries, std::vector<SortEntry>& spare, int stateBits = 32);
/// Sorts words by their bits from `firstBit` on, in the same way.
void RadixSort(std::vector<std::uint64_t>& words, std::vector<std::uint64_t>& spare, int firstBit);

/// Returns the square of the distance to the camera, with the sign of the distance. Everything that
/// is not a number goes to the far end, since comparisons of NaN would leave the order undefined.
/// It is computed in double and rounded to a float once: the larger of two distances never comes
/// out smaller, unless the squares differ by less than a double holds of their terms. Distances
/// whose squares are the same float are equal, among them all below 1e-23 m and all above 1.8e19 m.
inline float SortDistance(const glm::dvec3& offset, const SortingSettings& sorting)
{
    const bool isCustom = sorting.distanceMetric == DistanceMetric::CustomAxis;
    const double along =
        glm::dot(offset, glm::dvec3(isCustom ? sorting.customAxis : sorting.cameraForward));
    const double square = sorting.distanceMetric == DistanceMetric::Perspective
                              ? glm::dot(offset, offset)
                              : along * std::abs(along);
    constexpr double k_Largest = std::numeric_limits<float>::max();
    const double near = square <= k_Largest ? square : k_Largest; // of NaN, too
    return static_cast<float>(near >= -k_Largest ? near : -k_Largest);
}

/// Returns an integer whose order is that of floats.
inline std::uint32_t OrderedBits(float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f); // -0 is 0
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

/// Returns a number that is equal for distances within the same eighth of an octave and grows with
/// them; 0 up to a millimetre.
/// @param square  of the distance: a quarter of an octave for each eighth
inline std::uint32_t Quantised(float square)
{
    // These are the fractions of 2^(1/4), 2^(2/4) and 2^(3/4) as a float has them.
    constexpr std::uint32_t k_First = 0x1837F1;
    constexpr std::uint32_t k_Second = 0x3504F4;
    constexpr std::uint32_t k_Third = 0x5744FD;
    const auto bits = std::bit_cast<std::uint32_t>(square);
    const std::uint32_t fraction = bits & 0x7FFFFFu;
    const std::uint32_t quarter = (fraction >= k_First ? 1u : 0u) +
                                  (fraction >= k_Second ? 1u : 0u) +
                                  (fraction >= k_Third ? 1u : 0u);
    return square > 1e-6f ? 1 + (bits >> 23) * 4 + quarter : 0;
}

/// Returns the part of the order that distances decide, which grows in the order of the draws.
/// @param distance  as SortDistance returns it
inline std::uint32_t DistanceKey(SortingCriteria criteria, float distance)
{
    if (criteria & SortingCriteria::BackToFront)
    {
        // Equal distances are equal eighths too, so QuantizedFrontToBack has nothing to add.
        return ~OrderedBits(distance);
    }
    return criteria & SortingCriteria::QuantizedFrontToBack ? Quantised(distance) : 0;
}

/// Returns the number of bits of DistanceKey that may differ.
inline int DistanceKeyBits(SortingCriteria criteria)
{
    constexpr int k_QuantisedBits = 11; // exponents of a finite float, and the quarters
    return criteria & SortingCriteria::BackToFront            ? 32
           : criteria & SortingCriteria::QuantizedFrontToBack ? k_QuantisedBits
                                                              : 0;
}

/// Returns the part of the order that RenderQueue and the distances decide.
/// @param queue          0...5000
/// @param distance       as SortDistance returns it
/// @param materialIndex  among the renderer's materials
inline std::uint64_t SortKey(SortingCriteria criteria, int queue, float distance,
                             std::uint16_t materialIndex)
{
    return (criteria & SortingCriteria::RenderQueue ? static_cast<std::uint64_t>(queue) << 48 : 0) |
           std::uint64_t{DistanceKey(criteria, distance)} << 16 |
           (criteria & SortingCriteria::BackToFront ? materialIndex : 0u);
}

} // namespace limn
