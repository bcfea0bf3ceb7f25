#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A piece of work for a worker.
struct WorkerTask
{
    /// Makes an answer of a request. It runs in the worker and sees this program as it was when the
    /// WorkerProcess was made. An exception that leaves it ends the worker.
    std::string (*work)(std::string_view request) = nullptr;
    /// Called once for all workers, before the first that is started for such a task; may be null.
    void (*prepare)() = nullptr;
    /// The work may take so long.
    std::chrono::milliseconds timeLimit = std::chrono::seconds{30};
};

/// The answer of a worker, or how it ended without one.
struct WorkerAnswer
{
    enum class Ending
    {
        Answered,
        OutOfTime,
        Signal,    ///< `number` is the signal's
        Exit,      ///< `number` is the exit code
        NotStarted ///< the system gave no process
    };
    Ending ending = Ending::NotStarted;
    int number = 0;
    std::string bytes; ///< of the answer
};

/// Returns a signal's name and number: "Aborted (signal 6)".
std::string SignalText(int signal);

/// A process whose children, the workers, do what may crash, hang or take too much memory: work of
/// other people's libraries on files of anybody. A worker is kept for the next task; one that dies
/// or hangs costs only the task that it was at. A worker that asks for more than 2 GiB of memory
/// gets std::bad_alloc (not in builds with sanitizers).
///
/// The process is forked off when it is made and has one thread ever after: a child forked off a
/// process with several threads would find locks that nobody gives back. Make it before other
/// threads are at work.
class WorkerProcess
{
public:
    WorkerProcess();
    /// Ends the workers, too.
    ~WorkerProcess();
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    /// Waits for the answer. Any thread; tasks of several threads are done at a time.
    WorkerAnswer Run(const WorkerTask& task, std::string_view request);

private:
    /// Gives the socket of a worker that has nothing to do; -1 where none can be started.
    int TakeWorker(const WorkerTask& task);

    int m_Process = -1;
    int m_Requests = -1; ///< a socket that takes one end of a socket for each new worker
    std::mutex m_Mutex;
    std::vector<int> m_Idle; ///< the sockets of workers
};

} // namespace limn
