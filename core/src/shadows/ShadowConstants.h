#pragma once

#include <limn/core/Light.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// What lights of all kinds say of their shadows.
struct LightShadowLook
{
    LightShadows shadows;
    SoftShadowQuality softShadowQuality;
    bool usePipelineSettings;
    glm::vec2 bias; ///< texels: towards the light, along the normal
};

template <typename AnyLight>
LightShadowLook LookOf(const AnyLight& light)
{
    return {light.shadows,
            light.softShadowQuality,
            light.usePipelineSettings,
            {light.shadowBias, light.shadowNormalBias}};
}

/// What shaders take for how soft shadows are: 0 not at all, 1...3 as SoftShadowQuality.
int SoftnessOf(const LightShadowLook& light, const ShadowSettings& settings);

/// _ShadowBias: metres along the light and along the normal, negative. A wider filter looks that
/// much farther down a slope.
glm::vec4 ShadowBias(const LightShadowLook& light, const ShadowSettings& settings,
                     double texelSize);

/// ShadowSettings' resolutions of squares: low, medium, high.
glm::ivec3 TiersOf(const ShadowSettings& settings);

/// What a light asks for.
int ResolutionOf(const Light& light, const glm::ivec3& tiers);

/// For the square of a distance: 0 where shadows begin to fade, 1 where they end.
glm::vec2 FadeScaleAndBias(double distance, double border);

/// Draws what CullShadowCasters found.
void DrawShadowCasters(ScriptableRenderContext& context, const DrawingSettings& drawing,
                       const CullingResults& plain, const CullingResults& twoSided);

/// Returns whether a light lights: shadows of one that is black or of no intensity show not. Unity
/// does not list such lights among the visible ones.
template <typename AnyLight>
bool GivesLight(const AnyLight& light)
{
    const Color& color = light.color;
    return light.intensity != 0.0f && (color.r != 0.0f || color.g != 0.0f || color.b != 0.0f);
}

} // namespace limn
