#include "profile/UrpVolumeComponents.h"

#include <algorithm>
#include <span>

namespace limn
{

namespace
{

using Names = std::span<const std::string_view>;

struct UrpComponent
{
    std::string_view name;
    Names parameters;
};

constexpr std::string_view k_Bloom[] = {"skipIterations", "threshold",     "intensity",
                                        "scatter",        "clamp",         "tint",
                                        "filter",         "downscale",     "maxIterations",
                                        "dirtTexture",    "dirtIntensity", "highQualityFiltering"};
constexpr std::string_view k_ChannelMixer[] = {"redOutRedIn",   "redOutGreenIn",   "redOutBlueIn",
                                               "greenOutRedIn", "greenOutGreenIn", "greenOutBlueIn",
                                               "blueOutRedIn",  "blueOutGreenIn",  "blueOutBlueIn"};
constexpr std::string_view k_ChromaticAberration[] = {"intensity"};
constexpr std::string_view k_ColorAdjustments[] = {"postExposure", "contrast", "colorFilter",
                                                   "hueShift", "saturation"};
constexpr std::string_view k_ColorCurves[] = {"master",   "red",      "green",    "blue",
                                              "hueVsHue", "hueVsSat", "satVsSat", "lumVsSat"};
constexpr std::string_view k_ColorLookup[] = {"texture", "contribution"};
constexpr std::string_view k_DepthOfField[] = {
    "mode",          "gaussianStart", "gaussianEnd", "gaussianMaxRadius", "highQualitySampling",
    "focusDistance", "aperture",      "focalLength", "bladeCount",        "bladeCurvature",
    "bladeRotation"};
constexpr std::string_view k_FilmGrain[] = {"type", "intensity", "response", "texture"};
constexpr std::string_view k_LensDistortion[] = {"intensity", "xMultiplier", "yMultiplier",
                                                 "center", "scale"};
constexpr std::string_view k_LiftGammaGain[] = {"lift", "gamma", "gain"};
constexpr std::string_view k_MotionBlur[] = {"mode", "quality", "intensity", "clamp"};
constexpr std::string_view k_PaniniProjection[] = {"distance", "cropToFit"};
constexpr std::string_view k_ScreenSpaceLensFlare[] = {"intensity",
                                                       "tintColor",
                                                       "bloomMip",
                                                       "firstFlareIntensity",
                                                       "secondaryFlareIntensity",
                                                       "warpedFlareIntensity",
                                                       "warpedFlareScale",
                                                       "samples",
                                                       "sampleDimmer",
                                                       "vignetteEffect",
                                                       "startingPosition",
                                                       "scale",
                                                       "streaksIntensity",
                                                       "streaksLength",
                                                       "streaksOrientation",
                                                       "streaksThreshold",
                                                       "resolution",
                                                       "chromaticAbberationIntensity",
                                                       "chromaticAbberationSampleCount"};
constexpr std::string_view k_ShadowsMidtonesHighlights[] = {
    "shadows",    "midtones",        "highlights",   "shadowsStart",
    "shadowsEnd", "highlightsStart", "highlightsEnd"};
constexpr std::string_view k_SplitToning[] = {"shadows", "highlights", "balance"};
constexpr std::string_view k_Tonemapping[] = {"mode",
                                              "neutralHDRRangeReductionMode",
                                              "acesPreset",
                                              "hueShiftAmount",
                                              "paperWhite",
                                              "detectPaperWhite",
                                              "minNits",
                                              "maxNits",
                                              "detectBrightnessLimits"};
constexpr std::string_view k_Vignette[] = {"color", "center", "intensity", "smoothness", "rounded"};
constexpr std::string_view k_WhiteBalance[] = {"temperature", "tint"};

constexpr UrpComponent k_Components[] = {{"Bloom", k_Bloom},
                                         {"ChannelMixer", k_ChannelMixer},
                                         {"ChromaticAberration", k_ChromaticAberration},
                                         {"ColorAdjustments", k_ColorAdjustments},
                                         {"ColorCurves", k_ColorCurves},
                                         {"ColorLookup", k_ColorLookup},
                                         {"DepthOfField", k_DepthOfField},
                                         {"FilmGrain", k_FilmGrain},
                                         {"LensDistortion", k_LensDistortion},
                                         {"LiftGammaGain", k_LiftGammaGain},
                                         {"MotionBlur", k_MotionBlur},
                                         {"PaniniProjection", k_PaniniProjection},
                                         {"ProbeVolumesOptions", {}},
                                         {"ScreenSpaceLensFlare", k_ScreenSpaceLensFlare},
                                         {"ShadowsMidtonesHighlights", k_ShadowsMidtonesHighlights},
                                         {"SplitToning", k_SplitToning},
                                         {"Tonemapping", k_Tonemapping},
                                         {"Vignette", k_Vignette},
                                         {"WhiteBalance", k_WhiteBalance}};

const UrpComponent* Find(std::string_view name)
{
    const auto* found = std::ranges::find(k_Components, name, &UrpComponent::name);
    return found == std::end(k_Components) ? nullptr : found;
}

} // namespace

bool IsUrpVolumeComponent(std::string_view component)
{
    return Find(component) != nullptr;
}

bool IsUrpParameter(std::string_view component, std::string_view parameter)
{
    const UrpComponent* found = Find(component);
    return found && std::ranges::find(found->parameters, parameter) != found->parameters.end();
}

} // namespace limn
