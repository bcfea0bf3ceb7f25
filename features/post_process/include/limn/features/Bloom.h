#pragma once

#include <limn/volume/AssetParameters.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeComponent.h>

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
    MinFloatParameter threshold{
        this,
        "threshold",
        0.9f,
        0.0f,
        {.tooltip = "The brightness, in sRGB, from which on colours glow."}};
    MinFloatParameter intensity{
        this, "intensity", 0.0f, 0.0f, {.tooltip = "How strong the glow is; 0 draws none."}};
    ClampedFloatParameter scatter{this, "scatter", 0.7f,
                                  0.0f, 1.0f,      {.tooltip = "How far the glow reaches."}};
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
        {.tooltip = "More taps: smoother, and no flicker of what is small and bright."}};
    EnumParameter<BloomDownscaleMode> downscale{
        this,
        "downscale",
        BloomDownscaleMode::Half,
        {{"Half", BloomDownscaleMode::Half}, {"Quarter", BloomDownscaleMode::Quarter}},
        {.tooltip = "The part of the picture's size that the glow begins with."}};
    ClampedIntParameter maxIterations{
        this,
        "maxIterations",
        6,
        2,
        8,
        {.tooltip = "How many pictures the glow is made of at most, each half the last one's "
                    "size."}};
    TextureParameter dirtTexture{
        this, "dirtTexture", {}, {.tooltip = "What is on the lens, where the glow shows it."}};
    MinFloatParameter dirtIntensity{this, "dirtIntensity", 0.0f, 0.0f};

    bool IsActive() const override { return intensity.value() > 0.0f; }
    bool IsTileCompatible() const override { return false; }
};

} // namespace limn
