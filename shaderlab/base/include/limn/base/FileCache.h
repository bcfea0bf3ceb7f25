#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// A folder that keeps the results of long work, one file each. No problem with it is an error: a
/// missing, torn or foreign file counts as absent, and a folder that cannot be written keeps
/// nothing. Any number of processes may use one folder at once, and caches with other extensions
/// may share it.
class FileCache
{
public:
    /// A file that was found.
    struct Entry
    {
        std::string file;
        std::size_t first = 0; ///< the first byte of the payload
        std::size_t size = 0;

        std::string_view payload() const { return std::string_view(file).substr(first, size); }
    };

    /// @param folder     is made when something is stored; empty = no cache
    /// @param extension  the extension of the files: ".limnpass"
    /// @param magic      the text that the files begin with; each format has its own
    /// @param limit  the bytes that all files may take together; 0 = no limit. The files that were
    ///     not used for longest are removed first. The limit is enforced whenever an eighth of it
    ///     has been stored.
    FileCache(std::filesystem::path folder, std::string extension, std::string magic,
              std::uintmax_t limit)
        : m_Folder(std::move(folder)),
          m_Extension(std::move(extension)),
          m_Magic(std::move(magic)),
          m_Limit(limit)
    {
    }

    bool isEnabled() const { return !m_Folder.empty(); }

    /// @param key  a file's name without its extension
    std::optional<Entry> Load(const std::string& key) const;
    /// Counts an entry as used now.
    void Touch(const std::string& key) const;
    void Store(const std::string& key, std::string_view payload) const;

private:
    void Trim() const;
    /// Returns the bytes that the file of an entry begins with.
    std::string HeaderOf(const std::string& key) const;
    std::filesystem::path PathOf(const std::string& key) const
    {
        return m_Folder / (key + m_Extension);
    }

    std::filesystem::path m_Folder;
    std::string m_Extension;
    std::string m_Magic;
    std::uintmax_t m_Limit;
    mutable std::atomic<std::uintmax_t> m_Stored{0}; ///< bytes since the last Trim
    mutable std::atomic<bool> m_HasTrimmed{false};
};

} // namespace limn
