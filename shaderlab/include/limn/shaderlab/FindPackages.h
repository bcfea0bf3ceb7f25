#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// Returns the folders of Unity packages by the names in their package.json, whatever the names of
/// the folders are. These are the folder itself if it is a package, or otherwise those directly
/// below it, as in Library/PackageCache.
std::map<std::string, std::filesystem::path> FindPackages(const std::filesystem::path& folder);

/// Returns the major version of a package that a Unity project's Packages/manifest.json, or a
/// package's package.json, asks for among its `dependencies`: 14 for "14.0.11". Returns nothing if
/// the file cannot be read or names no such package, or if it names a folder or a repository in
/// place of a version.
std::optional<int> MajorVersionAskedFor(const std::filesystem::path& manifest,
                                        std::string_view package);

} // namespace limn
