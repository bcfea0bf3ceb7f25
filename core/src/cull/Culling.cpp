#include "scene/PerDraw.h"
#include "scene/RendererTable.h"
#include "support/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/core/Culling.h>
#include <stdexcept>

namespace limn
{

namespace
{

// The relation of a class of rows to the camera.
constexpr std::uint8_t k_InCullingMask = 1;
constexpr std::uint8_t k_Draws = 2;  ///< something, and it is in the mask
constexpr std::uint8_t k_Counts = 4; ///< an active renderer has one row of these

/// The six planes of a clip matrix, pointing inwards (not normalised), those at the sides moved
/// out.
std::array<glm::vec4, 6> FrustumPlanes(const glm::mat4& viewProjection, const glm::vec2& margin)
{
    const auto row = [&](int i)
    {
        return glm::vec4(viewProjection[0][i], viewProjection[1][i], viewProjection[2][i],
                         viewProjection[3][i]);
    };
    const glm::vec4 x = row(3) * (1.0f + margin.x);
    const glm::vec4 y = row(3) * (1.0f + margin.y);
    return {x + row(0), x - row(0), y + row(1), y - row(1), row(2), row(3) - row(2)};
}

/// The result of culling a run of rows.
struct PartOfCulling
{
    std::size_t visible = 0; ///< how many
    int renderers = 0;
    int outsideFrustum = 0;
    int outsideCullingMask = 0;
};

constexpr std::size_t k_BlockRows = 512; ///< few enough for the caches

/// Computes the depth of each box inside the plane that it is least inside of. A depth below 0
/// means that the box is wholly outside. Not-a-number counts as inside, so that nothing disappears
/// silently.
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

std::uint8_t KindOf(const RendererTable::DrawKey& rowClass, const Camera& camera)
{
    const bool inMask = LayerMask::FromIndex(rowClass.layer).Intersects(camera.cullingMask);
    const bool draws = inMask && rowClass.isActive && rowClass.material != nullptr &&
                       rowClass.shadowCastingMode != ShadowCastingMode::ShadowsOnly;
    const bool counts = rowClass.isActive && rowClass.isFirst;
    return static_cast<std::uint8_t>((inMask ? k_InCullingMask : 0) | (draws ? k_Draws : 0) |
                                     (counts ? k_Counts : 0));
}

std::uint8_t KindOfCaster(const RendererTable::DrawKey& rowClass, const Camera& camera,
                          bool twoSided)
{
    static const ShaderTagId k_ShadowCaster{"ShadowCaster"};
    const ShadowCastingMode mode = rowClass.shadowCastingMode;
    const bool draws = rowClass.isActive && rowClass.material != nullptr &&
                       mode != ShadowCastingMode::Off &&
                       (mode == ShadowCastingMode::TwoSided) == twoSided &&
                       LayerMask::FromIndex(rowClass.layer).Intersects(camera.cullingMask) &&
                       rowClass.material->FindEnabledPassByLightMode(k_ShadowCaster) >= 0;
    return draws ? k_Draws : 0;
}

/// @param kinds    by class
/// @param rows     gets those in sight
void CullRows(const RendererTable& table, const std::array<glm::vec4, 6>& planes,
              const std::uint8_t* kinds, std::size_t begin, std::size_t end, std::uint32_t* rows,
              PartOfCulling& result)
{
    std::array<float, k_BlockRows> depths;
    const std::uint32_t* classOf = table.classOf().data();
    std::size_t visible = 0;
    for (std::size_t block = begin; block < end; block += k_BlockRows)
    {
        const std::size_t count = std::min(k_BlockRows, end - block);
        Depths(table, planes, block, count, depths.data());
        for (std::size_t i = 0; i < count; ++i)
        {
            const std::size_t row = block + i;
            const std::uint8_t kind = kinds[classOf[row]];
            const bool counts = (kind & k_Counts) != 0;
            const bool inMask = (kind & k_InCullingMask) != 0;
            const bool inside = !(depths[i] < 0.0f);
            result.renderers += counts;
            result.outsideCullingMask += counts & !inMask;
            result.outsideFrustum += counts & inMask & !inside;
            rows[visible] = static_cast<std::uint32_t>(row);
            visible += inside & ((kind & k_Draws) != 0);
        }
    }
    result.visible = visible;
}

/// @param kindOf  gives a class's kind
template <typename Function>
CullingResults CullTable(const std::shared_ptr<const RendererTable>& table,
                         const std::array<glm::vec4, 6>& planes, const Function& kindOf)
{
    static thread_local std::vector<std::uint8_t> kinds; // by class
    kinds.clear();
    for (const RendererTable::DrawKey& rowClass : table->classes())
    {
        kinds.push_back(kindOf(rowClass));
    }
    static thread_local std::vector<PartOfCulling> parts;
    parts.assign(PartsOf(table->rowCount()), PartOfCulling());
    std::vector<std::uint32_t> visible = table->spareRows().Take(table->rowCount());
    ForEachPart(
        table->rowCount(), parts.size(),
        [&, kindsOf = kinds.data(), results = parts.data()](std::size_t part, std::size_t begin,
                                                            std::size_t end)
        { CullRows(*table, planes, kindsOf, begin, end, visible.data() + begin, results[part]); });

    CullingResults results;
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        // Each part has written where it begins.
        const PartOfCulling& part = parts[i];
        const auto begin =
            visible.begin() + static_cast<std::ptrdiff_t>(table->rowCount() * i / parts.size());
        std::copy_n(begin, part.visible, visible.begin() + static_cast<std::ptrdiff_t>(count));
        count += part.visible;
        results.rendererCount += part.renderers;
        results.outsideFrustum += part.outsideFrustum;
        results.outsideCullingMask += part.outsideCullingMask;
    }
    visible.resize(count);
    results.items = RendererItems(table, std::move(visible));
    results.objects = table;
    return results;
}

} // namespace

