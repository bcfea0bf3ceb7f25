#include "scene/RendererTable.h"

#include "scene/PerDraw.h"
#include "support/ParallelFor.h"
#include "support/UniqueId.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limn
{

namespace
{

/// A renderer has a row for each material; one without any has one, which draws nothing.
std::uint32_t RowsOf(const GameObject& object)
{
    if (!object.renderer || !object.renderer->mesh)
    {
        return 0;
    }
    const auto& materials = object.renderer->sharedMaterials;
    const auto count = std::ranges::count_if(materials, [](const auto& m) { return m != nullptr; });
    return static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(count, 1));
}

/// Rounded to float.
bool isFinite(const glm::dvec3& place, const glm::mat3& axes)
{
    float sum = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
    {
        sum += 0.0f * static_cast<float>(place[axis]);
        for (int row = 0; row < 3; ++row)
        {
            sum += 0.0f * axes[axis][row];
        }
    }
    return sum == 0.0f;
}

bool isMirrored(const glm::mat3& axes)
{
    return glm::determinant(glm::dmat3(axes)) < 0.0;
}

/// Fetches what HashOf reads some objects on: they lie anywhere in memory, and waiting for them one
/// by one would take most of the time.
void Prefetch(const GameObjects& objects, std::size_t index)
{
    constexpr std::size_t k_Ahead = 16;
    constexpr std::size_t k_LineBytes = 64;
    if (index + k_Ahead < objects.size())
    {
        const auto* object = reinterpret_cast<const std::byte*>(objects[index + k_Ahead].get());
        for (std::size_t offset = 0; offset < sizeof(GameObject); offset += k_LineBytes)
        {
            __builtin_prefetch(object + offset);
        }
    }
}

/// The place of a new value: one that is free, or one more.
template <typename Value>
std::uint32_t Put(std::vector<Value>& values, std::vector<std::uint32_t>& free, const Value& value)
{
    if (free.empty())
    {
        values.push_back(value);
        return static_cast<std::uint32_t>(values.size() - 1);
    }
    const std::uint32_t place = free.back();
    free.pop_back();
    values[place] = value;
    return place;
}

} // namespace

RendererTable::ClassKey RendererTable::KeyOf(const DrawKey& rowClass)
{
    const std::uint32_t bits = (rowClass.isMirrored ? 1u : 0u) | (rowClass.isAgain ? 2u : 0u) |
                               (rowClass.isActive ? 4u : 0u) | (rowClass.isFirst ? 8u : 0u) |
                               static_cast<std::uint32_t>(rowClass.shadowCastingMode) << 4 |
                               std::uint32_t{rowClass.materialIndex} << 6;
    return {rowClass.material.get(),          rowClass.properties.get(), rowClass.layer,
            rowClass.renderingLayerMask.bits, rowClass.meshPart,         bits};
}

FilterItem RendererTable::DrawKey::item() const
{
    return {material->renderQueue(), layer, renderingLayerMask, material->shader().get(),
            material.get()};
}

RendererTable::RendererTable(std::shared_ptr<const GameObjects> objects)
    : m_Id(NextUniqueId()), m_Objects(std::move(objects)), m_FirstRow{0}
{
}

void RendererTable::Update(const glm::dvec3& origin)
{
    const std::size_t known = m_Hash.size();
    m_Hash.resize(m_Objects->size());
    m_FirstRow.resize(m_Objects->size() + 1, m_FirstRow.back());
    m_Origin = known == 0 ? origin : m_Origin;
    FindChanges(known);
    if (origin != m_Origin)
    {
        MoveTo(origin);
    }
    if (std::exchange(m_ClassesChanged, false))
    {
        m_Order.Update(*this);
    }
}

