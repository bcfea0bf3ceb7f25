#include "draw/SortEntries.h"

#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <limits>

namespace limn
{

namespace
{

constexpr int k_DigitBits = 11;
constexpr std::size_t k_DigitCount = std::size_t{1} << k_DigitBits;

/// Passes over the digits of `value` that are not the same in all entries, the lowest first.
template <typename Value>
void SortBy(std::vector<SortEntry>& entries, std::vector<SortEntry>& spare, Value value)
{
    std::uint64_t differing = 0;
    for (const SortEntry& entry : entries)
    {
        differing |= value(entry) ^ value(entries.front());
    }
    while (differing != 0)
    {
        const int shift = std::countr_zero(differing);
        const auto digit = [&](const SortEntry& entry)
        { return (value(entry) >> shift) & (k_DigitCount - 1); };
        std::array<std::uint32_t, k_DigitCount> place{};
        for (const SortEntry& entry : entries)
        {
            ++place[digit(entry)];
        }
        std::uint32_t next = 0;
        for (std::uint32_t& count : place)
        {
            next += std::exchange(count, next);
        }
        for (const SortEntry& entry : entries)
        {
            spare[place[digit(entry)]++] = entry;
        }
        entries.swap(spare);
        differing = shift + k_DigitBits < 64 ? differing >> (shift + k_DigitBits)
                                                   << (shift + k_DigitBits)
                                             : 0;
    }
}

/// Order-preserving: of floats as integers.
std::uint32_t OrderedBits(float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f); // -0 is 0
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

/// The same for distances within the same eighth of an octave: 1 + floor(8 log2), moved to begin at
/// 1, and 0 up to a millimetre.
std::uint32_t Quantised(float distance)
{
    if (!(distance > 1e-3f))
    {
        return 0;
    }
    // Of 2^(k/8), the bits behind the point.
    static const std::array<std::uint32_t, 8> starts = []
    {
        std::array<std::uint32_t, 8> bits{};
        for (std::size_t k = 0; k < bits.size(); ++k)
        {
            const double start = std::exp2(static_cast<double>(k) / 8.0);
            bits[k] = static_cast<std::uint32_t>(std::ceil((start - 1.0) * 0x1p23));
        }
        return bits;
    }();
    const auto bits = std::bit_cast<std::uint32_t>(distance);
    const std::uint32_t fraction = bits & 0x7FFFFFu;
    std::uint32_t eighth = 0;
    for (std::size_t k = 1; k < starts.size(); ++k)
    {
        eighth += fraction >= starts[k];
    }
    return 1 + (bits >> 23) * 8 + eighth;
}

} // namespace

void RadixSort(std::vector<SortEntry>& entries, std::vector<SortEntry>& spare)
{
    if (entries.empty())
    {
        return;
    }
    spare.resize(entries.size());
    SortBy(entries, spare, [](const SortEntry& entry) { return std::uint64_t{entry.state}; });
    SortBy(entries, spare, [](const SortEntry& entry) { return entry.key; });
}

float SortDistance(const glm::vec3& offset, const SortingSettings& sorting)
{
    const float distance = sorting.distanceMetric == DistanceMetric::Perspective
                               ? glm::length(offset)
                               : glm::dot(offset, sorting.cameraForward);
    return std::isfinite(distance) ? distance : std::numeric_limits<float>::max();
}

std::uint64_t SortKey(SortingCriteria criteria, int queue, float distance, int materialIndex)
{
    std::uint64_t key =
        criteria & SortingCriteria::RenderQueue ? static_cast<std::uint64_t>(queue) << 48 : 0;
    if (criteria & SortingCriteria::BackToFront)
    {
        // Equal distances are equal eighths too, so QuantizedFrontToBack has nothing to add.
        key |= std::uint64_t{~OrderedBits(distance)} << 16 |
               static_cast<std::uint64_t>(materialIndex);
    }
    else if (criteria & SortingCriteria::QuantizedFrontToBack)
    {
        key |= std::uint64_t{Quantised(distance)} << 16;
    }
    return key;
}

} // namespace limn
