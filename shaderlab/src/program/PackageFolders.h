#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// The folders of the packages that a Unity project brings along, by the names in their
/// package.json: folders may be called otherwise.
class PackageFolders
{
public:
    /// @param shaderFile  itself part of a package where a package.json lies in a folder above it
    /// @param project     the folder that holds `Assets` or `Packages`, if there is one: its
    ///                    `Packages` and `Library/PackageCache` are looked through
    PackageFolders(std::filesystem::path shaderFile, std::optional<std::filesystem::path> project);

    /// Null where no package is called so. Folders are listed on the first call.
    const std::filesystem::path* Find(const std::string& name);

    /// The package.json files that were read.
    const std::vector<std::filesystem::path>& manifests() const { return m_Manifests; }

private:
    void List();
    void Add(const std::filesystem::path& folder);

    std::filesystem::path m_ShaderFile;
    std::optional<std::filesystem::path> m_Project;
    bool m_IsListed = false;
    std::map<std::string, std::filesystem::path> m_Folders; ///< by package name
    std::vector<std::filesystem::path> m_Manifests;
};

} // namespace limn
