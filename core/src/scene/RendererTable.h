#pragma once

#include "scene/BatchOrder.h"
#include "scene/WorldMatrices.h"

#include <limn/core/FrameCommands.h>
#include <limn/core/Judge.h>
#include <limn/core/Scene.h>
#include <map>
#include <mutex>
#include <tuple>

namespace limn
{

/// Tells whether an object's rows in a RendererTable are still what they were made from. It does
/// not look at the contents of materials and meshes.
struct ObjectHash
{
    std::uint64_t place = 0; ///< of the world matrix
    std::uint64_t rest = 0;

    bool operator==(const ObjectHash&) const = default;
};

/// @param matrices  receives those of its parents
ObjectHash HashOf(const GameObject& object, WorldMatrices& matrices);

/// Lists of rows that are not in use, since making them anew in each frame would cost as much as
/// filling them. Any thread may use it.
class SpareRows
{
public:
    /// Returns a list of this length with arbitrary values.
    std::vector<std::uint32_t> Take(std::size_t size);
    void Give(std::vector<std::uint32_t> rows) noexcept;

private:
    // A shadow map has up to 64 squares and 4 cascades, each with two lists at once.
    static constexpr std::size_t k_Most = 144;

    std::mutex m_Mutex;
    std::vector<std::vector<std::uint32_t>> m_Lists;
};

/// The renderers of a scene as arrays, one row for each pair of renderer and material in the
/// scene's order, so that a frame goes through contiguous memory. It is kept from frame to frame;
/// only objects that have changed are updated. The place of an object is stored only in the object
/// itself.
class RendererTable final : public InstanceData
{
public:
    static constexpr std::size_t k_Axes = 3;

    struct MeshPart
    {
        std::shared_ptr<const Mesh> mesh;
        int subMesh = 0;
        std::uint32_t uses = 0; ///< classes that have it; 0 = free
    };
    /// The properties besides the place that filtering and drawing look at; many rows share few
    /// combinations.
    struct DrawKey
    {
        std::shared_ptr<const Material> material;                ///< null = it draws nothing
        std::shared_ptr<const MaterialPropertyBlock> properties; ///< of the renderer; null = none
        int layer = 0;
        RenderingLayerMask renderingLayerMask;
        std::uint32_t meshPart = 0;
        std::uint16_t materialIndex = 0; ///< among the renderer's materials
        bool isActive = false;           ///< the object is, and its renderer enabled
        bool isFirst = false;            ///< it is the first row of its renderer
        bool isMirrored = false;         ///< the transform reverses triangles
        ShadowCastingMode shadowCastingMode = ShadowCastingMode::On;
        bool isAgain = false;   ///< another row of its renderer draws the sub-mesh too
        std::uint32_t uses = 0; ///< rows that have it; 0 = free

        /// Returns the item for filtering.
        /// @pre there is a material
        FilterItem item() const;
    };

    /// @param objects  kept as long as this is; may grow
    explicit RendererTable(std::shared_ptr<const GameObjects> objects);

    /// Updates the rows that have changed.
    /// @param origin  the point to which the rows' boxes are relative, see Camera::renderOrigin
    void Update(const glm::dvec3& origin);

    std::size_t rowCount() const { return m_ClassOf.size(); }
    const glm::dvec3& origin() const { return m_Origin; }
    // These are the boxes in world space, by axis and row: the middle, relative to origin(), and
    // half the size.
    const std::vector<float>& centers(std::size_t axis) const { return m_Center[axis]; }
    const std::vector<float>& extents(std::size_t axis) const { return m_Extent[axis]; }
    glm::vec3 center(std::uint32_t row) const
    {
        return {m_Center[0][row], m_Center[1][row], m_Center[2][row]};
    }
    glm::vec3 extent(std::uint32_t row) const
    {
        return {m_Extent[0][row], m_Extent[1][row], m_Extent[2][row]};
    }
    // These are by row.
    const std::vector<std::uint32_t>& classOf() const { return m_ClassOf; }
    const std::vector<std::uint32_t>& objectOf() const { return m_ObjectOf; }

    SpareRows& spareRows() const { return m_SpareRows; }

