#include "draw/ObjectDraws.h"
#include "draw/SortEntries.h"
#include "scene/ParallelFor.h"
#include "scene/RendererTable.h"

#include <algorithm>
#include <limn/core/Culling.h>

namespace limn
{

namespace
{

/// @param entries  gets `count` of them
void MakeEntries(const RendererTable& table, const SortingSettings& sorting, const int* queues,
                 std::span<const std::uint32_t> rows, SortEntry* entries)
{
    const glm::vec3 camera(sorting.cameraPosition - table.origin());
    const std::uint32_t* states = table.order().states.data();
    const std::uint32_t* classOf = table.classOf().data();
    const RendererTable::RowClass* classes = table.classes().data();
    const float* x = table.centers(0).data();
    const float* y = table.centers(1).data();
    const float* z = table.centers(2).data();
    for (const std::uint32_t row : rows)
    {
        const std::uint32_t rowClass = classOf[row];
        const glm::vec3 offset = glm::vec3(x[row], y[row], z[row]) - camera;
        *entries++ = {SortKey(sorting.criteria, queues[rowClass], SortDistance(offset, sorting),
                              classes[rowClass].materialIndex),
                      states[rowClass], row};
    }
}

} // namespace

void Sort(RendererItems& items, const SortingSettings& sorting)
{
    SortIntoRuns(items, sorting);
}

std::span<const ClassRun> SortIntoRuns(RendererItems& items, const SortingSettings& sorting)
{
    // Kept from call to call: new memory would cost as much as the work on it.
    static thread_local std::vector<ClassRun> runs;
    static thread_local std::vector<int> queues; // by class
    static thread_local std::vector<SortEntry> entries;
    static thread_local std::vector<SortEntry> spare;
    runs.clear();
    if (items.empty())
    {
        return runs;
    }
    const RendererTable& table = *items.table();
    const ClassOrder& order = table.order();
    queues.clear();
    for (const RendererTable::RowClass& rowClass : table.classes())
    {
        queues.push_back(rowClass.material ? rowClass.material->renderQueue() : 0);
    }
    std::vector<std::uint32_t>& rows = items.rows();
    entries.resize(rows.size());
    ForEachPart(rows.size(), PartsOf(rows.size()),
                [&, out = entries.data(), queue = queues.data()](std::size_t, std::size_t begin,
                                                                 std::size_t end) {
                    MakeEntries(table, sorting, queue, std::span(rows).subspan(begin, end - begin),
                                out + begin);
                });
    const bool byState = sorting.criteria & SortingCriteria::OptimizeStateChanges;
    RadixSort(entries, spare, byState ? order.stateBits : 0);
    const bool hasFirst = order.stateBits < 32;
    std::uint32_t last = ~std::uint32_t{0};
    for (std::uint32_t i = 0; i < entries.size(); ++i)
    {
        rows[i] = entries[i].index;
        const std::uint32_t first =
            hasFirst ? entries[i].state >> order.stateBits : order.firsts[table.classOf()[rows[i]]];
        if (first != last)
        {
            last = first;
            runs.push_back({first, i, 0});
        }
        ++runs.back().count;
    }
    return runs;
}

void Sort(const std::vector<RendererItem>& items, const SortingSettings& sorting,
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
        const glm::vec3 offset(items[i].boundsCenter - sorting.cameraPosition);
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

} // namespace limn
