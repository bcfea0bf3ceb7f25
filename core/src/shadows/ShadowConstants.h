#pragma once

#include "scene/RendererTable.h"

#include <algorithm>
#include <limn/core/Light.h>
#include <limn/core/RenderingData.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// The shadow properties that lights of all kinds have.
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

/// Returns the softness of shadows for shaders: 0 = hard, 1...3 as SoftShadowQuality.
int SoftnessOf(const LightShadowLook& light, const ShadowSettings& settings);

/// Returns _ShadowBias: metres along the light and along the normal, negative. A wider filter needs
/// more of it, since it looks farther down a slope.
glm::vec4 ShadowBias(const LightShadowLook& light, const ShadowSettings& settings,
                     double texelSize);

/// Returns ShadowSettings' resolutions of squares: low, medium, high.
glm::ivec3 TiersOf(const ShadowSettings& settings);

/// Returns the shares of the shadow distance at which the cascades but the last end.
glm::vec3 SplitOf(const ShadowSettings& settings);

/// Returns the resolution that a light asks for.
int ResolutionOf(const Light& light, const glm::ivec3& tiers);

/// Returns a scale and bias for the square of a distance, which give 0 where shadows begin to fade
/// and 1 where they end.
glm::vec2 FadeScaleAndBias(double distance, double border);

/// Returns the matrix from clip space to the texture coordinates and depth of a tile.
/// @param size  of the shadow map, texels
glm::dmat4 ToTexture(const ViewportRect& tile, const glm::dvec2& size);

/// The objects that throw shadows into a tile of a shadow map.
struct ShadowCasters
{
    CullingResults plain;
    CullingResults twoSided; ///< objects whose back faces throw shadows, too

    bool isEmpty() const { return plain.items.empty() && twoSided.items.empty(); }
};

/// Finds what CullShadowCasters finds, for both kinds of objects.
ShadowCasters FindShadowCasters(const CullingResults& results, const Camera& camera,
                                const glm::dmat4& toLight);
void DrawShadowCasters(ScriptableRenderContext& context, RenderingData& renderingData,
                       const ShadowCasters& casters);

/// Returns whether one of the items whose shader receives shadows is near enough to show one.
/// @param receives  shader → whether it receives shadows
/// @param isNear    (table, row) → whether it is near enough
template <typename Receives, typename IsNear>
bool HasReceiver(const RendererItems& items, const Receives& receives, const IsNear& isNear)
{
    if (items.empty())
    {
        return false;
    }
    const RendererTable& table = *items.table();
    static thread_local std::vector<std::uint8_t> byClass; // for its memory
    byClass.clear();
    for (const RendererTable::DrawKey& rowClass : table.classes())
    {
        byClass.push_back(rowClass.material && receives(*rowClass.material->shader()));
    }
    return std::ranges::any_of(items.rows(), [&table, &isNear, &known = byClass](std::uint32_t row)
                               { return known[table.classOf()[row]] != 0 && isNear(table, row); });
}

/// Returns whether a light gives light: the shadows of a light that is black or has no intensity
/// are not visible. Unity does not list such lights among the visible ones.
template <typename AnyLight>
bool GivesLight(const AnyLight& light)
{
    const Color& color = light.color;
    return light.intensity != 0.0f && (color.r != 0.0f || color.g != 0.0f || color.b != 0.0f);
}

} // namespace limn
