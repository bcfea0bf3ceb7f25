#pragma once

#include <limn/volume/AssetParameters.h>
#include <limn/volume/NumberParameters.h>

namespace limn
{

/// The size of the largest picture of the bloom, as a part of the camera's.
/// Unity: BloomDownscaleMode (URP 14).
enum class BloomDownscaleMode
{
    Half = 0,
    Quarter = 1
};

/// Makes bright parts of the picture glow over their surroundings. Unity: Bloom (URP 14).
class Bloom final : public VolumeComponent, public IPostProcessComponent
{
public:
    MinFloatParameter threshold{this,
                                "threshold",
                                0.9f,
                                0.0f,
                                {.tooltip = "The brightness in sRGB from which on colours glow."}};
    MinFloatParameter intensity{
        this, "intensity", 0.0f, 0.0f, {.tooltip = "The strength of the glow; 0 draws none."}};
    ClampedFloatParameter scatter{this, "scatter", 0.7f,
                                  0.0f, 1.0f,      {.tooltip = "The reach of the glow."}};
    MinFloatParameter clamp{this,
                            "clamp",
                            65472.0f,
                            0.0f,
                            {.tooltip = "Colours above this glow as if they were this bright."}};
    ColorParameter tint{this, "tint", Color::white, false, false, true};
    BoolParameter highQualityFiltering{
        this,
        "highQualityFiltering",
        false,
        {.tooltip =
             "Takes more samples: the glow is smoother, and small bright spots do not flicker."}};
    EnumParameter<BloomDownscaleMode> downscale{
        this,
        "downscale",
        BloomDownscaleMode::Half,
        {{"Half", BloomDownscaleMode::Half}, {"Quarter", BloomDownscaleMode::Quarter}},
        {.tooltip =
             "The size of the first picture of the glow, as a part of the camera's picture."}};
    ClampedIntParameter maxIterations{this,
                                      "maxIterations",
                                      6,
                                      2,
                                      8,
                                      {.tooltip = "The greatest number of pictures of the glow; "
                                                  "each is half as large as the one before."}};
    TextureParameter dirtTexture{
        this,
        "dirtTexture",
        {},
        {.tooltip = "The dirt on the lens, which the glow makes visible."}};
    MinFloatParameter dirtIntensity{this, "dirtIntensity", 0.0f, 0.0f};

    bool IsActive() const override { return intensity.value() > 0.0f; }
    bool IsTileCompatible() const override { return false; }
};

} // namespace limn
