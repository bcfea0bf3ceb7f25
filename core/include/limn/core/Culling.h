#pragma once

#include <iterator>
#include <limn/core/FrameCommands.h>
#include <limn/core/Judge.h>
#include <limn/core/Scene.h>
#include <vector>

namespace limn
{

struct Camera;

class RendererTable;

/// One (renderer, material) pair that the camera may see.
struct RendererItem
{
    const GameObject* object = nullptr; ///< never null; its renderer is set
    std::shared_ptr<const Material> material;
    int materialIndex = 0; ///< among the renderer's materials
    int subMesh = 0;
    FilterItem filter;
    std::uint32_t objectIndex = 0; ///< in CullingResults::objects
    glm::dvec3 boundsCenter{0.0};  ///< world
};

/// The pairs that a camera may see, in the scene's order; each is put together when it is asked
/// for.
class RendererItems
{
public:
    /// Holds the item it points at.
    class Iterator
    {
    public:
        using iterator_category = std::input_iterator_tag;
        using value_type = RendererItem;
        using difference_type = std::ptrdiff_t;
        using pointer = const RendererItem*;
        using reference = const RendererItem&;

        Iterator(const RendererItems& items, std::size_t index) : m_Items(&items), m_Index(index) {}
        reference operator*() const { return m_Item = (*m_Items)[m_Index]; }
        pointer operator->() const { return &**this; }
        Iterator& operator++()
        {
            ++m_Index;
            return *this;
        }
        bool operator==(const Iterator& other) const { return m_Index == other.m_Index; }

    private:
        const RendererItems* m_Items;
        std::size_t m_Index;
        mutable RendererItem m_Item;
    };

    RendererItems() = default;
    /// @param rows  of the table; they go back to its spare ones in the end
    RendererItems(std::shared_ptr<const RendererTable> table, std::vector<std::uint32_t> rows)
        : m_Table(std::move(table)), m_Rows(std::move(rows))
    {
    }
    RendererItems(const RendererItems&) = default;
    RendererItems(RendererItems&&) = default;
    RendererItems& operator=(RendererItems other) noexcept;
    ~RendererItems();

    std::size_t size() const { return m_Rows.size(); }
    bool empty() const { return m_Rows.empty(); }
    RendererItem operator[](std::size_t index) const;
    /// @throws std::out_of_range
    RendererItem at(std::size_t index) const;
    RendererItem back() const { return at(size() - 1); }
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size()}; }

    /// Null = nothing was culled.
    const std::shared_ptr<const RendererTable>& table() const { return m_Table; }
    std::vector<std::uint32_t>& rows() { return m_Rows; }
    const std::vector<std::uint32_t>& rows() const { return m_Rows; }

private:
    std::shared_ptr<const RendererTable> m_Table;
    std::vector<std::uint32_t> m_Rows;
};

/// What culling found. Valid as long as the scene is neither changed nor destroyed.
/// Unity: UnityEngine.Rendering.CullingResults (2022.3).
struct CullingResults
{
    RendererItems items;
    /// What shaders get to know of the scene's objects, relative to the origin.
    std::shared_ptr<const InstanceData> objects;
    /// Objects, in sight or not, whose world matrix has an infinity or NaN once it is rounded to
    /// float: nothing of them is seen.
    std::vector<const GameObject*> beyondFloat;
    int rendererCount = 0;      ///< enabled renderers of active objects, visible or not
    int outsideFrustum = 0;     ///< of these, how many lie outside the frustum
    int outsideCullingMask = 0; ///< and how many the camera's cullingMask leaves out
};

/// The renderers of active objects in the camera's culling mask whose world bounds touch its
/// frustum. One thread at a time may cull a scene. Unity: ScriptableRenderContext.Cull.
/// @param aspect  width / height of the picture
/// @param margin  by how much the frustum is wider and higher than the picture: 0 = not at all, 1 =
///                half a picture on each side
/// @param origin  what the results' places are relative to; none = the camera's renderOrigin()
CullingResults Cull(const Scene& scene, const Camera& camera, float aspect,
                    const glm::vec2& margin = glm::vec2(0.0f),
                    const std::optional<glm::dvec3>& origin = std::nullopt);

/// The renderers of active objects in the camera's culling mask that may throw a shadow into a box
/// of light: it begins nowhere, so that it holds whatever is on the light's side of it. Those that
/// throw none, or have no pass of LightMode ShadowCaster, are not among them.
/// @param seen                 what the camera sees of the scene
/// @param lightViewProjection  world to clip space of the light; depth is from 1 near to 0 far
/// @param twoSided             those of ShadowCastingMode::TwoSided, else the others
CullingResults CullShadowCasters(const CullingResults& seen, const Camera& camera,
                                 const glm::dmat4& lightViewProjection, bool twoSided);

/// What a DrawRenderers call makes of items.
struct JudgedItems
{
    FilterCounts counts{};
    RendererItems drawn; ///< in the same order
};

/// Judge for all items, asked once for each kind of them.
JudgedItems Judge(const RendererItems& items, const FilteringSettings& filtering,
                  const DrawingSettings& drawing);

/// Puts items into the order in which a DrawRenderers call draws; stable.
void Sort(RendererItems& items, const SortingSettings& sorting);
/// The same for some of a list.
/// @param indices  into `items`; which take part, in the scene's order
void Sort(const std::vector<RendererItem>& items, const SortingSettings& sorting,
          std::vector<int>& indices);

} // namespace limn
