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
#include <vector>

namespace limn
{

class Material;

/// The materials of a renderer: a vector, but the only one that most renderers have takes no memory
/// of its own. Iterators and references hold until the next change of the length.
class MaterialList
{
public:
    using value_type = std::shared_ptr<const Material>;
    using iterator = value_type*;
    using const_iterator = const value_type*;

    MaterialList() noexcept : m_One() {}
    MaterialList(std::initializer_list<value_type> materials);
    MaterialList(const std::vector<value_type>& materials);
    MaterialList(const MaterialList& other);
    MaterialList(MaterialList&& other) noexcept;
    MaterialList& operator=(MaterialList other) noexcept;
    ~MaterialList() { Free(); }

    std::size_t size() const { return m_Size; }
    bool empty() const { return m_Size == 0; }
    iterator begin() { return isShort() ? &m_One : m_Many; }
    iterator end() { return begin() + m_Size; }
    const_iterator begin() const { return isShort() ? &m_One : m_Many; }
    const_iterator end() const { return begin() + m_Size; }
    value_type& operator[](std::size_t index) { return begin()[index]; }
    const value_type& operator[](std::size_t index) const { return begin()[index]; }
    value_type& front() { return *begin(); }
    const value_type& front() const { return *begin(); }
    value_type& back() { return end()[-1]; }
    const value_type& back() const { return end()[-1]; }
    /// @throws std::out_of_range
    const value_type& at(std::size_t index) const;

    void push_back(value_type material) { resize(m_Size + std::size_t{1}, material); }
    /// @param material  of those that are added
    void resize(std::size_t count, const value_type& material = nullptr);
    void clear() { *this = MaterialList(); }

    bool operator==(const MaterialList& other) const;

private:
    bool isShort() const { return m_Size <= 1; }
    void Assign(const value_type* materials, std::size_t count);
    void Take(MaterialList& other) noexcept;
    void Free() noexcept;

    union
    {
        value_type m_One;   ///< null in an empty list
        value_type* m_Many; ///< of new[]
    };
    std::uint32_t m_Size = 0;
};

/// What a renderer was given by SetPropertyBlock, for itself and for single materials. Copies have
/// lists of their own of the same blocks. A renderer without any, as most are, has one pointer
/// here.
class RendererPropertyBlocks
{
public:
    using Block = std::shared_ptr<const MaterialPropertyBlock>;

    RendererPropertyBlocks() = default;
    RendererPropertyBlocks(const RendererPropertyBlocks& other);
    RendererPropertyBlocks(RendererPropertyBlocks&& other) noexcept = default;
    RendererPropertyBlocks& operator=(RendererPropertyBlocks other) noexcept;
    ~RendererPropertyBlocks() = default;

    /// @param block  copied; an empty one takes what there is away
    void Set(const MaterialPropertyBlock& block);
    void Set(const MaterialPropertyBlock& block, std::size_t material);

    bool isEmpty() const { return m_Lists == nullptr; }
    // Null = none was set. Until the next change.
    const Block& ofRenderer() const { return m_Lists ? m_Lists->ofRenderer : k_None; }
    const Block& OfMaterial(std::size_t material) const
    {
        return material < materialCount() ? m_Lists->ofMaterials[material] : k_None;
    }
    /// Materials behind these have none.
    std::size_t materialCount() const { return m_Lists ? m_Lists->ofMaterials.size() : 0; }

private:
    struct Lists
    {
        Block ofRenderer;
        std::vector<Block> ofMaterials; ///< by index
    };
    /// To be changed; freed again by DropEmpty.
    Lists& Own();
    void DropEmpty();

    static const Block k_None;
    std::unique_ptr<Lists> m_Lists; ///< null, or not without any block
};

class RendererTable;

/// Whether an object throws a shadow: not at all, the faces that a camera would see, all of its
/// faces, or a shadow while it is not seen itself. Unity: UnityEngine.Rendering.ShadowCastingMode.
enum class ShadowCastingMode : std::uint8_t
{
    Off = 0,
    On = 1,
    TwoSided = 2,
    ShadowsOnly = 3
};

/// Draws a mesh, sub-mesh i with material i. More materials than sub-meshes: the last sub-mesh is
/// drawn once for each further one. Unity: UnityEngine.MeshRenderer with its MeshFilter (2022.3).
struct MeshRenderer
{
    std::shared_ptr<const Mesh> mesh;
    MaterialList sharedMaterials;
    RenderingLayerMask renderingLayerMask{1}; ///< a new renderer is in rendering layer 0 only
    bool enabled = true;
    /// With the pass of LightMode ShadowCaster that its materials' shaders have.
    ShadowCastingMode shadowCastingMode = ShadowCastingMode::On;
    RendererPropertyBlocks propertyBlocks = {}; ///< that SetPropertyBlock was given

