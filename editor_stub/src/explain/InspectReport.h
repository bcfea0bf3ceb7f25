#pragma once

#include "console/Console.h"
#include "settings/SettingsCollector.h"

#include <limn/editor_stub/AssetContext.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/UnityAsset.h>

namespace limn
{

/// A component, a feature, or a Unity asset.
struct InspectedGroup
{
    std::string type;
    std::string name; ///< "" for a component
    bool active = true;
    std::vector<InspectedValue> values;
};

/// A profile, and the volume that brings it.
struct InspectedVolume
{
    /// "" for a profile that was asked for by itself; the other members then have no meaning.
    std::string name;
    bool enabled = true;
    bool isGlobal = true;
    float priority = 0.0f;
    float weight = 1.0f;
    float blendDistance = 0.0f; ///< in metres
    std::string profile;
    std::vector<InspectedGroup> components;
};

/// The values that a file sets.
struct InspectReport
{
    /// The kind of the file: "scene", "profile", "renderer", "pipeline" or "material"; "name" if it
    /// is no file.
    std::string kind;
    std::optional<InspectedGroup> asset; ///< the values of a renderer, pipeline or material
    std::vector<InspectedVolume> volumes;
    std::vector<InspectedGroup> features;
    std::vector<InspectedGroup> shaders;
};

/// Returns the defaults of the volume component, the feature type and the shader of this name, as
/// far as they exist. `Strokes` finds what `StrokesRendererFeature` finds.
/// @throws AssetError with the nearest name, if there is none of them
InspectReport InspectName(const std::string& name, AssetContext& assets);

/// Returns every name that InspectName finds.
std::vector<std::string> KnownNames(const AssetContext& assets);

std::vector<InspectedGroup> InspectProfile(const VolumeProfile& profile,
                                           const VolumeComponentRegistry& registry);
std::vector<InspectedGroup> InspectFeatures(const RendererAsset& renderer,
                                            const FeatureRegistry& registry,
                                            const LayerNames& layers,
                                            const LayerNames& renderingLayers);

std::string OnOneLine(const YamlNode& node);     ///< a value as a file could have it
std::string ToText(const InspectReport& report); ///< lines for people
std::string ToJson(const InspectReport& report);

/// Returns the values of a profile's file without a scene. Without one, any name may be a layer's:
/// a value with a name that only a scene can know is shown as the file has it, with a note.
/// @param documents  the file's documents; one Null for a Unity asset
/// @throws AssetError as LoadVolumeProfile
std::vector<InspectedGroup> InspectProfileFile(const std::filesystem::path& path,
                                               const std::vector<YamlNode>& documents,
                                               AssetContext& assets, Console& console);

/// Returns the kind of a Unity asset by its content: "profile", "renderer", "pipeline" or
/// "material".
/// @throws AssetError that names what is in the file, if it is none of these kinds
std::string KindOfUnityAsset(const UnityAsset& asset);

/// Returns the values of a UniversalRenderPipelineAsset: what limn draws with, its renderers, and
/// what limn leaves out.
InspectedGroup InspectPipeline(const UnityAsset& asset);

/// Returns the values of a UniversalRendererData besides its features.
InspectedGroup InspectRenderer(const UnityAsset& asset);

/// Returns the values of a .mat file: its shader, queue, keywords and properties, and which of them
/// the shader has.
InspectedGroup InspectMaterial(const UnityAsset& asset, AssetContext& assets);

} // namespace limn
