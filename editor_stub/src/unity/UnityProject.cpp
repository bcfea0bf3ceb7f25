#include "unity/UnityProject.h"

#include <limn/base/ByteStream.h>
#include <limn/base/FileCache.h>
#include <limn/base/HashContent.h>
#include <limn/base/ReadFile.h>
#include <vector>

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
    {"f62c9c65cf3354c93be831c8bc075510", "ScreenSpaceAmbientOcclusion"},
    {"a1614fc811f8f184697d9bee70ab9fe5", "DecalRendererFeature"}, // limn has neither of these two
    {"e32e72b6a3f58a24c9033e2b9275eea0", "ScreenSpaceShadows"}};

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

constexpr std::uintmax_t k_GuidIndexBytes = std::uintmax_t{64} << 20; ///< of all projects

std::string ReadGuid(const std::filesystem::path& metaFile)
{
    constexpr std::string_view k_Key = "\nguid: ";
    const std::string text = "\n" + TryReadFile(metaFile).bytes;
    const std::size_t at = text.find(k_Key);
    const std::size_t first = at + k_Key.size();
    return at == text.npos ? "" : text.substr(first, text.find_first_of(" \r\n", first) - first);
}

/// The guids of a project's .meta files, cached across runs. A file is read again only if its size
/// or the time of its last change differs.
class GuidIndex
{
public:
    /// @param root         the project's folder
    /// @param cacheFolder  empty = nothing is cached
    GuidIndex(const std::filesystem::path& root, const std::filesystem::path& cacheFolder)
        : m_Cache(cacheFolder, ".limnguids", "limn guids 1\n", k_GuidIndexBytes),
          m_Key("project-" + std::to_string(HashContent(root.generic_string())))
    {
        const std::optional<FileCache::Entry> kept = m_Cache.Load(m_Key);
        if (!kept)
        {
            return;
        }
        try
        {
            std::vector<std::pair<std::string, Entry>> entries;
            ByteReader reader(kept->payload());
            reader.List(entries, [&](auto& entry) { Transfer(reader, entry); });
            m_Kept =
                Entries(std::move_iterator(entries.begin()), std::move_iterator(entries.end()));
        }
        catch (const std::out_of_range&)
        {
            // one of another format
        }
    }

    /// Returns the guid that a .meta file has, or "" if it has none.
    std::string GuidOf(const std::filesystem::directory_entry& metaFile)
    {
        std::error_code failure;
        Entry entry;
        entry.size = metaFile.file_size(failure);
        const auto time =
            failure ? std::filesystem::file_time_type::min() : metaFile.last_write_time(failure);
        if (failure || !m_Cache.isEnabled())
        {
            return ReadGuid(metaFile.path());
        }
        entry.time = time.time_since_epoch().count();
        std::string path = metaFile.path().generic_string();
        const auto kept = m_Kept.find(path);
        const bool isSame = kept != m_Kept.end() && kept->second.size == entry.size &&
                            kept->second.time == entry.time;
        entry.guid = isSame ? kept->second.guid : ReadGuid(metaFile.path());
        // A file that has just been written may be written again within the same tick of the clock.
        using namespace std::chrono_literals;
        if (std::filesystem::file_time_type::clock::now() - time > 2s)
        {
            m_Found.emplace(std::move(path), entry);
        }
        return entry.guid;
    }

    /// Writes what was read to the cache, if the cache holds something else. Files that were not
    /// asked for are forgotten.
    void Store() const
    {
        if (!m_Cache.isEnabled() || m_Found == m_Kept)
        {
            return;
        }
        ByteWriter writer;
        writer.List(std::vector<std::pair<std::string, Entry>>(m_Found.begin(), m_Found.end()),
                    [&](const auto& entry) { Transfer(writer, entry); });
        m_Cache.Store(m_Key, writer.bytes());
    }

private:
    struct Entry
    {
        std::uint64_t size = 0;
        std::int64_t time = 0; ///< the time of the last change
        std::string guid;

        bool operator==(const Entry&) const = default;
    };
    using Entries = std::map<std::string, Entry>; ///< by path

    static void Transfer(auto& stream, auto& entry)
    {
        stream.Values(entry.first, entry.second.size, entry.second.time, entry.second.guid);
    }

    FileCache m_Cache;
    std::string m_Key;
    Entries m_Kept;
    Entries m_Found;
};

/// Adds the files of a folder and of those below it.
void ScanFolder(const std::filesystem::path& folder, GuidIndex& guids,
                std::map<std::string, std::filesystem::path, std::less<>>& files)
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
            const auto [known, isNew] = files.emplace(guid, described);
            if (!isNew && described < known->second)
            {
                known->second = described; // of two Unity keeps one
            }
        }
    }
}

} // namespace

bool IsPassedOver(std::string_view name)
{
    return name.starts_with('.') || name.ends_with('~') || name.ends_with(".tmp") || name == "cvs";
}

std::filesystem::path UnityProjectAround(const std::filesystem::path& file)
{
    std::error_code ignored;
    std::filesystem::path nearest;
    const std::filesystem::path whole =
        std::filesystem::absolute(file, ignored).lexically_normal(); // without "/./"
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
        ScanFolder(m_Root, guids, m_Files);
    }
    // The rest of Library is Unity's own, and may be larger than all assets.
    for (const char* folder : {"Assets", "Packages", "Library/PackageCache"})
    {
        ScanFolder(m_Root / folder, guids, m_Files);
    }
    guids.Store();
    if (asset.is_relative())
    {
        NameFrom(std::filesystem::current_path());
    }
}

/// Messages name the project's files as the user has named the asset, which is shorter.
void UnityProject::NameFrom(const std::filesystem::path& folder)
{
    const std::size_t rootLength = m_Root.native().size() + 1;
    m_Root = m_Root.lexically_relative(folder);
    const std::string above = m_Root == "." ? "" : m_Root.generic_string() + "/";
    for (auto& [guid, path] : m_Files)
    {
        path = above + path.native().substr(rootLength);
    }
}

const std::filesystem::path* UnityProject::Find(std::string_view guid) const
{
    const auto found = m_Files.find(guid);
    return found == m_Files.end() || guid.empty() ? nullptr : &found->second;
}

std::map<std::filesystem::path, std::string>
UnityProject::FindByName(std::string_view filename) const
{
    std::map<std::filesystem::path, std::string> found;
    for (const auto& [guid, path] : m_Files)
    {
        if (path.filename().string() == filename)
        {
            found.emplace(path, guid);
        }
    }
    return found;
}

std::vector<std::filesystem::path> UnityProject::FilesOf(std::string_view extension) const
{
    std::vector<std::filesystem::path> files;
    for (const auto& [guid, path] : m_Files)
    {
        if (ToLower(path.extension().string()) == extension)
        {
            files.push_back(path);
        }
    }
    return files;
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
