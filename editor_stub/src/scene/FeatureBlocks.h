#pragma once

#include <limn/editor_stub/AssetContext.h>
#include <limn/volume/YamlNode.h>
#include <string>
#include <vector>

namespace limn
{

/// What a file has about one feature.
struct FeatureBlock
{
    std::string name;
    std::string type;
    std::string unityType; ///< the type in a Unity asset, as SettingsContext's; else ""
    YamlNode map;

    const char* activeKey() const { return unityType.empty() ? "active" : "m_Active"; }
};

/// The features of a scene file or of a Unity renderer asset, by their text.
struct FeatureBlocks
{
    std::vector<FeatureBlock> features; ///< those whose type is known
    std::vector<YamlNode> documents;    ///< of the whole file
    LayerNames layers;
    LayerNames renderingLayers;

    std::vector<std::string_view> names() const; ///< and types
};

/// @throws AssetError for broken YAML, and where the features are not in this file
FeatureBlocks ReadFeatureBlocks(const std::string& text, const std::string& file,
                                AssetContext& assets);

} // namespace limn
