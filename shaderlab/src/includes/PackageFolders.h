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
    /// @param project     the folder that holds `Assets` or `Packages`, if there is one
    PackageFolders(std::filesystem::path shaderFile, std::optional<std::filesystem::path> project);

    /// The package that the shader is part of, and those in the project's `Packages`: what its
    /// author may have changed. Null where none is called so. Folders are listed on the first call.
    const std::filesystem::path* FindOwn(const std::string& name);
    /// Those, and as they come from Unity: in the project's `Library/PackageCache`, and beside a
    /// render pipeline's package that the shader is part of.
    const std::filesystem::path* Find(const std::string& name);
    /// The folder of the package that the shader is part of; "" where it is part of none.
    const std::filesystem::path& around();
    /// Whether one of the render pipelines' packages is the project's own, so that all of them are
    /// to be taken from where the project has them.
    bool hasOwnPipeline();

    /// The package.json files that were read.
    const std::vector<std::filesystem::path>& manifests() const { return m_Manifests; }

private:
    using Folders = std::map<std::string, std::filesystem::path>; ///< by package name

    void ListOwn();
    void ListCached();
    void AddBelow(const std::filesystem::path& parent, Folders& folders);
    /// Whether it is a package. The first of a name stays.
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

/// The names of the folders in a project's `Packages`, for keys: which of them there are.
std::string OwnPackageNames(const std::filesystem::path& project);

} // namespace limn
