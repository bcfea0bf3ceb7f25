#pragma once

#include "unity/UnityProject.h"

#include <string>

namespace limn
{

/// The class of the script with a guid: one of URP's own, or that of the .cs file in the project,
/// which has the class's name. "" if there is none.
std::string UnityScriptClass(const std::string& guid, const UnityProject& project);

} // namespace limn