    /// The first material; null where there is none. Unity: Renderer.sharedMaterial.
    std::shared_ptr<const Material> sharedMaterial() const
    {
        return sharedMaterials.empty() ? nullptr : sharedMaterials.front();
    }
    /// The list becomes that of sharedMaterials. Unity: Renderer.GetSharedMaterials (2022.3).
    void GetSharedMaterials(std::vector<std::shared_ptr<const Material>>& m) const
    {
        m.assign(sharedMaterials.begin(), sharedMaterials.end());
    }
    void SetSharedMaterials(const std::vector<std::shared_ptr<const Material>>& materials)
    {
        sharedMaterials = materials;
    }

    /// Values that win over those of its materials, and of what overrides these. Renderers of
    /// different blocks are separate draws.
    /// @param block  copied; an empty one takes the renderer's away
    /// @source Unity: Renderer.SetPropertyBlock (2022.3)
    void SetPropertyBlock(const MaterialPropertyBlock& block) { propertyBlocks.Set(block); }
    /// A copy; an empty one where the renderer has none. Unity: Renderer.GetPropertyBlock.
    void GetPropertyBlock(MaterialPropertyBlock& block) const
    {
        const auto& own = propertyBlocks.ofRenderer();
        block = own ? *own : MaterialPropertyBlock();
    }
    /// For one of its materials, which does not look at the block of the whole renderer then.
    /// @param block  an empty one takes the material's away
    /// @throws ContractError if there is no such material
    void SetPropertyBlock(const MaterialPropertyBlock& block, int materialIndex);
    /// What was set for this material; an empty one where there is none.
    void GetPropertyBlock(MaterialPropertyBlock& block, int materialIndex) const;
    /// Of the renderer, or of any material.
    bool HasPropertyBlock() const { return !propertyBlocks.isEmpty(); }

    /// What draws with this material take; null = none.
    const std::shared_ptr<const MaterialPropertyBlock>& PropertiesOf(std::size_t material) const
    {
        const auto& own = propertyBlocks.OfMaterial(material);
        return own ? own : propertyBlocks.ofRenderer();
    }
};

/// An object of a scene. It cannot be copied: `auto object = scene.Add("x")` would change a copy
/// that is in no scene; write `GameObject&`. Unity: UnityEngine.GameObject (2022.3).
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
    /// What it lights, where a shader has _LIGHT_LAYERS on.
    RenderingLayerMask renderingLayerMask{1};

    LightShadows shadows = LightShadows::None;
    float shadowStrength = 1.0f; ///< 0...1: the share of its light that shadows take
    SoftShadowQuality softShadowQuality = SoftShadowQuality::UsePipelineSettings;
    /// The biases are the pipeline's, not those that follow. Unity: UniversalAdditionalLightData.
    bool usePipelineSettings = true;
    float shadowBias = 0.05f;      ///< texels of the shadow map, along the light
    float shadowNormalBias = 0.4f; ///< texels, along the normal
};

/// Objects to draw, and what lights them: `scene.fog` is Unity's RenderSettings.fog. Objects
/// keep their address, so that transforms can be parents. One that was moved from can be destroyed
/// and assigned to only.
class Scene : public RenderSettings
{
public:
    Scene() = default;
    Scene(Scene&&) noexcept = default;
    Scene& operator=(Scene&&) noexcept = default;
    ~Scene() = default;

    DirectionalLight mainLight{{0.0f, -1.0f, 0.0f}, Color::white, 1.0f};
    std::vector<Light> additionalLights; ///< besides the main one

    /// A new object at the end of the list; the reference holds as long as the scene.
    GameObject& Add(std::string name);

    const GameObjects& objects() const { return *m_Objects; }

    /// The first object of this name, or null.
    GameObject* Find(std::string_view name);

    /// The renderers as arrays, up to date; for Cull. One thread at a time.
    /// @param origin  what places are relative to
    std::shared_ptr<const RendererTable> UpdateRenderers(const glm::dvec3& origin) const;

private:
    /// Frames drawn before the scene's end may look at them.
    std::shared_ptr<GameObjects> m_Objects = std::make_shared<GameObjects>();
    mutable std::shared_ptr<RendererTable> m_Renderers; ///< follows the objects
};

} // namespace limn
