#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace limn
{

/// The folders of Unity packages by the names in their package.json, whatever the folders are
/// called: the folder itself if it is one, else those right below it, as in Library/PackageCache.
std::map<std::string, std::filesystem::path> FindPackages(const std::filesystem::path& folder);

} // namespace limn
