#include "draw/PerDraw.h"
#include "draw/SortEntries.h"
#include "scene/ParallelFor.h"
#include "scene/RendererTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/core/Culling.h>

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
using MaterialId = std::pair<std::uint64_t, std::uint64_t>;
MaterialId IdOf(const Material* material)
{
    return material ? MaterialId{material->shader()->id(), material->id()} : MaterialId{};
}

} // namespace

RendererItem RendererItems::operator[](std::size_t index) const
{
    const RendererTable& table = *m_Table;
    const std::uint32_t row = m_Rows[index];
    const RendererTable::FilterClass& kind = table.classes()[table.classOf()[row]];
    RendererItem item;
    item.objectIndex = table.objectOf()[row];
    item.object = &table.object(item.objectIndex);
    item.material = kind.material;
    item.materialIndex = table.materialIndices()[row];
    item.subMesh = table.meshParts()[table.meshPartOf()[row]].subMesh;
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
    for (const RendererTable::FilterClass& kind : table->classes())
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
    for (const RendererTable::FilterClass& kind : table.classes())
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
    if (items.empty())
    {
        return;
    }
    const RendererTable& table = *items.table();
    std::vector<MaterialId> materials;
    std::vector<int> queues;
    for (const RendererTable::FilterClass& kind : table.classes())
    {
        materials.push_back(IdOf(kind.material.get()));
        queues.push_back(kind.material ? kind.material->renderQueue() : 0);
    }
    std::vector<std::uint64_t> meshes;
    for (const RendererTable::MeshPart& part : table.meshParts())
    {
        meshes.push_back(part.mesh ? part.mesh->id() : 0);
    }
    const bool byState = sorting.criteria & SortingCriteria::OptimizeStateChanges;
    const std::vector<std::uint32_t> materialRanks = Ranks(materials);
    const std::vector<std::uint32_t> meshRanks = Ranks(meshes);
    const auto meshCount = static_cast<std::uint32_t>(meshes.size());
    const glm::vec3 camera(sorting.cameraPosition - table.origin());
    std::vector<SortEntry> entries(items.size());
    std::vector<std::uint32_t>& rows = items.rows();
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const std::uint32_t row = rows[i];
        const std::uint32_t kind = table.classOf()[row];
        const float distance = SortDistance(table.center(row) - camera, sorting);
        entries[i] = {SortKey(sorting.criteria, queues[kind], distance,
                              table.materialIndices()[row]),
                      byState ? materialRanks[kind] * meshCount + meshRanks[table.meshPartOf()[row]]
                              : 0,
                      row};
    }
    std::vector<SortEntry> spare;
    RadixSort(entries, spare);
    std::ranges::transform(entries, rows.begin(), &SortEntry::index);
}

void Sort(const std::vector<RendererItem>& items, const SortingSettings& sorting,
          std::vector<int>& indices)
{
    std::vector<std::pair<MaterialId, std::uint64_t>> states;
    for (const RendererItem& item : items)
    {
        states.emplace_back(IdOf(item.material.get()), item.object->renderer->mesh->id());
    }
    const bool byState = sorting.criteria & SortingCriteria::OptimizeStateChanges;
    const std::vector<std::uint32_t> ranks = Ranks(states);
    std::vector<SortEntry> entries;
    for (const int index : indices)
    {
        const auto i = static_cast<std::size_t>(index);
        const glm::vec3 offset(items[i].boundsCenter - sorting.cameraPosition);
        entries.push_back({SortKey(sorting.criteria, items[i].filter.renderQueue,
                                   SortDistance(offset, sorting), items[i].materialIndex),
                           byState ? ranks[i] : 0, static_cast<std::uint32_t>(index)});
    }
    std::vector<SortEntry> spare;
    RadixSort(entries, spare);
    std::ranges::transform(entries, indices.begin(),
                           [](const SortEntry& entry) { return static_cast<int>(entry.index); });
}

} // namespace limn
