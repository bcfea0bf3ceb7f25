#pragma once

#include "settings/Keys.h"

#include <limn/core/Light.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

/// Unity: UnityEngine.Rendering.Universal.SoftShadowQuality; a light's may say the first one, too.
inline constexpr EnumEntry k_SoftShadowQualities[] = {{"Low", 1}, {"Medium", 2}, {"High", 3}};

/// Hands each setting of shadows to `visit(name, value, range, description)` under its serialised
/// name, Unity's: for the reader and for the schema.
template <typename Visitor>
void VisitShadowSettings(ShadowSettings& s, Visitor&& visit)
{
    constexpr ValueRange k_Share{0.0, 1.0};
    constexpr ValueRange k_Bias{0.0, 10.0};
    visit("m_MainLightShadowsSupported", s.mainLightShadowsSupported, ValueRange{}, "");
    visit("m_MainLightShadowmapResolution", s.mainLightShadowmapResolution,
          ValueRange{64.0, 8192.0}, "Texels along a side of the shadow map");
    visit("m_AdditionalLightShadowsSupported", s.additionalLightShadowsSupported, ValueRange{},
          "Of spots and points");
    visit("m_AdditionalLightsShadowmapResolution", s.additionalLightsShadowmapResolution,
          ValueRange{64.0, 8192.0}, "Texels along a side of the shadow map of spots and points");
    constexpr ValueRange k_Tier{16.0, 8192.0};
    visit("m_AdditionalLightsShadowResolutionTierLow", s.additionalLightsShadowResolutionTierLow,
          k_Tier, "Texels along a side of a light's square on it");
    visit("m_AdditionalLightsShadowResolutionTierMedium",
          s.additionalLightsShadowResolutionTierMedium, k_Tier, "");
    visit("m_AdditionalLightsShadowResolutionTierHigh", s.additionalLightsShadowResolutionTierHigh,
          k_Tier, "");
    visit("m_ShadowDistance", s.shadowDistance, ValueRange{0.0, 1e9},
          "Metres from the camera to where shadows end");
    visit("m_ShadowCascadeCount", s.shadowCascadeCount, ValueRange{1.0, 4.0}, "");
    visit("m_Cascade2Split", s.cascade2Split, k_Share,
          "Where the first of two cascades ends, as a share of the distance");
    visit("m_Cascade3Split", s.cascade3Split, k_Share, "Where the first two of three end");
    visit("m_Cascade4Split", s.cascade4Split, k_Share, "Where the first three of four end");
    visit("m_CascadeBorder", s.cascadeBorder, k_Share,
          "The share of the distance over which shadows fade");
    visit("m_ShadowDepthBias", s.shadowDepthBias, k_Bias, "Texels, along the light");
    visit("m_ShadowNormalBias", s.shadowNormalBias, k_Bias, "Texels, along the normal");
    visit("m_SoftShadowsSupported", s.softShadowsSupported, ValueRange{}, "");
    visit("m_SoftShadowQuality", s.softShadowQuality, ValueRange{},
          "How wide the rims of soft shadows are");
}

/// Sets what the map says; the rest stays. The caller calls map.Finish() where it owns all keys.
void ReadShadowSettings(YamlMapReader& map, ShadowSettings& settings,
                        AssetDiagnostics& diagnostics);

} // namespace limn
