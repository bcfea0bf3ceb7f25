#pragma once

#include <cstdint>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/Light.h>
#include <limn/core/Material.h>
#include <limn/core/MaterialList.h>
#include <limn/core/Mesh.h>
#include <limn/core/RendererPropertyBlocks.h>
#include <limn/core/ShadowSettings.h>
#include <limn/core/Transform.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

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

/// Unity: UnityEngine.GameObject (2022.3).
struct GameObject
{
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

/// What there is to draw. Objects keep their address, so that transforms can be parents. One that
/// was moved from can be destroyed and assigned to only.
class Scene
{
public:
    Scene() = default;
    Scene(Scene&&) noexcept = default;
    Scene& operator=(Scene&&) noexcept = default;
    ~Scene() = default;

    DirectionalLight mainLight{{0.0f, -1.0f, 0.0f}, Color::white, 1.0f};
    std::vector<Light> additionalLights;        ///< besides the main one
    Color ambientLight{0.2f, 0.2f, 0.2f, 1.0f}; ///< sRGB; the same from all sides
    /// What cameras with CameraClearFlags::Skybox see behind all objects; null = none. Its first
    /// pass draws a ball around the camera whose POSITION is the direction in world axes; that of a
    /// shader with six passes draws the cube's sides +Z -Z +X -X +Y -Y, one each, with TEXCOORD0
    /// from bottom left to top right as seen from inside. Unity: RenderSettings.skybox.
    std::shared_ptr<const Material> skybox;

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