    const std::vector<DrawKey>& classes() const { return m_Classes; }
    const BatchOrder& order() const { return m_Order; }
    const std::vector<MeshPart>& meshParts() const { return m_MeshParts; }
    const GameObject& object(std::size_t index) const { return *(*m_Objects)[index]; }
    /// Returns the objects with a renderer whose world matrix is beyond a float.
    const std::vector<std::uint32_t>& beyondFloat() const { return m_BeyondFloat; }

    std::uint64_t id() const override { return m_Id; }
    std::uint64_t version() const override { return m_Version; }
    std::uint32_t count() const override { return static_cast<std::uint32_t>(m_Hash.size()); }
    PerDrawData Get(std::uint32_t index) const override;
    std::optional<std::span<const std::uint32_t>>
    ChangedSince(std::uint64_t version) const override;

private:
    /// The world matrix of an object, not yet relative to the origin.
    struct World
    {
        glm::dvec3 place;
        glm::mat3 axes;
    };

    /// The results of a thread for its part of the objects.
    struct Part
    {
        WorldMatrices matrices;                 ///< of the parents of some
        std::vector<std::uint32_t> changed;     ///< in order
        std::vector<std::uint32_t> anew;        ///< of them, those whose rows must be made anew
        std::vector<std::uint32_t> beyondFloat; ///< of the others
    };

    void FindChanges(std::size_t known);
    void FindChange(std::uint32_t index, bool isKnown, Part& part);
    bool MoveRows(std::uint32_t index, Part& part);
    void SetChanged();
    void SetAnew();
    void MoveTo(const glm::dvec3& origin);
    glm::dmat4 MatrixOf(const Transform& transform) const;
    World WorldOf(std::size_t object) const;
    void SetRowsFrom(std::uint32_t first);
    void SetRows(std::uint32_t index);
    void SetRow(std::uint32_t row, std::uint32_t index, std::size_t slot, bool isFirst,
                const World& world);
    void SetBox(std::uint32_t row, const World& world);
    void ResizeRows(std::size_t count);
    bool HasClass(std::uint32_t row, DrawKey rowClass, const MeshPart& part) const;
    void SetClass(std::uint32_t row, const DrawKey& rowClass, const MeshPart& part);
    void Release(std::uint32_t row);

    static constexpr std::uint32_t k_Free = ~std::uint32_t{0}; ///< a row without class

    std::uint64_t m_Id;
    std::uint64_t m_Version = 0;
    std::uint64_t m_LastChanges = 0; ///< the version before m_Changed
    std::vector<std::uint32_t> m_Changed;
    std::vector<Part> m_Parts; ///< by thread: m_Changed is put together from them
    glm::dvec3 m_Origin{0.0};

    // These are by object.
    std::shared_ptr<const GameObjects> m_Objects;
    std::vector<ObjectHash> m_Hash;        ///< hash of everything that its rows are made from
    std::vector<std::uint32_t> m_FirstRow; ///< has one more element, the end
    std::vector<std::uint32_t> m_BeyondFloat;

    // These are by row.
    std::vector<float> m_Center[k_Axes];
    std::vector<float> m_Extent[k_Axes];
    std::vector<std::uint32_t> m_ClassOf;
    std::vector<std::uint32_t> m_ObjectOf;

    std::vector<DrawKey> m_Classes;
    std::vector<MeshPart> m_MeshParts;
    using PartKey = std::tuple<const Mesh*, int>;
    using ClassKey = std::tuple<const Material*, const MaterialPropertyBlock*, int, std::uint32_t,
                                std::uint32_t, std::uint32_t>;
    static ClassKey KeyOf(const DrawKey& rowClass);
    std::map<ClassKey, std::uint32_t> m_ClassIndex;
    std::map<PartKey, std::uint32_t> m_PartIndex;
    std::vector<std::uint32_t> m_FreeClasses;
    std::vector<std::uint32_t> m_FreeParts;
    BatchOrder m_Order; ///< of the classes, unless they have changed
    bool m_ClassesChanged = false;
    mutable SpareRows m_SpareRows;
};

} // namespace limn
