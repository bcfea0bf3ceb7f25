#include "includes/PackageFolders.h"

#include <limn/base/ReadFile.h>
#include <limn/shaderlab/FindPackages.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

namespace limn
{

namespace
{

constexpr std::string_view k_PipelinePackages = "com.unity.render-pipelines.";
constexpr std::string_view k_Universal = "com.unity.render-pipelines.universal";

/// Returns the folders in the order of their names.
std::vector<std::filesystem::path> FoldersBelow(const std::filesystem::path& parent)
{
    std::error_code error;
    std::vector<std::filesystem::path> folders;
    for (std::filesystem::directory_iterator entry(parent, error), end; !error && entry != end;
         entry.increment(error))
    {
        folders.push_back(entry->path());
    }
    std::ranges::sort(folders);
    return folders;
}

/// Returns the text of that key, or "" if `json` is no object or has no such text.
std::string TextIn(const nlohmann::json& json, std::string_view key)
{
    const auto found = json.is_object() ? json.find(key) : json.end();
    const bool isText = json.is_object() && found != json.end() && found->is_string();
    return isText ? found->get<std::string>() : std::string();
}

/// The name in a package.json; "" if there is no such file, or it has none.
std::string NameIn(const std::filesystem::path& manifest)
{
    const auto json = nlohmann::json::parse(TryReadFile(manifest).bytes, nullptr, false);
    return TextIn(json, "name");
}

} // namespace

std::map<std::string, std::filesystem::path> FindPackages(const std::filesystem::path& folder)
{
    std::map<std::string, std::filesystem::path> packages;
    const auto add = [&](const std::filesystem::path& candidate)
    {
        const std::string name = NameIn(candidate / "package.json");
        if (!name.empty())
        {
            packages.try_emplace(name, candidate);
        }
    };
    add(folder);
    if (packages.empty())
    {
        std::ranges::for_each(FoldersBelow(folder), add);
    }
    return packages;
}

std::optional<int> MajorVersionAskedFor(const std::filesystem::path& manifest,
                                        std::string_view package)
{
    const auto json = nlohmann::json::parse(TryReadFile(manifest).bytes, nullptr, false);
    const bool hasAny = json.is_object() && json.contains("dependencies");
    const std::string text = hasAny ? TextIn(json["dependencies"], package) : std::string();
    const char* const end = text.data() + text.size();
    int version = 0;
    const auto [rest, error] = std::from_chars(text.data(), end, version);
    const bool isVersion = error == std::errc{} && rest != end && *rest == '.';
    return isVersion ? std::optional(version) : std::nullopt;
}

std::string OwnPackageNames(const std::filesystem::path& project)
{
    std::string names;
    for (const std::filesystem::path& folder : FoldersBelow(project / "Packages"))
    {
        names += folder.filename().string() + "/";
    }
    return names;
}

PackageFolders::PackageFolders(std::filesystem::path shaderFile,
                               std::optional<std::filesystem::path> project)
    : m_ShaderFile(std::move(shaderFile)), m_Project(std::move(project))
{
}

const std::filesystem::path& PackageFolders::around()
{
    if (!std::exchange(m_IsOwnListed, true))
    {
        ListOwn();
    }
    return m_Around;
}

const std::filesystem::path* PackageFolders::FindOwn(const std::string& name)
{
    around(); // lists them
    const auto found = m_Own.find(name);
    return found == m_Own.end() ? nullptr : &found->second;
}

const std::filesystem::path* PackageFolders::Find(const std::string& name)
{
    if (const std::filesystem::path* own = FindOwn(name))
    {
        return own;
    }
    if (!std::exchange(m_IsCachedListed, true))
    {
        ListCached();
    }
    const auto found = m_Cached.find(name);
    return found == m_Cached.end() ? nullptr : &found->second;
}

bool PackageFolders::hasOwnPipeline()
{
    return FindOwn(std::string(k_PipelinePackages) + "core") || FindOwn(std::string(k_Universal));
}

std::optional<int> PackageFolders::universalVersion()
{
    if (m_Project)
    {
        m_Manifests.push_back(*m_Project / "Packages/manifest.json");
        if (const auto version = MajorVersionAskedFor(m_Manifests.back(), k_Universal))
        {
            return version;
        }
    }
    const bool isInPackage = !around().empty();
    return isInPackage ? MajorVersionAskedFor(m_Around / "package.json", k_Universal)
                       : std::nullopt;
}

void PackageFolders::ListOwn()
{
    // The nearest wins.
    for (std::filesystem::path folder = m_ShaderFile.parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
    {
        // Unity's names are com.company.package; npm's, of a folder that holds everything, are not.
        const bool isNamed =
            Add(folder, m_Own) && std::ranges::count(NameIn(folder / "package.json"), '.') > 1;
        if (isNamed && m_Around.empty())
        {
            m_Around = folder;
        }
    }
    if (m_Project)
    {
        AddBelow(*m_Project / "Packages", m_Own);
    }
}

void PackageFolders::ListCached()
{
    if (!m_Around.empty() && NameIn(m_Around / "package.json").starts_with(k_PipelinePackages))
    {
        AddBelow(m_Around.parent_path(), m_Cached);
    }
    if (m_Project)
    {
        AddBelow(*m_Project / "Library/PackageCache", m_Cached);
    }
}

void PackageFolders::AddBelow(const std::filesystem::path& parent, Folders& folders)
{
    for (const std::filesystem::path& folder : FoldersBelow(parent))
    {
        Add(folder, folders);
    }
}

bool PackageFolders::Add(const std::filesystem::path& folder, Folders& folders)
{
    const std::filesystem::path manifest = folder / "package.json";
    std::error_code error;
    if (!std::filesystem::is_regular_file(manifest, error))
    {
        return false;
    }
    m_Manifests.push_back(manifest);
    const std::string name = NameIn(manifest);
    if (!name.empty())
    {
        folders.try_emplace(name, folder);
    }
    return !name.empty();
}

} // namespace limn
