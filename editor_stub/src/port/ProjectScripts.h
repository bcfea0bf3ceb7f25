#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

struct ProjectScript
{
    std::filesystem::path path; ///< from the root of the file system
    std::string text;
};

/// The C# files of the Unity project around a file, or else of its folder. A render feature often
/// has its passes, volume components and helpers in other folders.
class ProjectScripts
{
public:
    /// Reads them. UnityProjectAround tells the project.
    explicit ProjectScripts(const std::filesystem::path& file);

    /// Returns the files that declare a class, struct or enum of this name: first those that are
    /// named like it, then the nearest to `file`.
    std::vector<const ProjectScript*> FindDeclarations(std::string_view name) const;

private:
    void AddFolder(const std::filesystem::path& folder);
    void AddScript(const std::filesystem::path& path);

    std::filesystem::path m_File;
    std::vector<ProjectScript> m_Scripts;
};

} // namespace limn
