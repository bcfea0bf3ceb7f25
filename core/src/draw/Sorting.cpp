#include "draw/ObjectDraws.h"
#include "draw/SortEntries.h"
#include "scene/ParallelFor.h"
#include "scene/RendererTable.h"

#include <algorithm>
#include <bit>
#include <limn/core/Culling.h>
#include <map>
#include <tuple>

namespace limn
{

namespace
{

/// Numbers 0, 1 ... in the order of `values`, equal ones for equal values.
template <typename Value>
std::vector<std::uint32_t> Ranks(const std::vector<Value>& values)
{
    std::vector<Value> sorted = values;
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<std::uint32_t> ranks;
    for (const Value& value : values)
    {
        ranks.push_back(
            static_cast<std::uint32_t>(std::ranges::lower_bound(sorted, value) - sorted.begin()));
    }
    return ranks;
}

/// What OptimizeStateChanges brings together: first the shader, then the material, then the mesh.
using StateId = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>;

StateId StateOf(const Material* material, const Mesh* mesh)
{
    return {material ? material->shader()->id() : 0, material ? material->id() : 0,
            mesh ? mesh->id() : 0};
}

/// What the order needs of each class of rows, worked out once a call.
class ClassOrder
{
public:
    ClassOrder(const RendererTable& table, const SortingSettings& settings)
        : sorting(settings), camera(settings.cameraPosition - table.origin())
    {
        const bool byState = sorting.criteria & SortingCriteria::OptimizeStateChanges;
        std::vector<StateId> states;
        for (const RendererTable::RowClass& rowClass : table.classes())
        {
            const Material* material = rowClass.material.get();
            const Mesh* mesh = table.meshParts()[rowClass.meshPart].mesh.get();
            states.push_back(byState ? StateOf(material, mesh) : StateId());
            queues.push_back(material ? material->renderQueue() : 0);
        }
        ranks = Ranks(states);
        const std::uint32_t most = ranks.empty() ? 0 : *std::ranges::max_element(ranks);
        m_RankBits = static_cast<int>(std::bit_width(most));
        const auto classBits = static_cast<int>(std::bit_width(ranks.size()));
        m_HasRoom = m_RankBits + classBits <= 32 && m_RankBits < 32;
        FindFirsts(table);
    }

    /// Of an entry's state; the rest of it says what it draws, if there is room.
    int rankBits() const { return m_HasRoom ? m_RankBits : 32; }
    /// The first class that draws the same as the entry's.
    std::uint32_t FirstClassOf(const SortEntry& entry, const RendererTable& table) const
    {
        return m_HasRoom ? entry.state >> m_RankBits : m_Firsts[table.classOf()[entry.index]];
    }

    const SortingSettings sorting;
    const glm::vec3 camera; ///< relative to the table's origin
    // By class.
    std::vector<int> queues;
    std::vector<std::uint32_t> ranks; ///< the entry's state

private:
    /// Layers and masks have been looked at before: classes that differ in them only draw the same.
    void FindFirsts(const RendererTable& table)
    {
        std::map<std::tuple<const Material*, std::uint32_t, bool, bool>, std::uint32_t> known;
        for (std::uint32_t i = 0; i < ranks.size(); ++i)
        {
            const RendererTable::RowClass& own = table.classes()[i];
            const auto first = known.try_emplace(
                {own.material.get(), own.meshPart, own.isMirrored, own.isAgain}, i);
            m_Firsts.push_back(first.first->second);
            ranks[i] |= m_HasRoom ? m_Firsts[i] << m_RankBits : 0;
        }
    }

    std::vector<std::uint32_t> m_Firsts; ///< by class
    int m_RankBits = 0;
    bool m_HasRoom = false;
};

/// @param entries  gets `count` of them
void MakeEntries(const RendererTable& table, const ClassOrder& order, const std::uint32_t* rows,
                 SortEntry* entries, std::size_t count)
{
    const SortingSettings sorting = order.sorting;
    const glm::vec3 camera = order.camera;
    const int* queues = order.queues.data();
    const std::uint32_t* ranks = order.ranks.data();
    const std::uint32_t* classOf = table.classOf().data();
    const std::uint16_t* materialIndices = table.materialIndices().data();
    const float* x = table.centers(0).data();
    const float* y = table.centers(1).data();
    const float* z = table.centers(2).data();
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::uint32_t row = rows[i];
        const std::uint32_t rowClass = classOf[row];
        const glm::vec3 offset = glm::vec3(x[row], y[row], z[row]) - camera;
        entries[i] = {SortKey(sorting.criteria, queues[rowClass], SortDistance(offset, sorting),
                              materialIndices[row]),
                      ranks[rowClass], row};
    }
}

} // namespace

void Sort(RendererItems& items, const SortingSettings& sorting)
{
    SortIntoRuns(items, sorting);
}

std::vector<ClassRun> SortIntoRuns(RendererItems& items, const SortingSettings& sorting)
{
    std::vector<ClassRun> runs;
    if (items.empty())
    {
        return runs;
    }
    const RendererTable& table = *items.table();
    const ClassOrder order(table, sorting);
    // Kept from call to call: new memory would cost as much as the work on it.
    static thread_local std::vector<SortEntry> entries;
    static thread_local std::vector<SortEntry> spare;
    std::vector<std::uint32_t>& rows = items.rows();
    entries.resize(rows.size());
    ForEachPart(rows.size(), PartsOf(rows.size()),
                [&, out = entries.data()](std::size_t, std::size_t begin, std::size_t end)
                { MakeEntries(table, order, rows.data() + begin, out + begin, end - begin); });
    RadixSort(entries, spare, order.rankBits());
    std::uint32_t last = ~std::uint32_t{0};
    for (std::uint32_t i = 0; i < entries.size(); ++i)
    {
        rows[i] = entries[i].index;
        const std::uint32_t rowClass = order.FirstClassOf(entries[i], table);
        if (rowClass != last)
        {
            last = rowClass;
            runs.push_back({rowClass, i, 0});
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