RendererItems& RendererItems::operator=(RendererItems other) noexcept
{
    m_Table.swap(other.m_Table);
    m_Rows.swap(other.m_Rows);
    return *this;
}

RendererItems::~RendererItems()
{
    if (m_Table)
    {
        m_Table->spareRows().Give(std::move(m_Rows));
    }
}

RendererItem RendererItems::operator[](std::size_t index) const
{
    const RendererTable& table = *m_Table;
    const std::uint32_t row = m_Rows[index];
    const RendererTable::DrawKey& kind = table.classes()[table.classOf()[row]];
    RendererItem item;
    item.objectIndex = table.objectOf()[row];
    item.object = &table.object(item.objectIndex);
    item.material = kind.material;
    item.materialIndex = kind.materialIndex;
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

CullingResults Cull(const Scene& scene, const Camera& camera, float aspect, const glm::vec2& margin,
                    const std::optional<glm::dvec3>& relativeTo)
{
    const glm::dvec3 origin = relativeTo ? *relativeTo : camera.renderOrigin();
    const auto planes = FrustumPlanes(glm::mat4(glm::dmat4(camera.gpuProjectionMatrix(aspect)) *
                                                RelativeTo(origin, camera.viewMatrix())),
                                      margin);
    const std::shared_ptr<const RendererTable> table = scene.UpdateRenderers(origin);
    CullingResults results =
        CullTable(table, planes,
                  [&](const RendererTable::DrawKey& rowClass) { return KindOf(rowClass, camera); });
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

CullingResults CullShadowCasters(const CullingResults& seen, const Camera& camera,
                                 const glm::dmat4& lightViewProjection, bool twoSided)
{
    const std::shared_ptr<const RendererTable>& table = seen.items.table();
    const auto kindOf = [&](const RendererTable::DrawKey& rowClass)
    {
        return KindOfCaster(rowClass, camera, twoSided);
    };
    if (!table || std::ranges::none_of(table->classes(), kindOf))
    {
        return {};
    }
    auto planes =
        FrustumPlanes(glm::mat4(RelativeTo(table->origin(), lightViewProjection)), glm::vec2(0.0f));
    planes[5] = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f); // no near plane
    return CullTable(table, planes, kindOf);
}

} // namespace limn
