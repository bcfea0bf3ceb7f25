#pragma once

#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/ShadowSettings.h>
#include <limn/core/Transform.h>

namespace limn
{

/// Unity: UnityEngine.LightType.
enum class LightType
{
    Spot = 0,
    Directional = 1,
    Point = 2
};

/// How a light's shadows end: at once, or softly. Unity: UnityEngine.LightShadows.
enum class LightShadows
{
    None = 0,
    Hard = 1,
    Soft = 2
};

/// Which of ShadowSettings' resolutions a light's shadows have. Unity: the constants of
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

    LightShadows shadows = LightShadows::None; ///< a directional one has none, as in URP
    float shadowStrength = 1.0f;               ///< 0...1: the share of its light that shadows take
    SoftShadowQuality softShadowQuality = SoftShadowQuality::UsePipelineSettings;
    float shadowNearPlane = 0.2f; ///< metres, 0.01 at least: where the shadow map's depth begins
    /// The biases are the pipeline's, not those that follow. Unity: UniversalAdditionalLightData.
    bool usePipelineSettings = true;
    float shadowBias = 0.05f;      ///< texels of the shadow map, towards the light
    float shadowNormalBias = 0.4f; ///< texels, along the normal
    AdditionalLightsShadowResolutionTier additionalLightsShadowResolutionTier =
        AdditionalLightsShadowResolutionTier::High;
    int shadowResolution = 128; ///< of tier Custom: texels, as ShadowSettings has them
};

/// How many lights besides the main one shaders get. Unity: MAX_VISIBLE_LIGHTS of its small
/// platforms; 256 elsewhere.
inline constexpr int k_MaxVisibleAdditionalLights = 32;

/// How many of them an object may have. Unity: UniversalRenderPipeline.maxPerObjectLights (URP 14).
inline constexpr int k_MaxPerObjectLights = 8;

} // namespace limn
