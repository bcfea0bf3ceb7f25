#include "draw/ObjectDraws.h"
#include "draw/PerDraw.h"
#include "draw/SortEntries.h"
#include "scene/ParallelFor.h"
#include "scene/RendererTable.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/core/Culling.h>
#include <stdexcept>
#include <tuple>

namespace limn
{

namespace
{

// What the camera has to do with a class of rows.
constexpr std::uint8_t k_InCullingMask = 1;
constexpr std::uint8_t k_Draws = 2;

/// The six planes of a clip matrix, pointing inwards (not normalised).
std::array<glm::vec4, 6> FrustumPlanes(const glm::mat4& viewProjection)
{
    const auto row = [&](int i)
    {
        return glm::vec4(viewProjection[0][i], viewProjection[1][i], viewProjection[2][i],
                         viewProjection[3][i]);
    };
    return {row(3) + row(0), row(3) - row(0), row(3) + row(1),
            row(3) - row(1), row(2),          row(3) - row(2)};
}

/// What a run of rows comes to.
struct PartOfCulling
{
    std::vector<std::uint32_t> visible;
    int renderers = 0;
    int outsideFrustum = 0;
    int outsideCullingMask = 0;
};

constexpr std::size_t k_BlockRows = 512; ///< few enough for the caches

/// How far inside the plane that they are least inside of the boxes reach; below 0 they are wholly
/// outside. Not-a-number counts as inside, so that nothing disappears silently.
void Depths(const RendererTable& table, const std::array<glm::vec4, 6>& planes, std::size_t begin,
            std::size_t count, float* depths)
{
    const float* x = table.centers(0).data() + begin;
    const float* y = table.centers(1).data() + begin;
    const float* z = table.centers(2).data() + begin;
    const float* dx = table.extents(0).data() + begin;
    const float* dy = table.extents(1).data() + begin;
    const float* dz = table.extents(2).data() + begin;
    std::fill_n(depths, count, std::numeric_limits<float>::max());
    for (const glm::vec4& plane : planes)
    {
        const glm::vec3 reach = glm::abs(glm::vec3(plane));
        for (std::size_t i = 0; i < count; ++i)
        {
            const float depth = plane.x * x[i] + plane.y * y[i] + plane.z * z[i] + plane.w +
                                (reach.x * dx[i] + reach.y * dy[i] + reach.z * dz[i]);
            depths[i] = depth < depths[i] ? depth : depths[i];
        }
    }
}

/// @param classes  by class: whether the camera's cullingMask has its layer, and draws anything
void CullRows(const RendererTable& table, const std::array<glm::vec4, 6>& planes,
              const std::vector<std::uint8_t>& classes, std::size_t begin, std::size_t end,
              PartOfCulling& result)
{
    std::array<float, k_BlockRows> depths;
    result.visible.resize(end - begin);
    std::size_t visible = 0;
    for (std::size_t block = begin; block < end; block += k_BlockRows)
    {
        const std::size_t count = std::min(k_BlockRows, end - block);
        Depths(table, planes, block, count, depths.data());
        for (std::size_t i = 0; i < count; ++i)
        {
            const std::size_t row = block + i;
            const std::uint8_t flags = table.flags()[row];
            const std::uint8_t kind = classes[table.classOf()[row]];
            const bool isActive = (flags & RendererTable::k_Active) != 0;
            const bool counts = isActive && (flags & RendererTable::k_First) != 0;
            const bool inMask = (kind & k_InCullingMask) != 0;
            const bool inside = !(depths[i] < 0.0f);
            result.renderers += counts;
            result.outsideCullingMask += counts & !inMask;
            result.outsideFrustum += counts & inMask & !inside;
            result.visible[visible] = static_cast<std::uint32_t>(row);
            visible += isActive & inside & (kind == (k_InCullingMask | k_Draws));
        }
    }
    result.visible.resize(visible);
}

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
        m_RankBits = std::bit_width(most);
        m_HasClasses = m_RankBits + std::bit_width(ranks.size()) <= 32;
        for (std::uint32_t i = 0; m_HasClasses && m_RankBits < 32 && i < ranks.size(); ++i)
        {
            ranks[i] |= i << m_RankBits;
        }
    }

    /// Of an entry's state; the rest of it says the class, if there is room.
    int rankBits() const { return m_HasClasses ? m_RankBits : 32; }
    std::uint32_t ClassOf(const SortEntry& entry, const RendererTable& table) const
    {
        return m_HasClasses ? entry.state >> m_RankBits : table.classOf()[entry.index];
    }

