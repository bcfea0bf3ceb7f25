#pragma once

#include <limn/volume/NumberParameters.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/VolumeComponent.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn::test
{

/// The component of the outline feature that is ported from Unity, with its serialised names.
class ScreenSpaceOutline : public VolumeComponent
{
public:
    BoolParameter m_Enable{this, "m_Enable", false};
    ColorParameter m_OutlineColor{this, "m_OutlineColor", Color::white};
    ClampedFloatParameter m_OutlineWidth{this, "m_OutlineWidth", 3.0f, 1.0f, 10.0f};
};

/// One parameter of each kind, all 0.
class Mixed : public VolumeComponent
{
public:
    FloatParameter number{this, "number", 0.0f};
    IntParameter whole{this, "whole", 0};
    BoolParameter flag{this, "flag", false};
    ColorParameter tint{this, "tint", Color::clear};
};

class TestVolume : public VolumeComponent
{
public:
    FloatParameter param{this, "param", 123.0f};
};

struct TestRegistry : VolumeComponentRegistry
{
    TestRegistry()
    {
        Register<ScreenSpaceOutline>("ScreenSpaceOutline");
        Register<Mixed>("Mixed");
        Register<TestVolume>("TestVolume");
    }
};

} // namespace limn::test