/// @param known  how many objects there were last time
void RendererTable::FindChanges(std::size_t known)
{
    m_Parts.resize(PartsOf(m_Objects->size()));
    const auto find = [&](std::size_t number, std::size_t begin, std::size_t end)
    {
        Part& part = m_Parts[number];
        part.matrices.Clear();
        part.changed.clear();
        part.anew.clear();
        part.beyondFloat.clear();
        for (std::size_t i = begin; i < end; ++i)
        {
            Prefetch(*m_Objects, i);
            FindChange(static_cast<std::uint32_t>(i), i < known, part);
        }
    };
    try
    {
        ForEachPart(m_Objects->size(), m_Parts.size(), find);
    }
    catch (...)
    {
        m_Hash.clear(); // what was found is lost: next time everything is new
        throw;
    }
    const bool isUnchanged =
        std::ranges::all_of(m_Parts, [](const Part& part) { return part.changed.empty(); });
    if (known == 0 ? m_Objects->empty() : isUnchanged)
    {
        return;
    }
    m_LastChanges = m_Version++;
    m_Changed.clear();
    if (known == 0)
    {
        m_LastChanges = m_Version; // nobody knows an earlier one
        m_BeyondFloat.clear();
        SetRowsFrom(0);
        return;
    }
    for (const Part& part : m_Parts)
    {
        m_Changed.insert(m_Changed.end(), part.changed.begin(), part.changed.end());
    }
    SetChanged();
}

void RendererTable::FindChange(std::uint32_t index, bool isKnown, Part& part)
{
    const ObjectHash hash = HashOf(object(index), part.matrices);
    const ObjectHash before = std::exchange(m_Hash[index], hash);
    if (isKnown && hash == before)
    {
        return;
    }
    part.changed.push_back(index);
    if (!isKnown || hash.rest != before.rest || !MoveRows(index, part))
    {
        part.anew.push_back(index);
    }
}

/// Most changes are of the place only.
/// @return false where the rows are to be made anew all the same
bool RendererTable::MoveRows(std::uint32_t index, Part& part)
{
    const std::uint32_t first = m_FirstRow[index];
    const std::uint32_t end = m_FirstRow[index + 1];
    if (first == end)
    {
        return true;
    }
    const Transform& transform = object(index).transform;
    const glm::dmat4 local = LocalMatrix(transform);
    const glm::dmat4 matrix =
        transform.parent != nullptr ? *part.matrices.FindParent(transform.parent) * local : local;
    const World world{glm::dvec3(matrix[3]), glm::mat3(matrix)};
    if (isMirrored(world.axes) != m_Classes[m_ClassOf[first]].isMirrored)
    {
        return false;
    }
    if (!isFinite(world.place, world.axes))
    {
        part.beyondFloat.push_back(index);
    }
    for (std::uint32_t row = first; row < end; ++row)
    {
        SetBox(row, world);
    }
    return true;
}

void RendererTable::SetChanged()
{
    // An object that has a renderer only, or has lost it, is in nobody's way.
    std::erase_if(m_BeyondFloat,
                  [&](std::uint32_t i) { return std::ranges::binary_search(m_Changed, i); });
    for (const Part& part : m_Parts)
    {
        m_BeyondFloat.insert(m_BeyondFloat.end(), part.beyondFloat.begin(), part.beyondFloat.end());
    }
    SetAnew();
    std::ranges::sort(m_BeyondFloat);
}

/// Makes the rows anew of all that need it.
void RendererTable::SetAnew()
{
    for (const Part& part : m_Parts)
    {
        for (const std::uint32_t index : part.anew)
        {
            if (RowsOf(object(index)) != m_FirstRow[index + 1] - m_FirstRow[index])
            {
                std::erase_if(m_BeyondFloat, [&](std::uint32_t i) { return i >= index; });
                SetRowsFrom(index);
                return;
            }
            SetRows(index);
        }
    }
}

void RendererTable::MoveTo(const glm::dvec3& origin)
{
    m_Origin = origin;
    ++m_Version;
    m_LastChanges = m_Version; // who asks for an earlier one gets everything
    m_Changed.clear();
    const auto move = [&](std::size_t, std::size_t begin, std::size_t end)
    {
        for (std::size_t i = begin; i < end; ++i)
        {
            const World world = WorldOf(i);
            for (std::uint32_t row = m_FirstRow[i]; row < m_FirstRow[i + 1]; ++row)
            {
                SetBox(row, world);
            }
        }
    };
    ForEachPart(m_Objects->size(), m_Parts.size(), move);
}

