#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/Light.h>
#include <limn/core/Material.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <limn/core/Mesh.h>
#include <limn/core/RenderSettings.h>
#include <limn/core/Transform.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace limn
{

class Material;

/// The materials of a renderer. It is a vector that stores a single material, which most renderers
/// have, without memory of its own. Iterators and references are valid until the length changes.
class MaterialList
{
public:
    using value_type = std::shared_ptr<const Material>;
    using iterator = value_type*;
    using const_iterator = const value_type*;

    MaterialList() = default;
    MaterialList(std::initializer_list<value_type> list) : MaterialList(list.begin(), list.size())
    {
    }
    MaterialList(const std::vector<value_type>& list) : MaterialList(list.data(), list.size()) {}
    MaterialList(const MaterialList& other) : MaterialList(other.begin(), other.size()) {}
    MaterialList(MaterialList&& other) noexcept
        : m_Materials(std::exchange(other.m_Materials, Many()))
    {
    }
    MaterialList& operator=(MaterialList other) noexcept
    {
        m_Materials.swap(other.m_Materials);
        return *this;
    }
    ~MaterialList() = default;

    std::size_t size() const
    {
        const Many* many = std::get_if<Many>(&m_Materials);
        return many == nullptr ? 1 : *many ? (*many)->size() : 0;
    }
    bool empty() const { return size() == 0; }
    iterator begin() { return const_cast<iterator>(std::as_const(*this).begin()); }
    iterator end() { return begin() + size(); }
    const_iterator begin() const
    {
        const Many* many = std::get_if<Many>(&m_Materials);
        return many == nullptr ? std::get_if<value_type>(&m_Materials)
               : *many         ? (*many)->data()
                               : nullptr;
    }
    const_iterator end() const { return begin() + size(); }
    value_type& operator[](std::size_t index) { return begin()[index]; }
    const value_type& operator[](std::size_t index) const { return begin()[index]; }
    value_type& front() { return *begin(); }
    const value_type& front() const { return *begin(); }
    value_type& back() { return end()[-1]; }
    const value_type& back() const { return end()[-1]; }
    /// @throws std::out_of_range
    const value_type& at(std::size_t index) const;

    void push_back(value_type material) { resize(size() + 1, material); }
    /// @param material  the value of those that are added
    void resize(std::size_t count, const value_type& material = nullptr);
    void clear() { *this = MaterialList(); }

    bool operator==(const MaterialList& other) const;

private:
    using Many = std::unique_ptr<std::vector<value_type>>; ///< null in an empty list

    MaterialList(const value_type* materials, std::size_t count);

    std::variant<Many, value_type> m_Materials;
};

/// The property blocks that SetPropertyBlock has set, for a renderer and for single materials.
/// Copies have lists of their own of the same blocks. A renderer without any, as most are, has one
/// pointer here.
class RendererPropertyBlocks
{
public:
    using Block = std::shared_ptr<const MaterialPropertyBlock>;

    RendererPropertyBlocks() = default;
    RendererPropertyBlocks(const RendererPropertyBlocks& other);
    RendererPropertyBlocks(RendererPropertyBlocks&& other) noexcept = default;
    RendererPropertyBlocks& operator=(RendererPropertyBlocks other) noexcept;
    ~RendererPropertyBlocks() = default;

    /// @param block  copied; an empty one removes the block that was set
    void Set(const MaterialPropertyBlock& block);
    void Set(const MaterialPropertyBlock& block, std::size_t material);

    bool isEmpty() const { return m_Lists == nullptr; }
    // These return null if none was set. The reference is valid until the next change.
    const Block& ofRenderer() const { return m_Lists ? m_Lists->ofRenderer : k_None; }
    const Block& OfMaterial(std::size_t material) const
    {
        return material < materialCount() ? m_Lists->ofMaterials[material] : k_None;
    }
    /// Returns the number of materials that may have a block; those behind them have none.
    std::size_t materialCount() const { return m_Lists ? m_Lists->ofMaterials.size() : 0; }

private:
    struct Lists
    {
        Block ofRenderer;
        std::vector<Block> ofMaterials; ///< by index
    };
    /// Returns the lists to change them; DropEmpty frees them again.
    Lists& Own();
    void DropEmpty();

    static const Block k_None;
    std::unique_ptr<Lists> m_Lists; ///< null, or with at least one block
};

class RendererTable;

/// Selects whether an object throws a shadow: not at all, with the faces that a camera would see,
/// with all of its faces, or without being seen itself.
/// Unity: UnityEngine.Rendering.ShadowCastingMode.
enum class ShadowCastingMode : std::uint8_t
{
    Off = 0,
    On = 1,
    TwoSided = 2,
    ShadowsOnly = 3
};

/// Draws a mesh, sub-mesh i with material i. If there are more materials than sub-meshes, the last
/// sub-mesh is drawn once for each further one. Unity: UnityEngine.MeshRenderer with its MeshFilter
/// (2022.3).
struct MeshRenderer
{
    std::shared_ptr<const Mesh> mesh;
    MaterialList sharedMaterials;
    RenderingLayerMask renderingLayerMask{1}; ///< a new renderer is in rendering layer 0 only
    bool enabled = true;
    /// Selects how the renderer throws shadows, which it does with the ShadowCaster pass of its
    /// materials' shaders.
    ShadowCastingMode shadowCastingMode = ShadowCastingMode::On;
    RendererPropertyBlocks propertyBlocks = {}; ///< set by SetPropertyBlock

    /// Returns the first material, or null if there is none. Unity: Renderer.sharedMaterial.
    std::shared_ptr<const Material> sharedMaterial() const
    {
        return sharedMaterials.empty() ? nullptr : sharedMaterials.front();
    }
    /// Copies sharedMaterials into the list. Unity: Renderer.GetSharedMaterials (2022.3).
    void GetSharedMaterials(std::vector<std::shared_ptr<const Material>>& m) const
    {
        m.assign(sharedMaterials.begin(), sharedMaterials.end());
    }
    void SetSharedMaterials(const std::vector<std::shared_ptr<const Material>>& materials)
    {
        sharedMaterials = materials;
    }

    /// Sets values that win over those of its materials and of materials that override these.
    /// Renderers with different blocks are separate draws.
    /// @param block  copied; an empty one removes the renderer's block
    /// @source Unity: Renderer.SetPropertyBlock (2022.3)
    void SetPropertyBlock(const MaterialPropertyBlock& block) { propertyBlocks.Set(block); }
    /// Sets `block` to a copy of the renderer's block; an empty one if it has none.
    /// Unity: Renderer.GetPropertyBlock.
    void GetPropertyBlock(MaterialPropertyBlock& block) const
    {
        const auto& own = propertyBlocks.ofRenderer();
        block = own ? *own : MaterialPropertyBlock();
    }
    /// Sets a block for one of its materials, which then ignores the block of the whole renderer.
    /// @param block  an empty one removes the material's block
    /// @throws ContractError if there is no such material
    void SetPropertyBlock(const MaterialPropertyBlock& block, int materialIndex);
    /// Sets `block` to a copy of the block of this material; an empty one if it has none.
    void GetPropertyBlock(MaterialPropertyBlock& block, int materialIndex) const;
    /// Returns whether the renderer or any of its materials has a block.
    bool HasPropertyBlock() const { return !propertyBlocks.isEmpty(); }

    /// Returns the block that draws with this material use; null = none.
    const std::shared_ptr<const MaterialPropertyBlock>& PropertiesOf(std::size_t material) const
    {
        const auto& own = propertyBlocks.OfMaterial(material);
        return own ? own : propertyBlocks.ofRenderer();
    }
};

/// An object of a scene. It cannot be copied, since `auto object = scene.Add("x")` would change a
/// copy that is in no scene; write `GameObject&`. Unity: UnityEngine.GameObject (2022.3).
struct GameObject
{
    GameObject() = default;
    GameObject(const GameObject&) = delete;
    GameObject& operator=(const GameObject&) = delete;

    std::string name;
    int layer = 0; ///< 0...31
    bool activeSelf = true;
    Transform transform;
    std::optional<MeshRenderer> renderer;
};

using GameObjects = std::vector<std::unique_ptr<GameObject>>;

/// A light infinitely far away. Unity: UnityEngine.Light of type Directional (2022.3).
struct DirectionalLight
{
    glm::vec3 direction{0.0f, -1.0f, 0.0f}; ///< world, the way the light travels; unit length
    Color color;                            ///< sRGB
    float intensity = 1.0f;                 ///< multiplies the linear colour
    /// The rendering layers that it lights, if a shader has _LIGHT_LAYERS on.
    RenderingLayerMask renderingLayerMask{1};

    LightShadows shadows = LightShadows::None;
    float shadowStrength = 1.0f; ///< 0...1: the share of its light that shadows take
    SoftShadowQuality softShadowQuality = SoftShadowQuality::UsePipelineSettings;
    /// If true, the biases are the pipeline's, not the two that follow.
    /// Unity: UniversalAdditionalLightData.
    bool usePipelineSettings = true;
    float shadowBias = 0.05f;      ///< texels of the shadow map, along the light
    float shadowNormalBias = 0.4f; ///< texels, along the normal
};

/// A scene: objects to draw, and what lights them. `scene.fog` is Unity's RenderSettings.fog.
/// Objects keep their address, so that transforms can be parents. A scene that was moved from can
/// only be destroyed and assigned to.
class Scene : public RenderSettings
{
public:
    Scene() = default;
    Scene(Scene&&) noexcept = default;
    Scene& operator=(Scene&&) noexcept = default;
    ~Scene() = default;

    DirectionalLight mainLight{{0.0f, -1.0f, 0.0f}, Color::white, 1.0f};
    std::vector<Light> additionalLights; ///< besides the main one

    /// Adds an object at the end of the list; the reference is valid as long as the scene.
    GameObject& Add(std::string name);

    const GameObjects& objects() const { return *m_Objects; }

    /// Returns the first object of this name, or null.
    GameObject* Find(std::string_view name);

    /// Returns the renderers as arrays, up to date, for Cull. Only one thread at a time may call
    /// it.
    /// @param origin  the point to which places are relative
    std::shared_ptr<const RendererTable> UpdateRenderers(const glm::dvec3& origin) const;

private:
    /// The objects. Frames that were drawn before the scene's end may still look at them.
    std::shared_ptr<GameObjects> m_Objects = std::make_shared<GameObjects>();
    mutable std::shared_ptr<RendererTable> m_Renderers; ///< follows the objects
};

} // namespace limn
