#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// The folders of the packages of a Unity project, by the names in their package.json; the folders
/// may have other names.
class PackageFolders
{
public:
    /// @param shaderFile  the shader; it is part of a package if a package.json lies in a folder
    ///     above it
    /// @param project     the folder that holds `Assets` or `Packages`, if there is one
    PackageFolders(std::filesystem::path shaderFile, std::optional<std::filesystem::path> project);

    /// Returns the package of that name, if it is the one that the shader is part of or lies in the
    /// project's `Packages`: its author may have changed these. Returns null if there is none. The
    /// first call lists the folders.
    const std::filesystem::path* FindOwn(const std::string& name);
    /// Returns a package like FindOwn, or an unchanged one: in the project's
    /// `Library/PackageCache`, or beside a render pipeline's package that the shader is part of.
    const std::filesystem::path* Find(const std::string& name);
    /// Returns the folder of the package that the shader is part of, or "" if it is part of none.
    const std::filesystem::path& around();
    /// Returns whether one of the render pipelines' packages is the project's own, so that all of
    /// them must be those of the project.
    bool hasOwnPipeline();
    /// Returns the major version of URP that the project asks for, or else the package that the
    /// shader is part of; nothing if neither does.
    std::optional<int> universalVersion();

    /// Returns the manifests that were read or looked for.
    const std::vector<std::filesystem::path>& manifests() const { return m_Manifests; }

private:
    using Folders = std::map<std::string, std::filesystem::path>; ///< by package name

    void ListOwn();
    void ListCached();
    void AddBelow(const std::filesystem::path& parent, Folders& folders);
    /// Adds a folder if it is a package, and returns whether it is. The first package of a name
    /// stays.
    bool Add(const std::filesystem::path& folder, Folders& folders);

    std::filesystem::path m_ShaderFile;
    std::optional<std::filesystem::path> m_Project;
    bool m_IsOwnListed = false;
    bool m_IsCachedListed = false;
    Folders m_Own;
    Folders m_Cached;
    std::filesystem::path m_Around; ///< the folder of the package that the shader is part of
    std::vector<std::filesystem::path> m_Manifests;
};

/// Returns the names of the folders in a project's `Packages`, for keys that depend on which
/// folders exist.
std::string OwnPackageNames(const std::filesystem::path& project);

} // namespace limn
