#include "unity/UnityProject.h"

#include "unity/GuidIndex.h"

namespace limn
{

namespace
{

/// Scripts of the URP package, whose .meta files are in no project. (URP 14; the second of
/// FullScreenPassRendererFeature is of URP 13 and of samples from before.)
constexpr std::pair<std::string_view, std::string_view> k_PackageScripts[] = {
    {"6b3d386ba5cd94485973aee1479b272e", "RenderObjects"},
    {"b00045f12942b46c698459096c89274e", "FullScreenPassRendererFeature"},
    {"6d613f08f173d4dd895bb07b3230baa9", "FullScreenPassRendererFeature"},
    {"f62c9c65cf3354c93be831c8bc075510", "ScreenSpaceAmbientOcclusion"}};

/// Unity passes over these files and folders.
bool IsPassedOver(const std::string& name)
{
    return name.starts_with('.') || name.ends_with('~') || name.ends_with(".tmp") || name == "cvs";
}

bool HasMetaFile(const std::filesystem::path& path)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(path.native() + ".meta", ignored);
}

/// Returns the folder from which Unity has imported the file, or "" if it has not.
std::filesystem::path ImportedFrom(std::filesystem::path path)
{
    const bool isImported = HasMetaFile(path);
    while (HasMetaFile(path))
    {
        path = path.parent_path();
    }
    return isImported ? path : std::filesystem::path();
}

} // namespace

std::filesystem::path UnityProjectAround(const std::filesystem::path& file)
{
    std::error_code ignored;
    std::filesystem::path nearest;
    const std::filesystem::path whole = std::filesystem::absolute(file, ignored);
    std::filesystem::path above = whole;
    while (above != above.parent_path())
    {
        above = above.parent_path();
        const bool hasAssets = std::filesystem::is_directory(above / "Assets", ignored);
        if (hasAssets && std::filesystem::is_directory(above / "ProjectSettings", ignored))
        {
            return above;
        }
        nearest = hasAssets && nearest.empty() ? above : nearest;
    }
    return nearest.empty() ? ImportedFrom(whole) : nearest;
}

UnityProject::UnityProject(const std::filesystem::path& asset,
                           const std::filesystem::path& cacheFolder)
    : m_Root(UnityProjectAround(asset))
{
    if (m_Root.empty())
    {
        return;
    }
    GuidIndex guids(m_Root, cacheFolder);
    std::error_code ignored;
    if (!std::filesystem::is_directory(m_Root / "Assets", ignored))
    {
        ScanFolder(m_Root, guids);
    }
    // The rest of Library is Unity's own, and may be larger than all assets.
    for (const char* folder : {"Assets", "Packages", "Library/PackageCache"})
    {
        ScanFolder(m_Root / folder, guids);
    }
    guids.Store();
}

void UnityProject::ScanFolder(const std::filesystem::path& folder, GuidIndex& guids)
{
    std::error_code ignored;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    std::filesystem::recursive_directory_iterator entry(folder, options, ignored);
    for (; entry != std::filesystem::recursive_directory_iterator(); entry.increment(ignored))
    {
        const std::filesystem::path& path = entry->path();
        if (IsPassedOver(path.filename().string()))
        {
            entry.disable_recursion_pending();
            continue;
        }
        if (path.extension() == ".meta")
        {
            const std::filesystem::path described = path.parent_path() / path.stem();
            const std::string guid = guids.GuidOf(*entry);
            const auto [known, isNew] = m_Files.emplace(guid, described);
            if (!isNew && described < known->second)
            {
                known->second = described; // of two Unity keeps one
            }
        }
    }
}

const std::filesystem::path* UnityProject::Find(std::string_view guid) const
{
    const auto found = m_Files.find(guid);
    return found == m_Files.end() || guid.empty() ? nullptr : &found->second;
}

std::string UnityScriptClass(const std::string& guid, const UnityProject& project)
{
    for (const auto& [packageGuid, type] : k_PackageScripts)
    {
        if (guid == packageGuid)
        {
            return std::string(type);
        }
    }
    const std::filesystem::path* path = project.Find(guid);
    return path ? path->stem().string() : std::string();
}

} // namespace limn
