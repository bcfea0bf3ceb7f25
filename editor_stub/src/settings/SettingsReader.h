#pragma once

#include "settings/ReadLayers.h"

#include <functional>
#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/ShaderSource.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

/// A shader from what stands for it in a file; null, with an error, if there is none.
using ShaderReader =
    std::function<std::shared_ptr<const Shader>(const YamlNode& node, const std::string& subject)>;

/// The same for a material.
using MaterialReader = std::function<std::shared_ptr<const Material>(const YamlNode& node,
                                                                     const std::string& subject)>;

/// What the settings of a file may refer to.
struct SettingsContext
{
    const LayerNames& layers;
    const LayerNames& renderingLayers;
    ShaderReader readShader;
    MaterialReader readMaterial;
    /// The feature's class where the file is Unity's: keys that the class does not have are then
    /// left out with a note. "" in files of limn's own, where they are errors.
    std::string unityType = {};
};

/// Sets a feature's settings, and in files of limn's own its `active`, to what a map says; settings
/// that it does not name stay. A map within it whose name Describe does not know, but whose keys
/// it knows, is a settings class that Describe left out: its keys are read as if they stood beside
/// it. Every other key that nobody asked for is an error with the nearest name, or a note.
void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SettingsContext& context, AssetDiagnostics& diagnostics);

/// Settings that are good one by one may not fit each other: better said where they stand than when
/// the feature is used. An error at `location` if it cannot be created.
/// @param shaders  where its Create finds shaders by name
/// @param subject  stands before what the feature says, which begins with its name
void TryCreate(ScriptableRendererFeature& feature, const std::shared_ptr<ShaderSource>& shaders,
               SourceLocation location, std::string_view subject, AssetDiagnostics& diagnostics);

} // namespace limn
