#pragma once

#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/editor_stub/LayerNames.h>
#include <limn/volume/YamlRead.h>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// A setting or a parameter as text for people.
struct InspectedValue
{
    std::string header; ///< the header above it; "" for a parameter, or if there is none
    std::string name;
    std::string value;
    std::string defaultValue;
    bool hasDefault = true;
    std::optional<ValueRange> range;
    bool isOverridden = false; ///< true if a setting differs from its default
    std::string unit;          ///< "pixels"; "" for none
    std::string tooltip;
};

/// Returns "{r: 1, g: 0.5}" for consecutive numbers in memory. `names` has a letter for each.
std::string MembersText(const float* numbers, std::string_view names);

/// Returns a feature's settings in its order, each beside the default: the value in a feature of
/// the same type as the constructor leaves it.
std::vector<InspectedValue> CollectSettings(ScriptableRendererFeature& feature,
                                            ScriptableRendererFeature& defaultFeature,
                                            const LayerNames& layers,
                                            const LayerNames& renderingLayers);

} // namespace limn
