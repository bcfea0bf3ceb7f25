#include "platform/posix/SocketMessages.h"

#include <limn/base/ByteStream.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <poll.h>
#include <set>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

// The address sanitizer's shadow counts as memory, terabytes of it.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool k_HasShadow = true;
#elif defined(__has_feature)
constexpr bool k_HasShadow = __has_feature(address_sanitizer);
#else
constexpr bool k_HasShadow = false;
#endif

/// The bytes that count for RLIMIT_DATA. The process that the worker comes from may be a large one.
rlim_t DataSize()
{
    std::ifstream file("/proc/self/statm");
    rlim_t pages = 0;
    for (int field = 1; field <= 6; ++field) // the sixth: data and stack
    {
        file >> pages;
    }
    return file ? pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// No core files, and std::bad_alloc where memory grows and grows.
void LimitProcess()
{
    constexpr rlim_t k_Memory = rlim_t{2} << 30;
    const rlimit noCore{};
    setrlimit(RLIMIT_CORE, &noCore);
    if (!k_HasShadow)
    {
        const rlim_t limit = DataSize() + k_Memory;
        const rlimit memory{limit, limit};
        setrlimit(RLIMIT_DATA, &memory);
    }
    std::signal(SIGALRM, SIG_DFL);
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGALRM);
    sigprocmask(SIG_UNBLOCK, &signals, nullptr);
}

/// Ends the process by SIGALRM when the time is over; 0 = never.
void SetTimer(std::chrono::milliseconds limit)
{
    itimerval timer{};
    timer.it_value.tv_sec = limit.count() / 1000;
    timer.it_value.tv_usec = limit.count() % 1000 * 1000;
    setitimer(ITIMER_REAL, &timer, nullptr);
}

/// The most memory that the process has had at a time, in KiB.
long Peak()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

using Work = std::string (*)(std::string_view);

/// An exception ends the process as it ends a program.
std::string Call(Work work, std::string_view request) noexcept
{
    return work(request);
}

/// The whole life of a worker: until the other side is gone.
[[noreturn]] void ServeTasks(int socket)
{
    constexpr long k_Growth = 512 << 10; // KiB; what is kept after that is too much to keep
    LimitProcess();
    const long peakAtStart = Peak();
    bool isLast = false;
    while (!isLast)
    {
        const std::optional<std::string> header = ReceiveMessage(socket);
        const std::optional<std::string> request = header ? ReceiveMessage(socket) : std::nullopt;
        if (!request)
        {
            break;
        }
        std::uintptr_t work = 0;
        std::int64_t timeLimit = 0;
        ByteReader(*header).Values(work, timeLimit);
        SetTimer(std::chrono::milliseconds(timeLimit));
        std::string answer = Call(reinterpret_cast<Work>(work), *request);
        SetTimer(std::chrono::milliseconds(0)); // half an answer is none
        isLast = Peak() > peakAtStart + k_Growth;
        answer += static_cast<char>(isLast ? WorkerMessage::LastAnswer : WorkerMessage::Answer);
        isLast = !SendMessage(socket, answer) || isLast;
    }
    _exit(0);
}

/// Waits for the end of a worker, or ends it when the other side is gone. Returns its status.
int WaitForEnd(pid_t worker, int socket)
{
    pollfd ends[] = {{static_cast<int>(syscall(SYS_pidfd_open, worker, 0)), POLLIN, 0},
                     {socket, 0, 0}};
    const auto& [process, other] = ends;
    while (process.fd >= 0 && poll(ends, std::size(ends), -1) < 0 && errno == EINTR)
    {
    }
    if (process.fd >= 0 && process.revents == 0)
    {
        kill(worker, SIGKILL);
    }
    int status = 0;
    while (waitpid(worker, &status, 0) < 0 && errno == EINTR)
    {
    }
    return status;
}

/// Starts a worker, waits for its end and tells the other side.
[[noreturn]] void StartWorker(int socket)
{
    std::signal(SIGCHLD, SIG_DFL);
    const pid_t worker = fork();
    if (worker == 0)
    {
        ServeTasks(socket);
    }
    if (worker > 0)
    {
        const int status = WaitForEnd(worker, socket);
        std::string message(reinterpret_cast<const char*>(&status), sizeof(status));
        message += static_cast<char>(WorkerMessage::Ended);
        SendMessage(socket, message);
    }
    _exit(0); // what the parent has open and registered is not the child's to finish
}

} // namespace

void ServeWorkers(int requests)
{
    std::signal(SIGCHLD, SIG_IGN); // children are not waited for
    for (const int signal : {SIGINT, SIGHUP, SIGQUIT})
    {
        std::signal(signal, SIG_IGN); // they end with the program that they work for
    }
    std::set<std::uint64_t> prepared{0};
    for (SentDescriptor sent; (sent = ReceiveDescriptor(requests)).descriptor >= 0;
         close(sent.descriptor))
    {
        if (prepared.insert(sent.number).second)
        {
            reinterpret_cast<void (*)()>(static_cast<std::uintptr_t>(sent.number))();
        }
        if (fork() == 0)
        {
            close(requests);
            StartWorker(sent.descriptor);
        }
    }
    _exit(0);
}

} // namespace limn
