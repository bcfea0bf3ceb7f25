#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <set>

namespace limn
{

/// Tells which of some files were written, replaced or removed. It watches their folders, so that a
/// file that an editor saves under another name and then renames is seen, and one that is not there
/// yet. A file that is being written counts when it is closed. Linux: inotify.
class FileWatcher
{
public:
    /// @throws std::system_error
    FileWatcher();
    ~FileWatcher();
    FileWatcher(const FileWatcher&) = delete;
    FileWatcher& operator=(const FileWatcher&) = delete;

    /// Adds files; those already watched stay. A file whose folder is not there is left out.
    /// @param readSince  when the caller began to read them: a file that is new here and changed
    ///                   since then counts as changed
    /// @throws std::system_error if the system cannot watch that many folders
    void Watch(const std::set<std::filesystem::path>& files,
               std::chrono::system_clock::time_point readSince = k_NotReadYet);

    /// The files, as given to Watch, that changed since the last call; does not wait.
    std::set<std::filesystem::path> TakeChanges();

    /// Readable, for poll(), as soon as something happened in a watched folder.
    int descriptor() const { return m_Descriptor; }

private:
    static constexpr auto k_NotReadYet = std::chrono::system_clock::time_point::max();

    void WatchPlace(const std::filesystem::path& place, const std::filesystem::path& file);

    int m_Descriptor;
    std::set<std::filesystem::path> m_Known;        ///< as given to Watch
    std::map<int, std::filesystem::path> m_Folders; ///< by watch descriptor
    /// The names each file is known under: its own and, for a link, that of what it points to.
    std::map<std::filesystem::path, std::set<std::filesystem::path>> m_Files;
    std::set<std::filesystem::path> m_Missed; ///< changed before they were watched
};

} // namespace limn
