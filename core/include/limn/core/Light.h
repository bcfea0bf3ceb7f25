#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/Transform.h>

namespace limn
{

/// The width of a soft shadow's edge in texels of the shadow map: 3, 5 or 7 and the part between
/// texels. Unity: UnityEngine.Rendering.Universal.SoftShadowQuality (URP 14).
enum class SoftShadowQuality
{
    UsePipelineSettings = 0,
    Low = 1,
    Medium = 2,
    High = 3
};

/// The shadow settings of a pipeline, for all its scenes. The names, without `m_`, and the defaults
/// are those of UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset (URP 14), which begins
/// without soft shadows.
struct ShadowSettings
{
    bool mainLightShadowsSupported = true;
    int mainLightShadowmapResolution = 2048; ///< texels along a side of all cascades, 64...8192
    /// Switches the shadows of spot and point lights, which share one map. Unity's assets begin
    /// with false.
    bool additionalLightShadowsSupported = true;
    int additionalLightsShadowmapResolution = 2048; ///< texels along a side of it, 64...8192
    // The texels along a side of a square of that map, for lights of each tier. A spot light has
    // one square, a point light six. The size is the power of two at or below the value; if the
    // squares do not fit, all are halved until they do.
    int additionalLightsShadowResolutionTierLow = 256; ///< 16...8192, as the next two
    int additionalLightsShadowResolutionTierMedium = 512;
    int additionalLightsShadowResolutionTierHigh = 1024;
    float shadowDistance = 50.0f; ///< metres from the camera to where shadows end, >= 0
    int shadowCascadeCount = 1;   ///< 1...4
    // The places where the cascades but the last end, as shares of the distance, each above the one
    // before. Those of other numbers of cascades have no effect.
    float cascade2Split = 0.25f;
    glm::vec2 cascade3Split{0.1f, 0.3f};
    glm::vec3 cascade4Split{0.067f, 0.2f, 0.467f};
    float cascadeBorder = 0.2f;    ///< the share of the distance over which shadows fade, 0...1
    float shadowDepthBias = 1.0f;  ///< texels, along the light, 0...10
    float shadowNormalBias = 1.0f; ///< texels, along the normal, 0...10
    bool softShadowsSupported = true;
    SoftShadowQuality softShadowQuality = SoftShadowQuality::Medium;

    bool operator==(const ShadowSettings&) const = default;
};

/// Unity: UnityEngine.LightType.
enum class LightType
{
    Spot = 0,
    Directional = 1,
    Point = 2
};

/// Selects whether a light has no shadows, shadows with hard edges, or with soft ones.
/// Unity: UnityEngine.LightShadows.
enum class LightShadows
{
    None = 0,
    Hard = 1,
    Soft = 2
};

/// Selects which of ShadowSettings' resolutions a light's shadows have. Unity: the constants of
/// UnityEngine.Rendering.Universal.UniversalAdditionalLightData (URP 14).
enum class AdditionalLightsShadowResolutionTier
{
    Custom = -1, ///< Light::shadowResolution
    Low = 0,
    Medium = 1,
    High = 2
};

/// A light besides the main one. Unity: UnityEngine.Light (2022.3).
struct Light
{
    LightType type = LightType::Point;
    Transform transform; ///< shines along its +z, from its position; its scale does not matter
    Color color = Color::white; ///< sRGB
    float intensity = 1.0f;     ///< multiplies the linear colour
    float range = 10.0f;        ///< metres, > 0; nothing is lit from there on (not Directional)
    float spotAngle = 30.0f;    ///< degrees across, where a spot's light ends
    float innerSpotAngle = 21.80208f; ///< degrees across, up to where it is full

    LightShadows shadows = LightShadows::None; ///< ignored for a directional light, as in URP
    float shadowStrength = 1.0f;               ///< 0...1: the share of its light that shadows take
    SoftShadowQuality softShadowQuality = SoftShadowQuality::UsePipelineSettings;
    float shadowNearPlane = 0.2f; ///< metres, 0.01 at least: where the shadow map's depth begins
    /// If true, the biases are the pipeline's, not the two that follow.
    /// Unity: UniversalAdditionalLightData.
    bool usePipelineSettings = true;
    float shadowBias = 0.05f;      ///< texels of the shadow map, towards the light
    float shadowNormalBias = 0.4f; ///< texels, along the normal
    AdditionalLightsShadowResolutionTier additionalLightsShadowResolutionTier =
        AdditionalLightsShadowResolutionTier::High;
    int shadowResolution = 128; ///< of tier Custom: texels, as ShadowSettings has them
};

/// The largest number of lights besides the main one that shaders get. Unity: MAX_VISIBLE_LIGHTS of
/// its small platforms; 256 elsewhere.
inline constexpr int k_MaxVisibleAdditionalLights = 32;

/// The largest number of these lights that an object may have.
/// Unity: UniversalRenderPipeline.maxPerObjectLights (URP 14).
inline constexpr int k_MaxPerObjectLights = 8;

} // namespace limn
