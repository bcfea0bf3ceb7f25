#include <limn/core/RenderingData.h>

#include "shadows/ShadowConstants.h"

#include <algorithm>

namespace limn
{

namespace
{

bool HasShadows(const Light* light)
{
    return light->shadows != LightShadows::None;
}

template <typename AnyLight>
glm::vec4 BiasOf(const AnyLight& light, const glm::vec4& ofPipeline)
{
    return light.usePipelineSettings
               ? ofPipeline
               : glm::vec4(light.shadowBias, light.shadowNormalBias, 0.0f, 0.0f);
}

} // namespace

ShadowData::ShadowData(const ShadowSettings& settings, const LightData& lights)
    : supportsMainLightShadows(settings.mainLightShadowsSupported && lights.mainLightIndex >= 0 &&
                               lights.scene->mainLight.shadows != LightShadows::None),
      mainLightShadowmapWidth(settings.mainLightShadowmapResolution),
      mainLightShadowmapHeight(settings.mainLightShadowmapResolution),
      mainLightShadowCascadesCount(settings.shadowCascadeCount),
      mainLightShadowCascadesSplit(SplitOf(settings)),
      mainLightShadowCascadeBorder(settings.cascadeBorder),
      supportsAdditionalLightShadows(settings.additionalLightShadowsSupported &&
                                     lights.supportsAdditionalLights &&
                                     std::ranges::any_of(lights.additionalLights, HasShadows)),
      additionalLightsShadowmapWidth(settings.additionalLightsShadowmapResolution),
      additionalLightsShadowmapHeight(settings.additionalLightsShadowmapResolution),
      supportsSoftShadows(settings.softShadowsSupported &&
                          (supportsMainLightShadows || supportsAdditionalLightShadows)),
      shadowmapDepthBufferBits(32),
      m_Scene(lights.mainLightIndex >= 0 ? lights.scene : nullptr),
      m_AdditionalLights(lights.additionalLights),
      m_Bias(settings.shadowDepthBias, settings.shadowNormalBias, 0.0f, 0.0f),
      m_Tiers(TiersOf(settings))
{
}

std::vector<glm::vec4> ShadowData::bias() const
{
    std::vector<glm::vec4> biases;
    if (m_Scene != nullptr)
    {
        biases.push_back(BiasOf(m_Scene->mainLight, m_Bias));
    }
    for (const Light* light : m_AdditionalLights)
    {
        biases.push_back(BiasOf(*light, m_Bias));
    }
    return biases;
}

std::vector<int> ShadowData::resolution() const
{
    std::vector<int> resolutions;
    if (m_Scene != nullptr)
    {
        resolutions.push_back(m_Tiers.z);
    }
    for (const Light* light : m_AdditionalLights)
    {
        resolutions.push_back(ResolutionOf(*light, m_Tiers));
    }
    return resolutions;
}

} // namespace limn
