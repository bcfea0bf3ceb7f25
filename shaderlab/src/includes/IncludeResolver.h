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

struct IncludedFile
{
    std::string name; ///< path on disk, or virtual path of the built-in ShaderLibrary
    std::string text;
    bool isEmbedded = false; ///< of the built-in ShaderLibrary
};

/// A file on disk that a compilation looked for; its result holds while all of them stay as they
/// are.
struct IncludeDependency
{
    std::string path;
    std::uint64_t contentHash = 0; ///< 0 = the file does not exist

    bool operator==(const IncludeDependency&) const = default;
};

/// Content hash of the file at `path` as it is now, 0 where there is none.
std::uint64_t HashFile(const std::string& path);

/// The names of the folders in the `Packages` of the project that a shader lies in: where there are
/// others, includes may be found elsewhere.
std::string PackagesAround(const ShaderCompilerOptions& options, const std::string& shaderFile);

/// Content hash of the whole built-in ShaderLibrary.
std::uint64_t HashLibrary();

/// Why a file is not included, for a message: what refusal() says, or that there is no such file.
std::string ReasonNotIncluded(std::string_view name, std::string_view refusal);

/// Finds what #include names, the way Unity does: among the files that a program holds beside a
/// shader of its own; beside the including file, beside the .shader
/// file, from the project root and its packages, from the Unity project around the shader and the
/// packages in it, and in the built-in library; names may differ in case. One resolver serves one
/// compilation.
class IncludeResolver
{
public:
    /// @param shaderFile  the .shader file that the compilation is for
    IncludeResolver(const ShaderCompilerOptions& options, const std::string& shaderFile);

    /// Nothing where no such file exists or it may not be read; refusal() says which.
    std::optional<IncludedFile> Find(std::string_view include, std::string_view includer);

    /// A file that Find gave, by its name.
    std::optional<IncludedFile> Reread(const std::string& name);

    /// Why the last Find gave nothing: "subject; what would be right", or "" for no such file.
    const std::string& refusal() const { return m_Refusal; }

    const std::vector<IncludeDependency>& dependencies() const { return m_Dependencies; }

    const FilesBeside& filesBeside() const { return m_FilesBeside; }
    /// In a process that does not know them.
    void SetFilesBeside(FilesBeside files) { m_FilesBeside = std::move(files); }

    /// Takes over what another resolver looked for, for the same shader.
    void SetDependencies(std::vector<IncludeDependency> dependencies)
    {
        m_Dependencies = std::move(dependencies);
    }

private:
    std::vector<std::filesystem::path> Candidates(const std::string& include,
                                                  const std::string& includer) const;
    std::optional<IncludedFile> ReadFromDisk(const std::filesystem::path& path);
    std::optional<IncludedFile> FindInPackage(std::string_view include);
    /// Says whether the file lies in the package that the shader is part of.
    bool isInOwnPackage(const std::filesystem::path& path);
    void TakeManifests();
    const FileBeside* FindBeside(const std::string& include, std::string_view includer) const;
    void AddDependency(const IncludeDependency& dependency);

    const ShaderCompilerOptions& m_Options;
    std::filesystem::path m_ShaderFolder;
    FilesBeside m_FilesBeside;
    FileRoots m_Roots;
    std::optional<std::filesystem::path> m_UnityProject; ///< the folder that holds `Assets`
    PackageFolders m_Packages;
    std::size_t m_ManifestsTaken = 0; ///< of m_Packages, as dependencies
    std::vector<IncludeDependency> m_Dependencies;
    std::string m_Refusal;
};

} // namespace limn