glm::dmat4 RendererTable::MatrixOf(const Transform& transform) const
{
    if (transform.parent == nullptr)
    {
        return LocalMatrix(transform);
    }
    for (const Part& part : m_Parts)
    {
        if (const glm::dmat4* parent = part.matrices.FindParent(transform.parent))
        {
            return *parent * LocalMatrix(transform);
        }
    }
    return transform.worldMatrix(); // it has got another parent since
}

RendererTable::World RendererTable::WorldOf(std::size_t index) const
{
    const glm::dmat4 matrix = MatrixOf(object(index).transform);
    return {glm::dvec3(matrix[3]), glm::mat3(matrix)};
}

/// All rows of this object and those behind it.
void RendererTable::SetRowsFrom(std::uint32_t first)
{
    const std::uint32_t begin = m_FirstRow[first];
    for (std::uint32_t row = begin; row < rowCount(); ++row)
    {
        Release(row);
    }
    for (std::size_t i = first; i < m_Objects->size(); ++i)
    {
        m_FirstRow[i + 1] = m_FirstRow[i] + RowsOf(object(i));
    }
    ResizeRows(begin);
    ResizeRows(m_FirstRow.back());
    for (std::size_t i = first; i < m_Objects->size(); ++i)
    {
        SetRows(static_cast<std::uint32_t>(i));
    }
}

void RendererTable::SetRows(std::uint32_t index)
{
    const GameObject& source = object(index);
    if (m_FirstRow[index] == m_FirstRow[index + 1])
    {
        return;
    }
    const World world = WorldOf(index);
    if (!isFinite(world.place, world.axes))
    {
        m_BeyondFloat.push_back(index);
    }
    std::uint32_t row = m_FirstRow[index];
    for (std::size_t slot = 0; slot < source.renderer->sharedMaterials.size(); ++slot)
    {
        if (source.renderer->sharedMaterials[slot])
        {
            SetRow(row, index, slot, row == m_FirstRow[index], world);
            ++row;
        }
    }
    if (row == m_FirstRow[index])
    {
        SetRow(row, index, 0, true, world);
    }
}

void RendererTable::SetRow(std::uint32_t row, std::uint32_t index, std::size_t slot, bool isFirst,
                           const World& world)
{
    const GameObject& source = object(index);
    const MeshRenderer& renderer = *source.renderer;
    m_ObjectOf[row] = index;
    DrawKey rowClass;
    rowClass.material =
        slot < renderer.sharedMaterials.size() ? renderer.sharedMaterials[slot] : nullptr;
    rowClass.properties = renderer.PropertiesOf(slot);
    rowClass.layer = source.layer;
    rowClass.renderingLayerMask = renderer.renderingLayerMask;
    rowClass.materialIndex = static_cast<std::uint16_t>(slot);
    rowClass.shadowCastingMode = renderer.shadowCastingMode;
    rowClass.isActive = source.activeSelf && renderer.enabled;
    rowClass.isFirst = isFirst;
    rowClass.isMirrored = isMirrored(world.axes);
    rowClass.isAgain = static_cast<int>(slot) >= renderer.mesh->subMeshCount();
    const int subMesh = std::min(static_cast<int>(slot), renderer.mesh->subMeshCount() - 1);
    const MeshPart part{renderer.mesh, subMesh, 0};
    if (!HasClass(row, rowClass, part))
    {
        Release(row);
        SetClass(row, rowClass, part);
    }
    SetBox(row, world);
}

bool RendererTable::HasClass(std::uint32_t row, DrawKey rowClass, const MeshPart& part) const
{
    if (m_ClassOf[row] == k_Free)
    {
        return false;
    }
    const DrawKey& own = m_Classes[m_ClassOf[row]];
    rowClass.meshPart = own.meshPart;
    return KeyOf(own) == KeyOf(rowClass) && m_MeshParts[own.meshPart].mesh == part.mesh &&
           m_MeshParts[own.meshPart].subMesh == part.subMesh;
}

/// @param part  the class's
void RendererTable::SetClass(std::uint32_t row, const DrawKey& rowClass, const MeshPart& part)
{
    const auto [knownPart, isNewPart] = m_PartIndex.try_emplace({part.mesh.get(), part.subMesh}, 0);
    if (isNewPart)
    {
        knownPart->second = Put(m_MeshParts, m_FreeParts, part);
    }
    DrawKey own = rowClass;
    own.meshPart = knownPart->second;
    const auto [known, isNew] = m_ClassIndex.try_emplace(KeyOf(own), 0);
    if (isNew)
    {
        known->second = Put(m_Classes, m_FreeClasses, own);
        ++m_MeshParts[own.meshPart].uses;
        m_ClassesChanged = true;
    }
    ++m_Classes[known->second].uses;
    m_ClassOf[row] = known->second;
}

