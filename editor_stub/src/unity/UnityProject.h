#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// The nearest folder above a file that has an Assets folder; "" if there is none.
std::filesystem::path UnityProjectAround(const std::filesystem::path& file);

class GuidIndex;

/// Which .meta files of a project are read.
enum class MetaFiles
{
    Loaded, ///< of .cs, .shader, .png and .mat files
    All
};

/// The files of the Unity project around an asset, by guid.
class UnityProject
{
public:
    /// The one around `asset`; without one it is empty.
    /// @param cacheFolder  keeps what All .meta files say; empty = nothing is kept
    explicit UnityProject(const std::filesystem::path& asset, MetaFiles files = MetaFiles::Loaded,
                          const std::filesystem::path& cacheFolder = {});

    /// The path that a .meta file belongs to, whether there is a file or not; null if no .meta file
    /// that was read has the guid.
    const std::filesystem::path* Find(std::string_view guid) const;

    /// "" if there is none.
    const std::filesystem::path& root() const { return m_Root; }

private:
    void ScanFolder(const std::filesystem::path& folder, MetaFiles files, GuidIndex& guids);

    std::filesystem::path m_Root;
    std::map<std::string, std::filesystem::path, std::less<>> m_Files;
};

/// The class of the script with a guid: one of URP's own, or that of the .cs file in the project,
/// which has the class's name. "" if there is none.
std::string UnityScriptClass(const std::string& guid, const UnityProject& project);

} // namespace limn
