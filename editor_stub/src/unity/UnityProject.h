#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Returns the nearest folder above a file that has the folders Assets and ProjectSettings, since
/// Assets may have a folder Assets within. If there is none, it returns the nearest with Assets
/// alone. Repositories often hold only what lies in Assets, or a package: above a file with a .meta
/// file it then returns the first folder without one, if all that lie between have theirs. Returns
/// "" for other files.
std::filesystem::path UnityProjectAround(const std::filesystem::path& file);

/// Returns whether Unity passes over files and folders of this name.
bool IsPassedOver(std::string_view name);

/// The files of the Unity project around an asset, by guid.
class UnityProject
{
public:
    /// Finds the project around `asset`. If there is none, this is empty. If `asset` is relative to
    /// the current folder, so are the paths that this returns.
    /// @param cacheFolder  caches the guids; empty = nothing is cached
    explicit UnityProject(const std::filesystem::path& asset,
                          const std::filesystem::path& cacheFolder = {});

    /// Returns the path that the .meta file with a guid belongs to, even if there is no such file,
    /// or null if no .meta file that was read has the guid.
    const std::filesystem::path* Find(std::string_view guid) const;

    /// Returns the files of this name, of those that have a guid, by their paths.
    std::map<std::filesystem::path, std::string> FindByName(std::string_view filename) const;

    /// Returns the project's files that end in this, ".shader", in whatever case.
    std::vector<std::filesystem::path> FilesOf(std::string_view extension) const;

    /// Returns the project's folder, or "" if there is none. See UnityProjectAround.
    const std::filesystem::path& root() const { return m_Root; }

private:
    void NameFrom(const std::filesystem::path& folder);

    std::filesystem::path m_Root;
    std::map<std::string, std::filesystem::path, std::less<>> m_Files;
};

/// Returns the class of the script with a guid: one of URP's own, or that of the .cs file in the
/// project, which has the class's name. Returns "" if there is none.
std::string UnityScriptClass(const std::string& guid, const UnityProject& project);

} // namespace limn
