#pragma once

#include "renderers/SortEntries.h"
#include "scene/BatchOrder.h"

#include <algorithm>
#include <limn/core/Culling.h>
#include <limn/core/Scene.h>
#include <vector>

namespace limn::test
{

/// Sorts some items of a list into the order in which a DrawRenderers call draws, one by one.
/// @param indices  into `items`: the items to sort, in the scene's order
inline void SortItems(const std::vector<RendererItem>& items, const SortingSettings& sorting,
                      std::vector<int>& indices)
{
    std::vector<StateId> states;
    for (const RendererItem& item : items)
    {
        states.push_back(StateOf(item.material.get(), item.object->renderer->mesh.get()));
    }
    const bool byState = sorting.criteria & SortingCriteria::OptimizeStateChanges;
    const std::vector<std::uint32_t> ranks = Ranks(states);
    std::vector<SortEntry> entries;
    for (const int index : indices)
    {
        const auto i = static_cast<std::size_t>(index);
        const glm::dvec3 offset = items[i].boundsCenter - sorting.cameraPosition;
        entries.push_back(
            {SortKey(sorting.criteria, items[i].filter.renderQueue, SortDistance(offset, sorting),
                     static_cast<std::uint16_t>(items[i].materialIndex)),
             byState ? ranks[i] : 0, static_cast<std::uint32_t>(index)});
    }
    std::vector<SortEntry> spare;
    RadixSort(entries, spare);
    std::ranges::transform(entries, indices.begin(),
                           [](const SortEntry& entry) { return static_cast<int>(entry.index); });
}

} // namespace limn::test
