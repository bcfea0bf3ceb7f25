#pragma once

#include "TestComponents.h"

#include <limn/volume/VolumeManager.h>

namespace limn::test
{

inline constexpr LayerMask k_DefaultLayer = LayerMask::FromIndex(0);

/// A profile whose only override is TestVolume.param.
inline std::shared_ptr<VolumeProfile> ParamProfile(float value)
{
    auto profile = std::make_shared<VolumeProfile>();
    profile->Add<TestVolume>().param.Override(value);
    return profile;
}

inline Volume GlobalVolume(std::shared_ptr<const VolumeProfile> profile, float priority = 0.0f)
{
    Volume volume;
    volume.sharedProfile = std::move(profile);
    volume.priority = priority;
    return volume;
}

/// A manager with a stack, and what a test asks of them.
struct VolumeScene
{
    TestRegistry registry;
    VolumeManager manager{registry};
    VolumeStack stack = manager.CreateStack();

    void Update(const std::optional<glm::vec3>& trigger = glm::vec3(0.0f),
                LayerMask mask = k_DefaultLayer)
    {
        manager.Update(stack, trigger, mask);
    }

    template <typename T>
    const T& Get() const
    {
        return *stack.GetComponent<T>();
    }
    float Param() const { return Get<TestVolume>().param.value(); }
};

} // namespace limn::test
