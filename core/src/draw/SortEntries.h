#pragma once

#include <cmath>
#include <cstdint>
#include <limn/core/SortingSettings.h>
#include <vector>

namespace limn
{

/// One of many things to be sorted.
struct SortEntry
{
    std::uint64_t key = 0;   ///< queue and distance
    std::uint32_t state = 0; ///< decides between equal keys
    std::uint32_t index = 0; ///< what is sorted
};

/// By key, then by state; stable. Digits in which all are equal take no time.
/// @param spare  room of the same size
void RadixSort(std::vector<SortEntry>& entries, std::vector<SortEntry>& spare);

/// Distance to the camera with everything that is no number at the far end: comparisons of NaN
/// would leave the order undefined.
float SortDistance(const glm::vec3& offset, const SortingSettings& sorting);

/// The part of the order that RenderQueue and the distances decide.
/// @param queue          0...5000
/// @param materialIndex  among the renderer's materials
std::uint64_t SortKey(SortingCriteria criteria, int queue, float distance, int materialIndex);

} // namespace limn