    const SortingSettings sorting;
    const glm::vec3 camera; ///< relative to the table's origin
    // By class.
    std::vector<int> queues;
    std::vector<std::uint32_t> ranks; ///< the entry's state

private:
    int m_RankBits = 0;
    bool m_HasClasses = false;
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

RendererItem RendererItems::operator[](std::size_t index) const
{
    const RendererTable& table = *m_Table;
    const std::uint32_t row = m_Rows[index];
    const RendererTable::RowClass& kind = table.classes()[table.classOf()[row]];
    RendererItem item;
    item.objectIndex = table.objectOf()[row];
    item.object = &table.object(item.objectIndex);
    item.material = kind.material;
    item.materialIndex = table.materialIndices()[row];
    item.subMesh = table.meshParts()[kind.meshPart].subMesh;
    item.filter = kind.item();
    item.boundsCenter = table.origin() + glm::dvec3(table.center(row));
    return item;
}

RendererItem RendererItems::at(std::size_t index) const
{
    if (index >= size())
    {
        throw std::out_of_range("RendererItems: there is no item " + std::to_string(index));
    }
    return (*this)[index];
}

CullingResults Cull(const Scene& scene, const Camera& camera, float aspect)
{
    const glm::dvec3 origin = camera.renderOrigin();
    const auto planes = FrustumPlanes(glm::mat4(glm::dmat4(camera.gpuProjectionMatrix(aspect)) *
                                                RelativeTo(origin, camera.viewMatrix())));
    const std::shared_ptr<const RendererTable> table = scene.UpdateRenderers(origin);
    std::vector<std::uint8_t> classes;
    for (const RendererTable::RowClass& kind : table->classes())
    {
        const bool inMask = LayerMask::FromIndex(kind.layer).Intersects(camera.cullingMask);
        classes.push_back(static_cast<std::uint8_t>((inMask ? k_InCullingMask : 0) |
                                                    (kind.material ? k_Draws : 0)));
    }
    std::vector<PartOfCulling> parts(PartsOf(table->rowCount()));
    ForEachPart(table->rowCount(), parts.size(),
                [&](std::size_t part, std::size_t begin, std::size_t end)
                { CullRows(*table, planes, classes, begin, end, parts[part]); });

    CullingResults results;
    std::vector<std::uint32_t> visible = std::move(parts.front().visible);
    for (const PartOfCulling& part : parts)
    {
        visible.insert(visible.end(), part.visible.begin(), part.visible.end());
        results.rendererCount += part.renderers;
        results.outsideFrustum += part.outsideFrustum;
        results.outsideCullingMask += part.outsideCullingMask;
    }
    results.items = RendererItems(table, std::move(visible));
    results.objects = table;
    for (const std::uint32_t index : table->beyondFloat())
    {
        const GameObject& object = table->object(index);
        if (object.activeSelf && object.renderer->enabled &&
            LayerMask::FromIndex(object.layer).Intersects(camera.cullingMask))
        {
            results.beyondFloat.push_back(&object);
        }
    }
    return results;
}

JudgedItems Judge(const RendererItems& items, const FilteringSettings& filtering,
                  const DrawingSettings& drawing)
{
    JudgedItems judged;
    if (items.empty())
    {
        return judged;
    }
    const RendererTable& table = *items.table();
    std::vector<std::uint8_t> verdicts;
    for (const RendererTable::RowClass& kind : table.classes())
    {
        verdicts.push_back(static_cast<std::uint8_t>(
            kind.material ? Judge(kind.item(), filtering, drawing) : FilterVerdict::Drawn));
    }
    std::vector<std::uint32_t> drawn(items.size());
    std::array<std::uint32_t, k_FilterVerdictCount> counts{};
    std::size_t count = 0;
    for (const std::uint32_t row : items.rows())
    {
        const std::uint8_t verdict = verdicts[table.classOf()[row]];
        ++counts[verdict];
        drawn[count] = row;
        count += verdict == static_cast<std::uint8_t>(FilterVerdict::Drawn);
    }
    drawn.resize(count);
    std::ranges::copy(counts, judged.counts.begin());
    judged.drawn = RendererItems(items.table(), std::move(drawn));
    return judged;
}

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
        const std::uint32_t rowClass = order.ClassOf(entries[i], table);
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
