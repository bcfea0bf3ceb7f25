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
    /// Returns the answer to a request. It runs in the worker and sees this program as it was when
    /// the WorkerProcess was made. An exception that leaves it ends the worker.
    std::string (*work)(std::string_view request) = nullptr;
    /// Called once for all workers, before the first that is started for such a task; may be null.
    void (*prepare)() = nullptr;
    /// The longest time that the work may take.
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
        NotStarted ///< the system could not start a process
    };
    Ending ending = Ending::NotStarted;
    int number = 0;
    std::string bytes; ///< the bytes of the answer
};

/// Returns a signal's name and number: "Aborted (signal 6)".
std::string SignalText(int signal);

/// A process whose children, the workers, do work that may crash, hang or take too much memory:
/// work of third-party libraries on unknown files. A worker is kept for the next task; one that
/// dies or hangs costs only its present task. A worker that asks for more than 2 GiB of memory gets
/// std::bad_alloc (not in builds with sanitizers).
///
/// The process is forked when this object is made and always has one thread, because a child forked
/// from a process with several threads could find locks that are never released. It must be made
/// before other threads are at work.
class WorkerProcess
{
public:
    WorkerProcess();
    /// Ends the process and its workers.
    ~WorkerProcess();
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    /// Runs a task and waits for the answer. May be called on any thread; tasks of several threads
    /// run at the same time.
    WorkerAnswer Run(const WorkerTask& task, std::string_view request);

private:
    /// Returns the socket of an idle worker, or -1 if none can be started.
    int TakeWorker(const WorkerTask& task);

    int m_Process = -1;
    int m_Requests = -1; ///< a socket that receives one end of a socket pair for each new worker
    std::mutex m_Mutex;
    std::vector<int> m_Idle; ///< the sockets of workers
};

} // namespace limn
