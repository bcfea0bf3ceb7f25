#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string_view>
#include <system_error>

namespace limn
{

/// Writes a file whole or not at all: readers see the old content or the new one, and after a
/// failure the old one stays and nothing is left beside it. The folder must exist.
///
/// A file that is replaced keeps its permissions, its owner and its extended attributes, access
/// control lists among them; a link stays one, and the file that it leads to is written. Files that
/// a new file cannot replace are written in place: pipes and devices (not disks), the file that is
/// standard output, a file with several names (hard links), and one whose owner or attributes this
/// process cannot give to another file. A file that nobody may write to stays as it is. For the
/// last two kinds written in place, a failure for lack of room also keeps the old content.
/// @param beforeReplace  called when everything is ready to be written; an exception of it is a
///     failure
/// @return the system's reason, if it cannot be written
[[nodiscard]] std::error_code TryWriteFile(const std::filesystem::path& path,
                                           std::string_view bytes,
                                           const std::function<void()>& beforeReplace = {});

/// Writes a file that a person asked for, like TryWriteFile. The bytes are on the disk before they
/// replace the old ones, and the replacement is on the disk when this returns. Even after a power
/// failure the old content or the new one is there.
/// @throws AssetError with the path and the system's reason, if it cannot be written; it is a
///     MachineError if there is no room or the like
void WriteFile(const std::filesystem::path& path, std::string_view bytes,
               const std::function<void()>& beforeReplace = {});

/// Appends bytes to a file, or makes it. Returns when they are on the disk.
/// @throws AssetError like WriteFile
void AppendToFile(const std::filesystem::path& path, std::string_view bytes);

/// Returns the file that is written under this name: the target of a link, whether it exists or
/// not.
std::filesystem::path BehindLinks(std::filesystem::path path);

/// Writes all bytes to an open descriptor, such as standard output (1).
/// @return the system's reason, if it cannot be written
[[nodiscard]] std::error_code WriteToDescriptor(int descriptor, std::string_view bytes);

/// A lock that one owner at a time can hold, in any process. An owner that reads a file, changes it
/// and writes it back loses nothing that another owner writes. The first constructor waits until
/// the lock is free.
class FileLock
{
public:
    /// Locks the folder, because a replaced file is another file. On a file system without locks
    /// nothing is locked.
    /// @param file  the file to lock; for a link, its target
    explicit FileLock(const std::filesystem::path& file);
    /// Tries to take the lock without waiting.
    FileLock(const std::filesystem::path& file, std::try_to_lock_t);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// Returns whether another owner holds the lock, so that this object does not have it.
    bool isHeldElsewhere() const { return m_IsHeldElsewhere; }

private:
    void Lock(int operation);

    int m_Descriptor;
    bool m_IsHeldElsewhere = false;
};

} // namespace limn
