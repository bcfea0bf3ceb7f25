#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace limn
{

/// Whether every MonoBehaviour of a Unity asset has this field; what is left are the fields of its
/// class. (2022.3)
constexpr bool isUnityHeaderField(std::string_view name)
{
    constexpr std::array<std::string_view, 10> k_Fields{"m_ObjectHideFlags",
                                                        "m_CorrespondingSourceObject",
                                                        "m_PrefabInstance",
                                                        "m_PrefabAsset",
                                                        "m_GameObject",
                                                        "m_Enabled",
                                                        "m_EditorHideFlags",
                                                        "m_Script",
                                                        "m_Name",
                                                        "m_EditorClassIdentifier"};
    return std::ranges::find(k_Fields, name) != k_Fields.end();
}

} // namespace limn
