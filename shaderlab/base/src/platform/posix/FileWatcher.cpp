#include <limn/base/FileWatcher.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <poll.h>
#include <signal.h>
#include <sys/inotify.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace limn
{

namespace
{

// Not IN_MODIFY: between the truncation and the last byte a file is of no use to anybody.
// IN_CREATE is for folders and links, which are whole at once.
constexpr std::uint32_t k_Events =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE;

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

sigset_t Signals()
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

} // namespace

StopSignals::StopSignals()
{
    const sigset_t signals = Signals();
    m_Descriptor = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
    if (m_Descriptor < 0)
    {
        throw std::system_error(errno, std::generic_category(), "signalfd");
    }
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

StopSignals::~StopSignals()
{
    // The signals that came are taken out; otherwise they would end the process once they are let
    // through.
    signalfd_siginfo info;
    while (read(m_Descriptor, &info, sizeof(info)) > 0)
    {
    }
    close(m_Descriptor);
    const sigset_t signals = Signals();
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

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
    const Paths before = m_Known;
    m_Known.insert(files.begin(), files.end());
    Arm();
    for (const std::filesystem::path& file : files)
    {
        const auto changed = before.count(file) == 0 ? ChangeTime(file) : std::nullopt;
        if (changed && *changed >= readSince - k_ClockStep)
        {
            m_Missed.insert(file);
        }
    }
}

/// Finds out anew where the files are and watches the folders on the way there, from the outermost
/// in, so that a folder that comes meanwhile is either found or told of.
void FileWatcher::Arm()
{
    m_Places.clear();
    m_Folders.clear();
    for (const std::filesystem::path& file : m_Known)
    {
        std::error_code failure;
        const std::filesystem::path own = std::filesystem::absolute(file).lexically_normal();
        const std::filesystem::path target = std::filesystem::weakly_canonical(file, failure);
        for (const std::filesystem::path& place : {own, failure ? own : target})
        {
            m_Places[place].insert(file);
            for (auto folder = place.parent_path(); m_Folders.insert(folder).second;)
            {
                folder = folder.parent_path();
            }
        }
    }
    const std::map<int, Paths> before = std::exchange(m_Watches, {});
    for (const std::filesystem::path& folder : m_Folders)
    {
        // Asking again for a folder gives the watch it has, or a new one if it was made anew.
        const int watch = inotify_add_watch(m_Descriptor, folder.c_str(), k_Events | IN_ONLYDIR);
        if (watch >= 0)
        {
            m_Watches[watch].insert(folder);
        }
        else if (errno == ENOSPC || errno == ENOMEM)
        {
            throw std::system_error(errno, std::generic_category(),
                                    folder.string() + " cannot be watched");
        }
    }
    for (const auto& [watch, unused] : before)
    {
        if (m_Watches.count(watch) == 0)
        {
            inotify_rm_watch(m_Descriptor, watch); // fails if its folder is gone, and it with it
        }
    }
}

bool FileWatcher::Wait(const StopSignals& signals,
                       std::optional<std::chrono::milliseconds> time) const
{
    pollfd waits[] = {{signals.m_Descriptor, POLLIN, 0}, {m_Descriptor, POLLIN, 0}};
    poll(waits, 2, time ? static_cast<int>(time->count()) : -1);
    return waits[0].revents == 0;
}

std::set<std::filesystem::path> FileWatcher::TakeChanges()
{
    Paths changed = std::exchange(m_Missed, {});
    alignas(inotify_event) std::array<char, 16384> buffer;
    for (ssize_t size = 0; (size = read(m_Descriptor, buffer.data(), buffer.size())) > 0;)
    {
        for (std::size_t at = 0; at < static_cast<std::size_t>(size);)
        {
            inotify_event event;
            std::memcpy(&event, buffer.data() + at, sizeof(event));
            const char* name = event.len > 0 ? buffer.data() + at + sizeof(event) : "";
            at += sizeof(event) + event.len;
            TakeEvent(event.mask, event.wd, name, changed);
        }
    }
    return changed;
}

void FileWatcher::TakeEvent(std::uint32_t mask, int watch, const char* name, Paths& changed)
{
    if ((mask & IN_Q_OVERFLOW) != 0)
    {
        changed = m_Known;
        Arm();
        return;
    }
    const auto found = m_Watches.find(watch);
    // A copy, since the change of a folder arms anew.
    for (const std::filesystem::path& folder : found == m_Watches.end() ? Paths() : found->second)
    {
        const std::filesystem::path path = folder / name;
        std::error_code ignored;
        const bool isWhole = (mask & IN_CREATE) == 0 || std::filesystem::is_symlink(path, ignored);
        const auto place = m_Places.find(path);
        if (place != m_Places.end() && isWhole)
        {
            changed.insert(place->second.begin(), place->second.end());
        }
        if (m_Folders.count(path) > 0)
        {
            const bool isGone = (mask & (IN_MOVED_FROM | IN_DELETE)) != 0;
            TakeFolderChange(path, isGone, changed);
        }
    }
}

/// Takes the change of a folder. Its files are gone with it; files that are there now may be
/// others.
void FileWatcher::TakeFolderChange(const std::filesystem::path& folder, bool isGone, Paths& changed)
{
    for (const auto& [place, files] : m_Places)
    {
        const auto end = std::mismatch(folder.begin(), folder.end(), place.begin(), place.end());
        std::error_code ignored;
        if (end.first == folder.end() && (isGone || std::filesystem::exists(place, ignored)))
        {
            changed.insert(files.begin(), files.end());
        }
    }
    Arm();
}

} // namespace limn
