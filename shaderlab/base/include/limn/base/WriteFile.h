#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string_view>
#include <system_error>

namespace limn
{

/// Writes a file that appears whole or not at all: readers see the old content or the new one, and
/// after a failure the old one stays and nothing is left beside it. The folder must exist.
///
/// A file that is replaced keeps its permissions, its owner and its extended attributes, access
/// control lists among them; a link stays one, and the file that it leads to is written. What a new
/// file cannot take the place of is written to where it stands: pipes and devices (not disks), the
/// file that is standard output, a file of several names (hard links) and one whose owner or
/// attributes this process cannot give to another file. A file that nobody may write to is left
/// alone. Of the last two, a failure for want of room leaves the old content as well.
/// @param beforeReplace  called when all is ready to be written; what it throws is a failure
/// @return the system's reason, if it cannot be written
[[nodiscard]] std::error_code TryWriteFile(const std::filesystem::path& path,
                                           std::string_view bytes,
                                           const std::function<void()>& beforeReplace = {});

/// TryWriteFile, for files a person asked for: the bytes are on the disk before they take the old
/// ones' place, and that they did is when this returns. Not even a power failure leaves neither.
/// @throws AssetError naming the path and the system's reason, if it cannot be written; a
///     MachineError where there is no room or the like
void WriteFile(const std::filesystem::path& path, std::string_view bytes,
               const std::function<void()>& beforeReplace = {});

/// Throws what WriteFile does for this reason.
[[noreturn]] void ThrowWriteError(const std::filesystem::path& path, const std::error_code& reason);

/// The file that is written under this name: the one that a link leads to, whether it is there or
/// not.
std::filesystem::path BehindLinks(std::filesystem::path path);

/// Writes all bytes to what is open already, such as standard output (1).
/// @return the system's reason, if it cannot be written
[[nodiscard]] std::error_code WriteToDescriptor(int descriptor, std::string_view bytes);

/// Held by one owner at a time, in whatever process: who reads a file, changes it and writes it
/// back loses nothing that another owner wrote meanwhile. Waits until it is free.
class FileLock
{
public:
    /// Locks the folder, for the file is another one once it was replaced. On a file system without
    /// locks nothing is held.
    /// @param file  through a link, the file behind it
    explicit FileLock(const std::filesystem::path& file);
    /// Does not wait.
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
