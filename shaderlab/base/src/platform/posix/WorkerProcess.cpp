#include <limn/base/WorkerProcess.h>

#include <limn/base/ByteStream.h>

#include "platform/posix/SocketMessages.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

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
