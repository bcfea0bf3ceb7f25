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
    std::string header; ///< that it stands under; "" for a parameter, or without one
    std::string name;
    std::string value;
    std::string defaultValue;
    bool hasDefault = true;
    std::optional<ValueRange> range;
    bool isOverridden = false; ///< of a setting: it differs from its default
    std::string unit;          ///< "pixels"; "" for none
    std::string tooltip;
};

/// "{r: 1, g: 0.5}" of numbers that lie one behind the other, each named by a letter.
std::string MembersText(const float* numbers, std::string_view names);

/// A feature's settings in its order, beside those of one of its type as the constructor leaves it.
std::vector<InspectedValue> CollectSettings(ScriptableRendererFeature& feature,
                                            ScriptableRendererFeature& defaultFeature,
                                            const LayerNames& layers,
                                            const LayerNames& renderingLayers);

} // namespace limn