void RendererTable::SetBox(std::uint32_t row, const World& world)
{
    const Bounds& bounds = m_MeshParts[m_Classes[m_ClassOf[row]].meshPart].mesh->bounds();
    const glm::mat3& axes = world.axes;
    const glm::dvec3 center = glm::dmat3(axes) * glm::dvec3(bounds.center) + world.place;
    for (std::size_t axis = 0; axis < k_Axes; ++axis)
    {
        const int a = static_cast<int>(axis);
        m_Center[axis][row] = static_cast<float>(center[a] - m_Origin[a]);
        m_Extent[axis][row] = std::abs(axes[0][a]) * bounds.extents.x +
                              std::abs(axes[1][a]) * bounds.extents.y +
                              std::abs(axes[2][a]) * bounds.extents.z;
    }
}

void RendererTable::ResizeRows(std::size_t count)
{
    for (std::size_t axis = 0; axis < k_Axes; ++axis)
    {
        m_Center[axis].resize(count);
        m_Extent[axis].resize(count);
    }
    m_ClassOf.resize(count, k_Free);
    m_ObjectOf.resize(count);
}

/// A class that no row has lets go of its material and mesh.
void RendererTable::Release(std::uint32_t row)
{
    if (m_ClassOf[row] == k_Free)
    {
        return;
    }
    DrawKey& old = m_Classes[m_ClassOf[row]];
    if (--old.uses == 0)
    {
        MeshPart& part = m_MeshParts[old.meshPart];
        if (--part.uses == 0)
        {
            m_PartIndex.erase({part.mesh.get(), part.subMesh});
            m_FreeParts.push_back(old.meshPart);
            part = {};
        }
        m_ClassesChanged = true;
        m_ClassIndex.erase(KeyOf(old));
        m_FreeClasses.push_back(m_ClassOf[row]);
        old = {};
    }
    m_ClassOf[row] = k_Free;
}

PerDrawData RendererTable::Get(std::uint32_t index) const
{
    const World world = WorldOf(index);
    glm::dmat4 localToWorld{glm::dmat3(world.axes)};
    localToWorld[3] = glm::dvec4(world.place, 1.0);
    const std::uint32_t row = m_FirstRow[index]; // all rows of an object have its mask
    const auto layers = row < m_FirstRow[index + 1] ? m_Classes[m_ClassOf[row]].renderingLayerMask
                                                    : RenderingLayerMask::Nothing();
    return MakePerDrawData(localToWorld, layers, m_Origin);
}

std::optional<std::span<const std::uint32_t>>
RendererTable::ChangedSince(std::uint64_t version) const
{
    if (version == m_Version)
    {
        return std::span<const std::uint32_t>();
    }
    return version == m_LastChanges && m_LastChanges != m_Version
               ? std::optional(std::span(m_Changed))
               : std::nullopt;
}

std::vector<std::uint32_t> SpareRows::Take(std::size_t size)
{
    std::vector<std::uint32_t> rows;
    {
        const std::scoped_lock lock(m_Mutex);
        if (!m_Lists.empty())
        {
            // The smallest that has room, or else the largest.
            const auto order = [size](const auto& list)
            {
                const std::size_t room = list.capacity();
                return room >= size ? room - size : std::numeric_limits<std::size_t>::max() - room;
            };
            rows.swap(*std::ranges::min_element(m_Lists, {}, order));
            std::erase_if(m_Lists, [](const auto& list) { return list.capacity() == 0; });
        }
    }
    rows.resize(size);
    return rows;
}

void SpareRows::Give(std::vector<std::uint32_t> rows) noexcept
{
    const std::scoped_lock lock(m_Mutex);
    if (rows.capacity() > 0 && m_Lists.size() < k_Most)
    {
        m_Lists.reserve(k_Most);
        m_Lists.push_back(std::move(rows));
    }
}

} // namespace limn
