#pragma once

#include "includes/FilesBeside.h"
#include "includes/PackageFolders.h"

#include <limn/base/FileRoots.h>
#include <limn/base/HashContent.h>
#include <limn/shaderlab/ShaderCompiler.h>

#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// A file on disk that a compilation looked for; the compilation's result is valid while all of
/// these files stay as they are.
struct IncludeDependency
{
    std::string path;
    std::uint64_t contentHash = 0; ///< 0 = the file does not exist

    bool operator==(const IncludeDependency&) const = default;
};

/// Returns the content hash of the file at `path` as it is now, or 0 if there is none.
std::uint64_t HashFile(const std::string& path);

/// Returns the names of the folders in the `Packages` of the project around a shader. If they
/// change, includes may be found elsewhere.
std::string PackagesAround(const ShaderCompilerOptions& options, const std::string& shaderFile);

/// Returns the content hash of the whole built-in ShaderLibrary.
std::uint64_t HashLibrary();

/// Returns why a file is not included, for a message: the text of refusal(), or that there is no
/// such file.
std::string ReasonNotIncluded(std::string_view name, std::string_view refusal);

/// Finds included files like Unity: among the files that a program holds beside a shader of its
/// own, beside the including file, beside the .shader file, from the project root and its packages,
/// from the Unity project around the shader and the packages in it, and in the built-in library.
/// "limn/ProjectVersion.hlsl" is made for each shader: it defines limn_UNIVERSAL_VERSION as the
/// major version of URP that the shader's project or package asks for, or as the built-in library's
/// own. Names may differ in case. One resolver serves one compilation.
class IncludeResolver
{
public:
    /// @param shaderFile  the .shader file that the compilation is for
    IncludeResolver(const ShaderCompilerOptions& options, const std::string& shaderFile);

    /// Returns the file, or nullopt if there is no such file or it may not be read; refusal() says
    /// which.
    std::optional<IncludedFile> Find(std::string_view include, std::string_view includer);

    /// Returns a file that Find returned, by its name.
    std::optional<IncludedFile> Reread(const std::string& name);

    /// Returns why the last Find returned nullopt: "subject; what would be right", or "" if there
    /// is no such file.
    const std::string& refusal() const { return m_Refusal; }

    const std::vector<IncludeDependency>& dependencies() const { return m_Dependencies; }

    const FilesBeside& filesBeside() const { return m_FilesBeside; }
    /// Sets the files beside the shader in a process that does not know them.
    void SetFilesBeside(FilesBeside files) { m_FilesBeside = std::move(files); }

    /// Takes over the dependencies that another resolver found for the same shader.
    void SetDependencies(std::vector<IncludeDependency> dependencies)
    {
        m_Dependencies = std::move(dependencies);
    }

private:
    std::vector<std::filesystem::path> Candidates(const std::string& include,
                                                  const std::string& includer) const;
    std::optional<IncludedFile> ReadFromDisk(const std::filesystem::path& path);
    std::optional<IncludedFile> FindInPackage(std::string_view include);
    IncludedFile MakeVersionFile();
    /// Returns whether the file lies in the package that the shader is part of.
    bool isInOwnPackage(const std::filesystem::path& path);
    void TakeManifests();
    const IncludedFile* FindBeside(const std::string& include, std::string_view includer) const;
    void AddDependency(const IncludeDependency& dependency);

    const ShaderCompilerOptions& m_Options;
    std::filesystem::path m_ShaderFolder;
    FilesBeside m_FilesBeside;
    FileRoots m_Roots;
    std::optional<std::filesystem::path> m_UnityProject; ///< the folder that holds `Assets`
    PackageFolders m_Packages;
    std::size_t m_ManifestsTaken = 0; ///< the number of m_Packages' manifests that are dependencies
    std::vector<IncludeDependency> m_Dependencies;
    std::string m_Refusal;
};

} // namespace limn
