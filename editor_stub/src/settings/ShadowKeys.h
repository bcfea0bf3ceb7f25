#pragma once

#include "settings/Keys.h"

#include <limn/core/Light.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

/// Unity: UnityEngine.Rendering.Universal.SoftShadowQuality; a light's may say the first one, too.
inline constexpr EnumEntry k_SoftShadowQualities[] = {{"Low", 1}, {"Medium", 2}, {"High", 3}};

/// Calls `visit(name, value, range, description)` for each setting of shadows, with Unity's
/// serialised name. The reader and the schema use it.
template <typename Visitor>
void VisitShadowSettings(ShadowSettings& s, Visitor&& visit)
{
    visit("m_MainLightShadowsSupported", s.mainLightShadowsSupported, ValueRange{},
          "Lets the main light throw shadows");
    visit("m_MainLightShadowmapResolution", s.mainLightShadowmapResolution,
          ValueRange{64.0, 8192.0}, "The texels along a side of the main light's shadow map");
    visit("m_AdditionalLightShadowsSupported", s.additionalLightShadowsSupported, ValueRange{},
          "Lets spots and points throw shadows");
    visit("m_AdditionalLightsShadowmapResolution", s.additionalLightsShadowmapResolution,
          ValueRange{64.0, 8192.0},
          "The texels along a side of the shadow map that spots and points share");
    visit("m_AdditionalLightsShadowResolutionTierLow", s.additionalLightsShadowResolutionTierLow,
          k_ShadowTexels,
          "The texels along a side of the square of a light of tier Low on that map");
    visit("m_AdditionalLightsShadowResolutionTierMedium",
          s.additionalLightsShadowResolutionTierMedium, k_ShadowTexels,
          "The texels along a side of the square of a light of tier Medium");
    visit("m_AdditionalLightsShadowResolutionTierHigh", s.additionalLightsShadowResolutionTierHigh,
          k_ShadowTexels, "The texels along a side of the square of a light of tier High");
    visit("m_ShadowDistance", s.shadowDistance, ValueRange{0.0, 1e9},
          "The distance in metres from the camera at which shadows end");
    visit("m_ShadowCascadeCount", s.shadowCascadeCount, ValueRange{1.0, 4.0},
          "The number of cascades: parts of the distance, each with a shadow map of its own");
    visit("m_Cascade2Split", s.cascade2Split, k_Shares,
          "The end of the first of two cascades, as a share of the distance");
    visit("m_Cascade3Split", s.cascade3Split, k_Shares,
          "The ends of the first two of three cascades");
    visit("m_Cascade4Split", s.cascade4Split, k_Shares,
          "The ends of the first three of four cascades");
    visit("m_CascadeBorder", s.cascadeBorder, k_Shares,
          "The share of the distance over which shadows fade");
    visit("m_ShadowDepthBias", s.shadowDepthBias, k_ShadowBiases,
          "The bias along the light, in texels");
    visit("m_ShadowNormalBias", s.shadowNormalBias, k_ShadowBiases,
          "The bias along the normal, in texels");
    visit("m_SoftShadowsSupported", s.softShadowsSupported, ValueRange{},
          "Lets shadows of lights with soft shadows be soft");
    visit("m_SoftShadowQuality", s.softShadowQuality, ValueRange{},
          "The width of the rims of soft shadows");
}

/// Sets the settings that the map has. The others stay. The caller calls map.Finish() if it owns
/// all keys.
void ReadShadowSettings(YamlMapReader& map, ShadowSettings& settings,
                        AssetDiagnostics& diagnostics);

} // namespace limn
