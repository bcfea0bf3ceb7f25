#include <limn/base/WorkerProcess.h>

#include <limn/base/ByteStream.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <poll.h>
#include <set>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

/// The kinds of messages that a worker sends, or that are sent for it.
enum class WorkerMessage : char
{
    Answer,
    LastAnswer, ///< the worker takes no further request
    Ended       ///< a status as waitpid gives it follows
};

/// A file descriptor that one process sends to another, with a number.
struct SentDescriptor
{
    int descriptor = -1; ///< -1 if the other side is gone
    std::uint64_t number = 0;
};

/// The message that carries a descriptor from one process to another: a number and the descriptor.
struct DescriptorMessage
{
    std::uint64_t number = 0;
    iovec bytes{&number, sizeof(number)};
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
    msghdr header{};

    DescriptorMessage()
    {
        header.msg_iov = &bytes;
        header.msg_iovlen = 1;
        header.msg_control = control;
        header.msg_controllen = sizeof(control);
    }
    DescriptorMessage(const DescriptorMessage&) = delete;
    DescriptorMessage& operator=(const DescriptorMessage&) = delete;
};

bool SendAll(int socket, std::string_view bytes)
{
    while (!bytes.empty())
    {
        const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR)
        {
            return false;
        }
        bytes.remove_prefix(sent < 0 ? 0 : static_cast<std::size_t>(sent));
    }
    return true;
}

/// Returns fewer bytes where the other side stops sending. Memory is taken as bytes come, not by
/// what a broken size says.
std::string Receive(int socket, std::uint64_t size)
{
    constexpr std::uint64_t k_Part = 1 << 20;
    std::string bytes;
    std::size_t count = 0;
    while (count < size)
    {
        if (count == bytes.size())
        {
            bytes.resize(std::min(size, std::max(k_Part, std::uint64_t{2} * count)));
        }
        const ssize_t received = recv(socket, bytes.data() + count, bytes.size() - count, 0);
        if (received == 0 || (received < 0 && errno != EINTR))
        {
            break;
        }
        count += received < 0 ? 0 : static_cast<std::size_t>(received);
    }
    bytes.resize(count);
    return bytes;
}

/// Sends the number of bytes and the bytes. Returns false if the other side is gone.
bool SendMessage(int socket, std::string_view bytes)
{
    const std::uint64_t size = bytes.size();
    const std::string_view header(reinterpret_cast<const char*>(&size), sizeof(size));
    return SendAll(socket, header) && SendAll(socket, bytes);
}

/// Receives a message; returns nullopt if the other side is gone.
std::optional<std::string> ReceiveMessage(int socket)
{
    std::uint64_t size = 0;
    const std::string header = Receive(socket, sizeof(size));
    if (header.size() < sizeof(size))
    {
        return std::nullopt;
    }
    std::memcpy(&size, header.data(), sizeof(size));
    std::string bytes = Receive(socket, size);
    return bytes.size() == size ? std::optional(std::move(bytes)) : std::nullopt;
}

/// Returns false if the other side is gone.
bool SendDescriptor(int socket, const SentDescriptor& sent)
{
    DescriptorMessage message;
    message.number = sent.number;
    cmsghdr* const part = CMSG_FIRSTHDR(&message.header);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(part), &sent.descriptor, sizeof(int));
    return sendmsg(socket, &message.header, MSG_NOSIGNAL) ==
           static_cast<ssize_t>(sizeof(message.number));
}

SentDescriptor ReceiveDescriptor(int socket)
{
    DescriptorMessage message;
    ssize_t size = -1;
    do
    {
        size = recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC);
    } while (size < 0 && errno == EINTR);
    SentDescriptor sent;
    const cmsghdr* const part = size == static_cast<ssize_t>(sizeof(message.number))
                                    ? CMSG_FIRSTHDR(&message.header)
                                    : nullptr;
    if (part)
    {
        std::memcpy(&sent.descriptor, CMSG_DATA(part), sizeof(int));
        sent.number = message.number;
    }
    return sent;
}

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

