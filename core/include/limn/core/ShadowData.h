#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limn/core/ShadowSettings.h>
#include <span>
#include <vector>

namespace limn
{

class Scene;
struct Light;
struct LightData;

/// What shadows the pipeline and the frame's lights ask for; whether a map is drawn depends on what
/// there is to throw them and to show them.
/// Unity: UnityEngine.Rendering.Universal.ShadowData (URP 14).
struct ShadowData
{
    bool supportsMainLightShadows = false; ///< the pipeline does, and the main light throws them
    int mainLightShadowmapWidth = 0;       ///< texels
    int mainLightShadowmapHeight = 0;
    int mainLightShadowCascadesCount = 0;         ///< 1...4
    glm::vec3 mainLightShadowCascadesSplit{0.0f}; ///< shares of the distance; 1, 0, 0 = one only
    float mainLightShadowCascadeBorder = 0.0f;    ///< share of the distance, 0...1
    bool supportsAdditionalLightShadows = false;  ///< as of the main one
    int additionalLightsShadowmapWidth = 0;       ///< texels
    int additionalLightsShadowmapHeight = 0;
    bool supportsSoftShadows = false;
    int shadowmapDepthBufferBits = 0; ///< 32 (Unity: 16)

    ShadowData() = default;
    /// @param lights  what they point to must outlive calls of bias()
    ShadowData(const ShadowSettings& settings, const LightData& lights);

    /// Of each of LightData::visibleLights(), texels: towards the light and along the normal, 0, 0.
    /// Worked out when asked for. Unity: ShadowData.bias, a list.
    std::vector<glm::vec4> bias() const;
    /// Of each of them, texels along a side of a square that it asks for on the map of additional
    /// lights. The main one is of tier High, and has another map. Unity: ShadowData.resolution.
    std::vector<int> resolution() const;

private:
    const Scene* m_Scene = nullptr; ///< with a main light
    std::span<const Light* const> m_AdditionalLights;
    glm::vec4 m_Bias{0.0f}; ///< the pipeline's
    glm::ivec3 m_Tiers{0};  ///< low, medium, high
};

} // namespace limn
