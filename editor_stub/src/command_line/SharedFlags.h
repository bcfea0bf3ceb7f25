#pragma once

#include "command_line/Candidates.h"
#include "command_line/FlagTable.h"
#include "command_line/Values.h"

#include <map>

namespace limn
{

// Flags and arguments that several verbs have. They store into what they are given, which must
// outlive them.

using GetCandidates = decltype(Flag::candidates);

GetCandidates Files(std::vector<std::string> endings); ///< offers files with these endings
/// Offers files with these endings, and names that are no files'.
GetCandidates FilesOr(std::vector<std::string> endings, Candidates (*names)());

Flag Argument(const char* value, const char* help, StoreValue store, Times times = Times::Once,
              GetCandidates candidates = {});
Flag Switch(const char* name, const char* help, bool& isGiven, char letter = '\0');

Flag SceneArgument(std::string& scene);
Flag SceneFlag(RenderOptions& options);
Flag SizeFlag(RenderOptions& options);
Flag ProfileFlag(std::string& profile);
Flag SetFlag(RenderOptions& options);
Flag SelectFlag(RenderOptions& options);
Flag DeviceFlag(std::string& device);
Flag PluginFlag(std::vector<std::string>& plugins);
Flag PackageFlag(std::map<std::string, std::string>& packages);
Flag RootFlag(std::vector<std::string>& roots);
Flag NewFolderFlag(std::string& folder);

} // namespace limn
