#pragma once

#include <limn/features/Features.h>

namespace limn::test
{

/// The outline techniques that come with limn.
inline const std::vector<Technique>& ShippedTechniques()
{
    static const std::vector<Technique> techniques = []
    {
        FeatureRegistry features;
        VolumeComponentRegistry components;
        RegisterFeatures(features, components);
        return features.techniques();
    }();
    return techniques;
}

} // namespace limn::test