/// Runs the process of a WorkerProcess: starts a worker for each socket that it receives, until the
/// other side is gone.
[[noreturn]] void ServeWorkers(int requests)
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

/// Returns whether a worker waits: one that has ended has sent that, or closed its socket.
bool isWaiting(int worker)
{
    char byte = 0;
    return recv(worker, &byte, 1, MSG_PEEK | MSG_DONTWAIT) < 0 && errno == EAGAIN;
}

/// The answer without its first byte, which says what it is.
WorkerAnswer ReadAnswer(std::optional<std::string> message, bool& isLast)
{
    WorkerAnswer answer;
    isLast = true;
    if (!message || message->empty())
    {
        return answer;
    }
    const auto kind = static_cast<WorkerMessage>(message->back());
    message->pop_back();
    if (kind != WorkerMessage::Ended)
    {
        isLast = kind == WorkerMessage::LastAnswer;
        answer.ending = WorkerAnswer::Ending::Answered;
        answer.bytes = std::move(*message);
        return answer;
    }
    int status = 0;
    std::memcpy(&status, message->data(), std::min(sizeof(status), message->size()));
    const bool isSignal = WIFSIGNALED(status);
    answer.number = isSignal ? WTERMSIG(status) : WEXITSTATUS(status);
    answer.ending = isSignal && answer.number == SIGALRM ? WorkerAnswer::Ending::OutOfTime
                    : isSignal                           ? WorkerAnswer::Ending::Signal
                                                         : WorkerAnswer::Ending::Exit;
    return answer;
}

} // namespace

std::string SignalText(int signal)
{
    return std::string(strsignal(signal)) + " (signal " + std::to_string(signal) + ")";
}

WorkerProcess::WorkerProcess()
{
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    {
        return; // Run says so
    }
    m_Process = fork();
    if (m_Process == 0)
    {
        // Neither this end of other processes' sockets nor a file that someone waits for the end of
        // stays open here.
        const int requests = dup2(ends[1], STDERR_FILENO + 1);
        close_range(STDERR_FILENO + 2, ~0U, 0);
        ServeWorkers(requests);
    }
    close(ends[1]);
    m_Requests = ends[0];
}

WorkerProcess::~WorkerProcess()
{
    for (const int worker : m_Idle)
    {
        close(worker);
    }
    close(m_Requests);
    while (m_Process > 0 && waitpid(m_Process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
}

int WorkerProcess::TakeWorker(const WorkerTask& task)
{
    const std::lock_guard lock(m_Mutex);
    while (!m_Idle.empty())
    {
        const int worker = m_Idle.back();
        m_Idle.pop_back();
        if (isWaiting(worker))
        {
            return worker;
        }
        close(worker);
    }
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    {
        return -1;
    }
    const bool isSent =
        SendDescriptor(m_Requests, {ends[1], reinterpret_cast<std::uintptr_t>(task.prepare)});
    close(ends[1]);
    if (!isSent)
    {
        close(ends[0]);
        return -1;
    }
    return ends[0];
}

WorkerAnswer WorkerProcess::Run(const WorkerTask& task, std::string_view request)
{
    const int worker = TakeWorker(task);
    // Functions lie at the same place in a process that was forked off this one.
    ByteWriter header;
    header.Values(reinterpret_cast<std::uintptr_t>(task.work),
                  static_cast<std::int64_t>(task.timeLimit.count()));
    bool isLast = true;
    std::optional<std::string> message;
    if (worker >= 0)
    {
        // A worker that ends while it is being sent to has left how it ended.
        static_cast<void>(SendMessage(worker, header.bytes()) && SendMessage(worker, request));
        message = ReceiveMessage(worker);
    }
    WorkerAnswer answer = ReadAnswer(std::move(message), isLast);
    if (!isLast)
    {
        const std::lock_guard lock(m_Mutex);
        m_Idle.push_back(worker);
    }
    else if (worker >= 0)
    {
        close(worker);
    }
    return answer;
}

} // namespace limn
