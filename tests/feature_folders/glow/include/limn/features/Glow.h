#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

/// As small as a feature can be: what a folder needs that is all a program is given.
class Glow final : public VolumeComponent
{
public:
    FloatParameter m_Strength{this, "m_Strength", 1.0f};
};

class GlowFeature final : public ScriptableRendererFeature
{
public:
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
};

} // namespace limn
