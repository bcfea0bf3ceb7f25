#include "includes/IncludeResolver.h"

#include <limn/base/Text.h>

#include <limn/base/EmbeddedFile.h>
#include <limn/base/Lists.h>
#include <limn/base/ReadFile.h>

#include <algorithm>
#include <unordered_map>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> ShaderLibrary();
}

namespace
{

constexpr const char* k_VersionFile = "limn/ProjectVersion.hlsl";
constexpr int k_OwnUniversalVersion = 14; // of the built-in library, as its Version.hlsl has it

const EmbeddedFile* FindEmbedded(std::string_view path)
{
    static const auto s_Files = []
    {
        std::unordered_map<std::string, const EmbeddedFile*> files;
        for (const EmbeddedFile& file : embedded::ShaderLibrary())
        {
            files[ToLower(file.path)] = &file;
        }
        return files;
    }();
    const auto found = s_Files.find(ToLower(path));
    return found == s_Files.end() ? nullptr : found->second;
}

/// Returns whether the built-in library has files below the folder.
bool isInLibrary(std::string_view folder)
{
    return std::ranges::any_of(
        embedded::ShaderLibrary(),
        [&](std::string_view path)
        { return EqualsIgnoringCase(path.substr(0, folder.size()), folder); },
        &EmbeddedFile::path);
}

/// The path with each part spelt as the disk has it, where one differs in case only.
std::optional<std::filesystem::path> FindIgnoringCase(const std::filesystem::path& path)
{
    std::filesystem::path found;
    for (const std::filesystem::path& part : path)
    {
        std::error_code error;
        if (std::filesystem::exists(found / part, error))
        {
            found /= part;
            continue;
        }
        std::string match;
        const std::filesystem::path folder = found.empty() ? "." : found;
        for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error))
        {
            const std::string name = entry->path().filename().string();
            const bool isMatch = EqualsIgnoringCase(name, part.string());
            match = isMatch && (match.empty() || name < match) ? name : match;
        }
        if (match.empty())
        {
            return std::nullopt;
        }
        found /= match;
    }
    return found;
}

/// The folder that holds the `Assets` or `Packages` folder, or the `Library/PackageCache`, that the
/// file lies in.
std::optional<std::filesystem::path> UnityProjectOf(const std::filesystem::path& file)
{
    std::filesystem::path folder;
    for (const std::filesystem::path& part : file)
    {
        if (part == "Assets" || part == "Packages")
        {
            return folder;
        }
        if (part == "PackageCache" && folder.filename() == "Library")
        {
            return folder.parent_path();
        }
        folder /= part;
    }
    return std::nullopt;
}

/// Returns where the shader lies, or "" if it lies nowhere: built-in ones have a name only, which
/// is in no project, whatever the working directory is.
std::filesystem::path PlaceOf(const std::string& shaderFile)
{
    std::error_code error;
    const bool isOnDisk = std::filesystem::path(shaderFile).is_absolute() ||
                          std::filesystem::exists(shaderFile, error);
    return isOnDisk ? std::filesystem::absolute(shaderFile) : std::filesystem::path();
}

std::optional<std::filesystem::path> ProjectOf(const ShaderCompilerOptions& options,
                                               const std::string& shaderFile)
{
    const auto project = UnityProjectOf(PlaceOf(shaderFile));
    return project || options.projectRoot.empty() ? project : options.projectRoot;
}

bool isAbsolute(std::string_view path)
{
    const bool hasDrive = path.size() > 1 && isLetter(path[0]) && path[1] == ':';
    return hasDrive || path.starts_with("/");
}

} // namespace

std::uint64_t HashFile(const std::string& path)
{
    const FileContent content = TryReadFile(path);
    return content.isRead() ? HashContent(content.bytes) : 0;
}

std::string PackagesAround(const ShaderCompilerOptions& options, const std::string& shaderFile)
{
    const auto project = ProjectOf(options, shaderFile);
    return project ? OwnPackageNames(*project) : std::string();
}

std::uint64_t HashLibrary()
{
    static const std::uint64_t hash = []
    {
        std::string all;
        for (const EmbeddedFile& file : embedded::ShaderLibrary())
        {
            all.append(file.path).append(1, '\0').append(file.text).append(1, '\0');
        }
        return HashContent(all);
    }();
    return hash;
}

