#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace limn
{

/// Returns the folders of Unity packages by the names in their package.json, whatever the names of
/// the folders are. These are the folder itself if it is a package, or otherwise those directly
/// below it, as in Library/PackageCache.
std::map<std::string, std::filesystem::path> FindPackages(const std::filesystem::path& folder);

} // namespace limn
