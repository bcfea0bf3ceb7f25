#pragma once

#include "settings/SettingsCollector.h"

#include <limn/editor_stub/SceneFile.h>

namespace limn
{

/// A component, a feature, or a Unity asset.
struct InspectedGroup
{
    std::string type;
    std::string name; ///< of a component ""
    bool active = true;
    std::vector<InspectedValue> values;
};

/// A profile, and the volume that brings it.
struct InspectedVolume
{
    std::string name; ///< "" for a profile that was asked for itself; then the rest says nothing
    bool enabled = true;
    bool isGlobal = true;
    float priority = 0.0f;
    float weight = 1.0f;
    float blendDistance = 0.0f; ///< metres
    std::string profile;
    std::vector<InspectedGroup> components;
};

/// What a file sets.
struct InspectReport
{
    std::string kind; ///< "scene", "profile", "renderer", "pipeline" or "material"
    std::optional<InspectedGroup> asset; ///< the values of the last three
    std::vector<InspectedVolume> volumes;
    std::vector<InspectedGroup> features;
};

std::vector<InspectedGroup> InspectProfile(const VolumeProfile& profile,
                                           const VolumeComponentRegistry& registry);
std::vector<InspectedGroup> InspectFeatures(const RendererAsset& renderer,
                                            const FeatureRegistry& registry,
                                            const LayerNames& layers,
                                            const LayerNames& renderingLayers);

std::string ToText(const InspectReport& report); ///< lines for people
std::string ToJson(const InspectReport& report);

} // namespace limn
