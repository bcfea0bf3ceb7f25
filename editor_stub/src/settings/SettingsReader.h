#pragma once

#include "assets/References.h"
#include "settings/ReadValues.h"

#include <deque>
#include <functional>
#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/ShaderSource.h>
#include <limn/volume/YamlMapReader.h>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Returns the asset that a node of a file stands for. Returns null and adds an error or a note if
/// there is none.
template <typename Asset>
using AssetReader =
    std::function<std::shared_ptr<const Asset>(const YamlNode& node, const std::string& subject)>;

/// A reader for each type of asset that a setting may be. Without one, all assets are null.
struct AssetReaders
{
    AssetReader<Shader> shader = {};
    AssetReader<Material> material = {};
    AssetReader<Texture> texture = {};
    AssetReader<ComputeShader> computeShader = {};
};

/// Returns readers of all assets that a setting names by a path: all but materials.
AssetReaders ReadersOfFiles(References& references);

/// The things that the settings of a file may refer to.
struct SettingsContext
{
    const LayerNames& layers;
    const LayerNames& renderingLayers;
    AssetReaders assets = {};
    /// The feature's class if the file is Unity's: keys that the class does not have are then left
    /// out with a note. "" in files of limn's own, where such keys are errors.
    std::string unityType = {};
};

/// Sets a feature's settings, and in files of limn's own its `active`, to the values of a map.
/// Settings that the map does not name stay. A map within it whose name Describe does not know, but
/// whose keys it knows, is a settings class that Describe left out: its keys are read as if they
/// were beside it. Every other key that nothing has read is an error with the nearest name, or a
/// note.
void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SettingsContext& context, AssetDiagnostics& diagnostics);

/// Adds an error at `location` if the feature cannot be created. Settings that are good one by one
/// may not fit each other; it is better to report that where the settings are than when the feature
/// is used.
/// @param shaders  the source in which the feature's Create finds shaders by name
/// @param subject  the text before the feature's message, which begins with the feature's name
void TryCreate(ScriptableRendererFeature& feature, const std::shared_ptr<ShaderSource>& shaders,
               SourceLocation location, std::string_view subject, AssetDiagnostics& diagnostics);

/// A setting or a group of settings as a feature's Describe names it, without its value.
struct SettingName
{
    std::string name;
    std::vector<SettingName> members = {}; ///< the members of a group, in the order of Describe
};

/// Returns the settings of a feature as a group without a name.
SettingName DescribedSettings(ScriptableRendererFeature& feature);

/// Returns the member of a group that a key of a file stands for, in Unity's or the plain spelling,
/// or null if the group has none.
const SettingName* FindMember(const SettingName& group, std::string_view key);

/// The maps of a file that hold the settings of one group: the group's own, and the settings
/// classes within it that Describe left out.
class SettingsLevel
{
public:
    /// @param unityType  as SettingsContext::unityType
    SettingsLevel(const SettingName& group, std::string unityType, AssetDiagnostics& diagnostics);
    SettingsLevel(const SettingsLevel&) = delete;
    SettingsLevel& operator=(const SettingsLevel&) = delete;

    /// Adds a map that the caller holds, with the settings classes in it.
    void Add(YamlMapReader& map);
    /// Adds the map that is the value of the group's key in `outer`.
    void Add(const YamlNode& node, const YamlMapReader& outer);

    /// Returns the map that has the setting, or null if none has it. A second map that has it is an
    /// error, or a note.
    YamlMapReader* Find(std::string_view name);

    /// Reports every key that nothing has read.
    /// @param root  the whole feature's settings, for the nearest name
    void Finish(const SettingName& root);

    const SettingName& group() const { return m_Group; }
    const YamlMapReader& map() const { return *m_Maps.front(); } ///< the map of the group itself

private:
    void ReportTwice(std::string_view name, const YamlMapReader& first,
                     const YamlMapReader& second);
    void NoteUnknown(const YamlMapReader& map);

    const SettingName& m_Group;
    std::string m_UnityType;
    AssetDiagnostics& m_Diagnostics;
    std::deque<YamlMapReader> m_Own;
    std::vector<YamlMapReader*> m_Maps;
};

} // namespace limn
