#pragma once

#include <glm/vec3.hpp>
#include <limn/core/FixedList.h>
#include <limn/core/Flags.h>
#include <limn/core/List.h>
#include <limn/core/ShaderId.h>
#include <memory>
#include <vector>

namespace limn
{

/// The keys that sort draws. They apply in the order of their values, and the first that differs
/// decides; equal items keep the scene's order. Unity: UnityEngine.Rendering.SortingCriteria.
enum class SortingCriteria
{
    None = 0,
    SortingLayer = 1, ///< accepted; limn has no 2D sorting layers, so all are equal
    RenderQueue = 2,
    BackToFront = 4,           ///< distances whose squares are the same float are equal
    QuantizedFrontToBack = 8,  ///< distances within the same eighth of an octave are equal
    OptimizeStateChanges = 16, ///< equal shader, material and mesh together
    CanvasOrder = 32,          ///< accepted; all are equal
    RendererPriority = 64,     ///< accepted; all are equal
    CommonOpaque = 59,
    CommonTransparent = 23
};
template <>
inline constexpr bool k_IsFlags<SortingCriteria> = true;

/// Unity: UnityEngine.Rendering.DistanceMetric.
enum class DistanceMetric
{
    Perspective = 0,  ///< distance from the camera
    Orthographic = 1, ///< distance along the view direction
    CustomAxis = 2    ///< distance along SortingSettings::customAxis
};

/// Unity: UnityEngine.Rendering.SortingSettings (2022.3).
struct SortingSettings
{
    SortingCriteria criteria = SortingCriteria::None;
    glm::dvec3 cameraPosition{0.0};   ///< world, metres
    glm::vec3 cameraForward{0, 0, 1}; ///< world, unit length
    DistanceMetric distanceMetric = DistanceMetric::Perspective;
    glm::vec3 customAxis{0, 0, 1}; ///< world, of any length; what lies farther along it is farther

    bool operator==(const SortingSettings&) const = default;
};

class Material;
class Shader;

/// Returns the LightModes that URP's forward passes draw: SRPDefaultUnlit, UniversalForward,
/// UniversalForwardOnly.
const std::vector<ShaderTagId>& ForwardShaderTags();

/// Unity: UnityEngine.Rendering.PerObjectData (2022.3); bit flags, values Unity's.
enum class PerObjectData
{
    None = 0,
    LightProbe = 1,
    ReflectionProbes = 2,
    LightProbeProxyVolume = 4,
    Lightmaps = 8,
    LightData = 16,
    MotionVectors = 32,
    LightIndices = 64,
    ReflectionProbeData = 128,
    OcclusionProbe = 256,
    OcclusionProbeProxyVolume = 512,
    ShadowMask = 1024
};
template <>
inline constexpr bool k_IsFlags<PerObjectData> = true;

/// Describes how a DrawRenderers call draws the items that passed its filter: for each tag in turn,
/// it draws the first pass of the object's shader with that LightMode; a pass without LightMode
/// counts as SRPDefaultUnlit. Unity: UnityEngine.Rendering.DrawingSettings (2022.3).
struct DrawingSettings
{
    static constexpr int maxShaderPasses = 16;

    FixedList<ShaderTagId, maxShaderPasses> shaderTagIds;
    SortingSettings sortingSettings;

    /// Draws everything with this pass of this material instead of the object's own. Filtering
    /// still looks at the object's own material, which must have a pass of one of the tags.
    std::shared_ptr<const Material> overrideMaterial;
    int overrideMaterialPassIndex = 0;

    /// Draws everything with this pass of this shader and the properties of the object's own
    /// material. Filtering is as with overrideMaterial, which wins where both are set.
    std::shared_ptr<const Shader> overrideShader;
    int overrideShaderPassIndex = 0;

    /// Draws, with its first pass, the items whose own pass does not compile. Without it such a
    /// pass is an error.
    std::shared_ptr<const Material> fallbackMaterial;

    // These have no effect: equal meshes and states become instances of one draw, and shaders find
    // the lights by themselves.
    bool enableDynamicBatching = false;
    bool enableInstancing = true;
    int mainLightIndex = -1;
    PerObjectData perObjectData = PerObjectData::None;

    /// @throws ContractError outside 0...15
    void SetShaderPassName(int index, ShaderTagId tag);
    /// Returns the tag, or the empty name if none was set. @throws ContractError outside 0...15
    ShaderTagId GetShaderPassName(int index) const;
};

} // namespace limn
