#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace limn
{

/// Turns SIGINT and SIGTERM into events to wait for, as long as it lives. Must be made before other
/// threads start, because they inherit that the signals are blocked.
class StopSignals
{
public:
    /// @throws std::system_error
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

private:
    friend class FileWatcher;

    int m_Descriptor; ///< readable as soon as one of the signals came
};

/// Reports which of some files were written, replaced or removed. It watches their folders, so that
/// it notices a file that does not exist yet, or that an editor saves under another name and then
/// renames. It also watches the folders above, so that it notices a folder that another one
/// replaces, for example by a checkout or an unpacked archive. A file that is being written counts
/// as changed when it is closed. Linux: inotify.
class FileWatcher
{
public:
    /// @throws std::system_error
    FileWatcher();
    ~FileWatcher();
    FileWatcher(const FileWatcher&) = delete;
    FileWatcher& operator=(const FileWatcher&) = delete;

    /// Adds files; those already watched stay. Neither a file nor its folder has to exist yet.
    /// @param readSince  the time at which the caller began to read them; a newly added file that
    ///     changed since then counts as changed
    /// @throws std::system_error if the system cannot watch that many folders
    void Watch(const std::set<std::filesystem::path>& files,
               std::chrono::system_clock::time_point readSince = k_NotReadYet);

    /// Returns the files, as given to Watch, that changed since the last call; does not wait.
    std::set<std::filesystem::path> TakeChanges();

    /// Waits until something happens in a watched folder or the time is over. Without a time it
    /// waits until something happens.
    /// @return false once a stop signal came
    bool Wait(const StopSignals& signals, std::optional<std::chrono::milliseconds> time) const;

private:
    static constexpr auto k_NotReadYet = std::chrono::system_clock::time_point::max();

    using Paths = std::set<std::filesystem::path>;

    void Arm();
    void TakeEvent(std::uint32_t mask, int watch, const char* name, Paths& changed);
    void TakeFolderChange(const std::filesystem::path& folder, bool isGone, Paths& changed);

    int m_Descriptor;               ///< readable as soon as something happened in a watched folder
    Paths m_Known;                  ///< as given to Watch
    Paths m_Folders;                ///< the folders of the places, and all folders above
    std::map<int, Paths> m_Watches; ///< the names of each watch descriptor's folder
    /// The names of each file: its own and, for a link, that of its target.
    std::map<std::filesystem::path, Paths> m_Places;
    Paths m_Missed; ///< changed before they were watched
};

} // namespace limn
