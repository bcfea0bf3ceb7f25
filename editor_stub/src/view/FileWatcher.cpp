#include "view/FileWatcher.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace limn
{

namespace
{

// Not IN_MODIFY: between the truncation and the last byte a file is of no use to anybody.
constexpr std::uint32_t k_Events = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;

/// The kernel stamps files with a clock that moves in steps.
constexpr auto k_ClockStep = std::chrono::milliseconds(10);

/// When the file was written or put in its place, which its time of writing does not tell of a file
/// that was renamed; nothing if there is none.
std::optional<std::chrono::system_clock::time_point> ChangeTime(const std::filesystem::path& file)
{
    struct stat status;
    if (stat(file.c_str(), &status) != 0)
    {
        return std::nullopt;
    }
    const auto time = std::chrono::seconds(status.st_ctim.tv_sec) +
                      std::chrono::nanoseconds(status.st_ctim.tv_nsec);
    return std::chrono::system_clock::time_point(
        std::chrono::duration_cast<std::chrono::system_clock::duration>(time));
}

} // namespace

FileWatcher::FileWatcher() : m_Descriptor(inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
{
    if (m_Descriptor < 0)
    {
        throw std::system_error(errno, std::generic_category(), "inotify");
    }
}

FileWatcher::~FileWatcher()
{
    close(m_Descriptor);
}

void FileWatcher::Watch(const std::set<std::filesystem::path>& files,
                        std::chrono::system_clock::time_point readSince)
{
    for (const std::filesystem::path& file : files)
    {
        std::error_code failure;
        const std::filesystem::path own = std::filesystem::absolute(file).lexically_normal();
        WatchPlace(own, file);
        const std::filesystem::path target = std::filesystem::weakly_canonical(file, failure);
        if (!failure && target != own)
        {
            WatchPlace(target, file);
        }
        const auto changed = m_Known.insert(file).second ? ChangeTime(file) : std::nullopt;
        if (changed && *changed >= readSince - k_ClockStep)
        {
            m_Missed.insert(file);
        }
    }
}

void FileWatcher::WatchPlace(const std::filesystem::path& place, const std::filesystem::path& file)
{
    m_Files[place].insert(file);
    const std::filesystem::path folder = place.parent_path();
    // Asking again for a folder gives the watch it has, or a new one if it was made anew.
    const int watch = inotify_add_watch(m_Descriptor, folder.c_str(), k_Events | IN_ONLYDIR);
    if (watch >= 0)
    {
        m_Folders[watch] = folder;
    }
    else if (errno == ENOSPC || errno == ENOMEM)
    {
        throw std::system_error(errno, std::generic_category(),
                                folder.string() + " cannot be watched");
    }
}

std::set<std::filesystem::path> FileWatcher::TakeChanges()
{
    std::set<std::filesystem::path> changed = std::exchange(m_Missed, {});
    alignas(inotify_event) std::array<char, 16384> buffer;
    for (ssize_t size = 0; (size = read(m_Descriptor, buffer.data(), buffer.size())) > 0;)
    {
        for (std::size_t at = 0; at < static_cast<std::size_t>(size);)
        {
            inotify_event event;
            std::memcpy(&event, buffer.data() + at, sizeof(event));
            const char* name = event.len > 0 ? buffer.data() + at + sizeof(event) : "";
            at += sizeof(event) + event.len;
            const bool isAnything = (event.mask & IN_Q_OVERFLOW) != 0;
            const auto folder = m_Folders.find(event.wd);
            for (const auto& [place, files] : m_Files)
            {
                const bool isIt = folder != m_Folders.end() && place == folder->second / name;
                if (isAnything || isIt)
                {
                    changed.insert(files.begin(), files.end());
                }
            }
        }
    }
    return changed;
}

} // namespace limn
