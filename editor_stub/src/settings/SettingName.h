#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A setting or a group of settings as a feature's Describe names it, without its value.
struct SettingName
{
    std::string name;
    bool isGroup = false;
    std::vector<SettingName> members = {}; ///< of a group, in the order of Describe
};

/// The settings of a feature: a group without a name.
SettingName DescribedSettings(ScriptableRendererFeature& feature);

/// The member of a group that a key of a file stands for, in Unity's or the plain spelling; null if
/// the group has none.
const SettingName* FindMember(const SettingName& group, std::string_view key);

/// The paths of everything below `root` that is no member of `group` itself: "settings.width".
std::vector<std::string> PathsOutside(const SettingName& root, const SettingName& group);

} // namespace limn