std::string ReasonNotIncluded(std::string_view name, std::string_view refusal)
{
    const std::string quoted = "\"" + std::string(name) + "\"";
    return refusal.empty() ? "there is no file " + quoted +
                                 "; limn looks for it beside this file, in the project, its "
                                 "packages and the built-in ShaderLibrary"
                           : quoted + " is " + std::string(refusal);
}

IncludeResolver::IncludeResolver(const ShaderCompilerOptions& options,
                                 const std::string& shaderFile)
    : m_Options(options),
      m_UnityProject(UnityProjectOf(PlaceOf(shaderFile))),
      m_Packages(PlaceOf(shaderFile), ProjectOf(options, shaderFile))
{
    m_ShaderFolder = std::filesystem::path(shaderFile).parent_path();
    m_FilesBeside = FilesBesideShader(shaderFile);
    const std::filesystem::path file = std::filesystem::absolute(shaderFile);
    for (const std::filesystem::path& folder : options.includeFolders)
    {
        m_Roots.Add(folder);
    }
    if (!options.projectRoot.empty()) // "" would be the working directory, whose it may be
    {
        m_Roots.Add(options.projectRoot);
    }
    m_Roots.Add(file.parent_path());
    if (m_UnityProject)
    {
        m_Roots.Add(*m_UnityProject);
    }
    for (const auto& [name, folder] : options.packages)
    {
        m_Roots.Add(folder);
    }
}

std::optional<IncludedFile> IncludeResolver::Find(std::string_view include,
                                                  std::string_view includer)
{
    m_Refusal.clear();
    std::string path(include.substr(0, include.find('\0')));
    std::ranges::replace(path, '\\', '/');
    if (path.size() > 1 && path[0] == '/' && path[1] != '/')
    {
        if (auto file = Find(path.substr(1), {})) // from the project's folder
        {
            return file;
        }
    }
    if (isAbsolute(path))
    {
        m_Refusal = "an absolute path; write the path from this file or from the project's folder";
        return std::nullopt;
    }
    if (path == k_VersionFile)
    {
        return MakeVersionFile();
    }
    if (const IncludedFile* file = FindBeside(path, includer))
    {
        return *file;
    }
    const std::filesystem::path folder = std::filesystem::path(std::string(includer)).parent_path();
    const std::string beside = (folder / path).lexically_normal().generic_string();
    const EmbeddedFile* embedded = FindEmbedded(includer) ? FindEmbedded(beside) : nullptr;
    if (embedded)
    {
        return IncludedFile{std::string(embedded->path), std::string(embedded->text), true};
    }
    const auto candidates = Candidates(path, std::string(includer));
    for (const std::filesystem::path& candidate : candidates)
    {
        if (auto file = ReadFromDisk(candidate))
        {
            return file;
        }
    }
    if (auto file = FindInPackage(path))
    {
        return file;
    }
    for (const std::string& name : {path, "CGIncludes/" + path})
    {
        if (const EmbeddedFile* file = FindEmbedded(name))
        {
            return IncludedFile{std::string(file->path), std::string(file->text), true};
        }
    }
    // Last, because it lists folders.
    for (const std::filesystem::path& candidate : candidates)
    {
        const auto spelt = FindIgnoringCase(candidate);
        if (auto file = spelt ? ReadFromDisk(*spelt) : std::nullopt)
        {
            return file;
        }
    }
    return std::nullopt;
}

const IncludedFile* IncludeResolver::FindBeside(const std::string& include,
                                                std::string_view includer) const
{
    const std::filesystem::path folder = std::filesystem::path(std::string(includer)).parent_path();
    for (const std::filesystem::path& from : {folder, m_ShaderFolder})
    {
        const std::string name = (from / include).lexically_normal().generic_string();
        if (const IncludedFile* file = FindFileBeside(m_FilesBeside, name))
        {
            return file;
        }
    }
    return FindFileOfProject(m_FilesBeside, include);
}

