#pragma once

#include <filesystem>
#include <limn/base/FileCache.h>
#include <map>
#include <string>

namespace limn
{

/// The guids of a project's .meta files, cached across runs. A file is read again only if its size
/// or the time of its last change differs.
class GuidIndex
{
public:
    /// @param root         the project's folder
    /// @param cacheFolder  empty = nothing is cached
    GuidIndex(const std::filesystem::path& root, const std::filesystem::path& cacheFolder);

    /// Returns the guid that a .meta file has, or "" if it has none.
    std::string GuidOf(const std::filesystem::directory_entry& metaFile);
    /// Writes what was read to the cache, if the cache holds something else. Files that were not
    /// asked for are forgotten.
    void Store() const;

private:
    struct Entry
    {
        std::uint64_t size = 0;
        std::int64_t time = 0; ///< the time of the last change
        std::string guid;

        bool operator==(const Entry&) const = default;
    };
    using Entries = std::map<std::string, Entry>; ///< by path
    static void Transfer(auto& stream, auto& entry);

    FileCache m_Cache;
    std::string m_Key;
    Entries m_Kept;
    Entries m_Found;
};

} // namespace limn
