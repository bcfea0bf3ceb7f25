#pragma once

#include <limn/base/WordList.h>
#include <string_view>

namespace limn
{

/// Whether every MonoBehaviour of a Unity asset has this field; what is left are the fields of its
/// class. (2022.3)
inline bool isUnityHeaderField(std::string_view name)
{
    static const WordList s_Fields(
        "m_ObjectHideFlags m_CorrespondingSourceObject m_PrefabInstance m_PrefabAsset "
        "m_GameObject m_Enabled m_EditorHideFlags m_Script m_Name m_EditorClassIdentifier");
    return s_Fields.Has(name);
}

} // namespace limn
