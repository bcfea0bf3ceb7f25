#include "shadows/ShadowConstants.h"

#include "passes/MakeDrawingSettings.h"

#include <span>

namespace limn
{

int SoftnessOf(const LightShadowLook& light, const ShadowSettings& settings)
{
    if (light.shadows != LightShadows::Soft || !settings.softShadowsSupported)
    {
        return 0;
    }
    return static_cast<int>(light.softShadowQuality == SoftShadowQuality::UsePipelineSettings
                                ? settings.softShadowQuality
                                : light.softShadowQuality);
}

glm::vec4 ShadowBias(const LightShadowLook& light, const ShadowSettings& settings, double texelSize)
{
    const glm::vec2 texels = light.usePipelineSettings
                                 ? glm::vec2(settings.shadowDepthBias, settings.shadowNormalBias)
                                 : light.bias;
    const int softness = SoftnessOf(light, settings);
    const double reach = softness > 0 ? softness + 0.5 : 1.0;
    return glm::vec4(glm::dvec2(texels) * (-texelSize * reach), 0.0, 0.0);
}

glm::ivec3 TiersOf(const ShadowSettings& settings)
{
    return {settings.additionalLightsShadowResolutionTierLow,
            settings.additionalLightsShadowResolutionTierMedium,
            settings.additionalLightsShadowResolutionTierHigh};
}

glm::vec3 SplitOf(const ShadowSettings& settings)
{
    switch (settings.shadowCascadeCount)
    {
    case 1:
        return {1.0f, 0.0f, 0.0f};
    case 2:
        return {settings.cascade2Split, 1.0f, 0.0f};
    case 3:
        return {settings.cascade3Split.x, settings.cascade3Split.y, 0.0f};
    default:
        return settings.cascade4Split;
    }
}

int ResolutionOf(const Light& light, const glm::ivec3& tiers)
{
    using Tier = AdditionalLightsShadowResolutionTier;
    const Tier tier = light.additionalLightsShadowResolutionTier;
    return tier == Tier::Custom ? light.shadowResolution : tiers[static_cast<int>(tier)];
}

glm::vec2 FadeScaleAndBias(double distance, double border)
{
    const double end = distance * distance;
    const double begin = end * (1.0 - border) * (1.0 - border);
    constexpr double k_Sharp = 1000.0;
    return border < 1e-4 ? glm::vec2(k_Sharp, -end * k_Sharp)
                         : glm::vec2(1.0 / (end - begin), -begin / (end - begin));
}

glm::dmat4 ToTexture(const ViewportRect& tile, const glm::dvec2& size)
{
    const glm::dvec2 scale = glm::dvec2(tile.width, tile.height) / size;
    const glm::dvec2 offset = glm::dvec2(tile.x, tile.y) / size;
    glm::dmat4 toTexture(1.0);
    toTexture[0][0] = 0.5 * scale.x;
    toTexture[1][1] = 0.5 * scale.y;
    toTexture[3] = glm::dvec4(0.5 * scale + offset, 0.0, 1.0);
    return toTexture;
}

ShadowCasters FindShadowCasters(const CullingResults& results, const Camera& camera,
                                const glm::dmat4& toLight)
{
    return {CullShadowCasters(results, camera, toLight, false),
            CullShadowCasters(results, camera, toLight, true)};
}

void DrawShadowCasters(ScriptableRenderContext& context, RenderingData& renderingData,
                       const ShadowCasters& casters)
{
    static const ShaderTagId k_ShadowCaster{"ShadowCaster"};
    const DrawingSettings drawing =
        MakeDrawingSettings(std::span(&k_ShadowCaster, 1), *renderingData.cameraData.camera,
                            SortingCriteria::CommonOpaque);
    const FilteringSettings filtering(RenderQueueRange::all);
    if (!casters.plain.items.empty())
    {
        context.DrawRenderers(casters.plain, drawing, filtering);
    }
    if (!casters.twoSided.items.empty())
    {
        RenderStateBlock bothSides(RenderStateMask::Raster);
        bothSides.rasterState.cullingMode = CullMode::Off;
        context.DrawRenderers(casters.twoSided, drawing, filtering, bothSides);
    }
}

} // namespace limn