/// `Packages/name/…` of a package that the project brings along. What the built-in library stands
/// in for is not taken from the project's cache, unless the project has pipelines of its own: limn
/// feeds the values that its own files name.
std::optional<IncludedFile> IncludeResolver::FindInPackage(std::string_view include)
{
    constexpr std::string_view k_Packages = "Packages/";
    const std::size_t end = std::min(include.find('/', k_Packages.size()), include.size());
    if (!include.starts_with(k_Packages) || end == include.size())
    {
        return std::nullopt;
    }
    const std::string name(include.substr(k_Packages.size(), end - k_Packages.size()));
    const bool isOwnOnly = isInLibrary(include.substr(0, end + 1)) && !m_Packages.hasOwnPipeline();
    const std::filesystem::path* folder =
        isOwnOnly ? m_Packages.FindOwn(name) : m_Packages.Find(name);
    TakeManifests();
    if (!folder)
    {
        return std::nullopt;
    }
    m_Roots.Add(*folder);
    return ReadFromDisk((*folder / include.substr(end + 1)).lexically_normal());
}

IncludedFile IncludeResolver::MakeVersionFile()
{
    const int version = m_Packages.universalVersion().value_or(k_OwnUniversalVersion);
    TakeManifests();
    const std::string text = "#define limn_UNIVERSAL_VERSION " + std::to_string(version) + "\n";
    return {k_VersionFile, text, true};
}

bool IncludeResolver::isInOwnPackage(const std::filesystem::path& path)
{
    const std::filesystem::path& package = m_Packages.around();
    TakeManifests();
    if (!package.empty())
    {
        m_Roots.Add(package);
    }
    return m_Roots.Contains(path);
}

/// Adds the manifests of packages to the dependencies, because their names decide which files are
/// included.
void IncludeResolver::TakeManifests()
{
    for (; m_ManifestsTaken < m_Packages.manifests().size(); ++m_ManifestsTaken)
    {
        const std::filesystem::path& manifest = m_Packages.manifests()[m_ManifestsTaken];
        AddDependency({manifest.generic_string(), HashFile(manifest.string())});
    }
}

void IncludeResolver::AddDependency(const IncludeDependency& dependency)
{
    AddOnce(dependency, m_Dependencies);
}

std::optional<IncludedFile> IncludeResolver::Reread(const std::string& name)
{
    if (name == k_VersionFile)
    {
        return MakeVersionFile();
    }
    if (const IncludedFile* file = FindFileBeside(m_FilesBeside, name))
    {
        return *file;
    }
    const EmbeddedFile* embedded = FindEmbedded(name);
    return embedded ? IncludedFile{name, std::string(embedded->text), true} : ReadFromDisk(name);
}

std::vector<std::filesystem::path> IncludeResolver::Candidates(const std::string& include,
                                                               const std::string& includer) const
{
    std::vector<std::filesystem::path> candidates;
    if (!FindEmbedded(includer))
    {
        candidates.push_back(std::filesystem::path(includer).parent_path() / include);
    }
    if (include.starts_with("Packages/"))
    {
        const std::size_t nameStart = std::string_view("Packages/").size();
        const std::size_t nameEnd = std::min(include.find('/', nameStart), include.size());
        const auto package =
            m_Options.packages.find(include.substr(nameStart, nameEnd - nameStart));
        if (package != m_Options.packages.end() && nameEnd < include.size())
        {
            candidates.push_back(package->second / include.substr(nameEnd + 1));
        }
    }
    candidates.push_back(m_ShaderFolder / include); // Unity's compiler looks there as well
    if (!m_Options.projectRoot.empty())
    {
        candidates.push_back(m_Options.projectRoot / include);
    }
    if (m_UnityProject)
    {
        candidates.push_back(*m_UnityProject / include);
    }
    for (std::filesystem::path& candidate : candidates)
    {
        candidate = candidate.lexically_normal();
    }
    return candidates;
}

std::optional<IncludedFile> IncludeResolver::ReadFromDisk(const std::filesystem::path& path)
{
    const std::string name = path.generic_string();
    std::error_code error;
    std::optional<std::string> text;
    if (std::filesystem::is_regular_file(path, error))
    {
        if (!m_Roots.Contains(path) && !isInOwnPackage(path))
        {
            m_Refusal = "outside the folders that includes may lie in; move it into the "
                        "project, or name its folder by --root DIR";
        }
        else if (std::filesystem::file_size(path, error) > k_MaxTextBytes)
        {
            m_Refusal = "larger than 64 MB; split it";
        }
        else if (FileContent content = TryReadFile(path); content.isRead())
        {
            text = std::move(content.bytes);
        }
    }
    AddDependency({name, text ? HashContent(*text) : 0});
    if (!text)
    {
        return std::nullopt;
    }
    m_Refusal.clear();
    return IncludedFile{name, std::move(*text)};
}

} // namespace limn
