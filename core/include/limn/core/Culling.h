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

/// A pair of a renderer and one of its materials that the camera may see.
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

/// The pairs that a camera may see, in the scene's order. Each item is built when it is read.
class RendererItems
{
public:
    /// An iterator that holds the item it points at.
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
    /// @param rows  rows of the table, which takes them back for reuse at the end
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

    /// Returns the table, or null if nothing was culled.
    const std::shared_ptr<const RendererTable>& table() const { return m_Table; }
    std::vector<std::uint32_t>& rows() { return m_Rows; }
    const std::vector<std::uint32_t>& rows() const { return m_Rows; }

private:
    std::shared_ptr<const RendererTable> m_Table;
    std::vector<std::uint32_t> m_Rows;
};

/// The result of culling. It is valid as long as the scene is neither changed nor destroyed.
/// Unity: UnityEngine.Rendering.CullingResults (2022.3).
struct CullingResults
{
    RendererItems items;
    /// The data of the scene's objects that shaders get, relative to the origin.
    std::shared_ptr<const InstanceData> objects;
    /// The objects, in sight or not, whose world matrix has an infinity or NaN once it is rounded
    /// to float: they are not drawn.
    std::vector<const GameObject*> beyondFloat;
    int rendererCount = 0;      ///< enabled renderers of active objects, visible or not
    int outsideFrustum = 0;     ///< of these, how many lie outside the frustum
    int outsideCullingMask = 0; ///< and how many the camera's cullingMask leaves out
};

/// Returns the renderers of active objects in the camera's culling mask whose world bounds touch
/// its frustum. Only one thread at a time may cull a scene. Unity: ScriptableRenderContext.Cull.
/// @param aspect  width / height of the picture
/// @param margin  the part by which the frustum is wider and higher than the picture: 0 = not at
///     all, 1 = half a picture on each side
/// @param origin  the point to which the results' places are relative; none = the camera's
///     renderOrigin()
CullingResults Cull(const Scene& scene, const Camera& camera, float aspect,
                    const glm::vec2& margin = glm::vec2(0.0f),
                    const std::optional<glm::dvec3>& origin = std::nullopt);

/// Returns the renderers of active objects in the camera's culling mask that may throw a shadow
/// into a box of light. The box is unbounded towards the light, so that it holds everything on the
/// light's side of it. Renderers that throw no shadow, or have no pass of LightMode ShadowCaster,
/// are left out.
/// @param seen                 what the camera sees of the scene
/// @param lightViewProjection  world to clip space of the light; depth is from 1 near to 0 far
/// @param twoSided             if true, returns those of ShadowCastingMode::TwoSided, else the
///     others
CullingResults CullShadowCasters(const CullingResults& seen, const Camera& camera,
                                 const glm::dmat4& lightViewProjection, bool twoSided);

/// The items that a DrawRenderers call draws, and the verdicts on all of them.
struct JudgedItems
{
    FilterCounts counts{};
    RendererItems drawn; ///< in the same order
};

/// Calls Judge for all items, once for each kind of them.
JudgedItems Judge(const RendererItems& items, const FilteringSettings& filtering,
                  const DrawingSettings& drawing);

} // namespace limn
