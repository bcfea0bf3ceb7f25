#pragma once

#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

/// The mapping of brightness beyond 1 to the screen. Unity: TonemappingMode (URP 14).
enum class TonemappingMode
{
    None = 0,    ///< it is cut off
    Neutral = 1, ///< a filmic curve for each channel, hues and saturation nearly kept
    ACES = 2     ///< the Academy's look of film: more contrast, bright colours become pale
};

/// Maps the brightness of the scene to that of the screen. Unity: Tonemapping (URP 14).
class Tonemapping final : public VolumeComponent, public IPostProcessComponent
{
public:
    EnumParameter<TonemappingMode> mode{this,
                                        "mode",
                                        TonemappingMode::None,
                                        {{"None", TonemappingMode::None},
                                         {"Neutral", TonemappingMode::Neutral},
                                         {"ACES", TonemappingMode::ACES}},
                                        {.tooltip = "The curve from scene to screen brightness."}};

    bool IsActive() const override { return mode.value() != TonemappingMode::None; }
    bool IsTileCompatible() const override { return true; }
};

} // namespace limn
