#pragma once

#include "settings/SettingName.h"

#include <deque>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

/// The maps of a file that hold the settings of one group: the group's own, and the settings
/// classes within it that Describe left out.
class SettingsLevel
{
public:
    /// @param unityType  as SettingsContext's
    SettingsLevel(const SettingName& group, std::string unityType, AssetDiagnostics& diagnostics);
    SettingsLevel(const SettingsLevel&) = delete;
    SettingsLevel& operator=(const SettingsLevel&) = delete;

    /// Adds a map that the caller holds, with the settings classes in it.
    void Add(YamlMapReader& map);
    /// Adds the value of the group's key in `outer`.
    void Add(const YamlNode& node, const YamlMapReader& outer);

    /// The map that has the setting; null if none has. A second one is an error, or a note.
    YamlMapReader* Find(std::string_view name);

    /// Reports every key that nobody asked for.
    /// @param root  the whole feature's settings, for the nearest name
    void Finish(const SettingName& root);

    const SettingName& group() const { return m_Group; }
    const YamlMapReader& map() const { return *m_Maps.front(); } ///< the group's own

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
