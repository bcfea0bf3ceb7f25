#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace limn
{

/// How many texels of the shadow map a soft shadow's rim is wide: 3, 5 or 7 and what lies between
/// texels. Unity: UnityEngine.Rendering.Universal.SoftShadowQuality (URP 14).
enum class SoftShadowQuality
{
    UsePipelineSettings = 0,
    Low = 1,
    Medium = 2,
    High = 3
};

/// The shadows of lights, for all scenes of a pipeline; the names without `m_` and the
/// defaults are those of UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset (URP 14),
/// which begins without soft shadows.
struct ShadowSettings
{
    bool mainLightShadowsSupported = true;
    int mainLightShadowmapResolution = 2048; ///< texels along a side of all cascades, 64...8192
    /// Of spots and points, on one map. Unity's assets begin with false.
    bool additionalLightShadowsSupported = true;
    int additionalLightsShadowmapResolution = 2048; ///< texels along a side of it, 64...8192
    // Texels along a side of a square of it, of lights of each tier: a spot has one, a point six.
    // The power of two at or below; where they have no room, all are halved until they do.
    int additionalLightsShadowResolutionTierLow = 256; ///< 16...8192, as the next two
    int additionalLightsShadowResolutionTierMedium = 512;
    int additionalLightsShadowResolutionTierHigh = 1024;
    float shadowDistance = 50.0f; ///< metres from the camera to where shadows end, >= 0
    int shadowCascadeCount = 1;   ///< 1...4
    // Where the cascades but the last end, as shares of the distance, each above the one before.
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

} // namespace limn
