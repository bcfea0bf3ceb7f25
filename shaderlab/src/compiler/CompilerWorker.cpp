#include "compiler/CompilerWorker.h"

#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/ProgramCompiler.h"
#include "compiler/WorkerMessages.h"
#include "preprocess/GlslangSession.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <poll.h>
#include <string_view>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

CompilerAnswer Compile(const CompilerRequest& request)
{
    CompilerAnswer answer;
    const auto fail = [&](CompilerOutcome outcome, std::vector<Diagnostic> diagnostics)
    {
        answer.outcome = outcome;
        answer.program.diagnostics = std::move(diagnostics);
    };
    const auto failAtProgram = [&](const std::string& message)
    {
        const PassProgram& program = request.program;
        fail(CompilerOutcome::Failed,
             {{Severity::Error, program.file, program.location, "program: " + message}});
    };
    IncludeResolver resolver(request.options, request.program.file);
    resolver.SetFilesBeside(request.filesBeside);
    try
    {
        answer.program = CompileProgram(request.program, request.keywords, resolver);
        answer.outcome = CompilerOutcome::Compiled;
    }
    catch (const UnsupportedProgramError& error)
    {
        fail(CompilerOutcome::Unsupported, error.diagnostics());
    }
    catch (const MissingIncludeError& error)
    {
        fail(CompilerOutcome::MissingInclude, error.diagnostics());
    }
    catch (const AssetError& error)
    {
        fail(CompilerOutcome::Failed, error.diagnostics());
    }
    catch (const std::bad_alloc&)
    {
        answer.isLast = true; // what is left of the memory may be in pieces
        failAtProgram("compiling it takes more memory than there is for it, 2 GiB at most; make "
                      "it smaller");
    }
    catch (const std::exception& error)
    {
        failAtProgram("the HLSL compiler failed: " + std::string(error.what()));
    }
    answer.dependencies = resolver.dependencies();
    return answer;
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

/// No core files, and std::bad_alloc where macros grow and grow.
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

void AbortForTest(const std::string& file)
{
    const char* const name = std::getenv("LIMN_TEST_ABORT");
    if (name && *name && file.ends_with(name))
    {
        std::abort();
    }
}

/// The most memory that the process has had at a time, in KiB.
long Peak()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

bool Send(int socket, const CompilerAnswer& answer)
{
    ByteWriter writer;
    Transfer(writer, answer);
    return SendMessage(socket, writer.bytes());
}

/// The whole life of a worker: until the other side is gone.
[[noreturn]] void Work(int socket)
{
    constexpr long k_Growth = 512 << 10; // KiB; what is kept after that is too much to keep
    LimitProcess();
    const long peakAtStart = Peak();
    bool isLast = false;
    while (!isLast)
    {
        const std::optional<std::string> bytes = ReceiveMessage(socket);
        if (!bytes)
        {
            break;
        }
        CompilerRequest request;
        ByteReader reader(*bytes);
        Transfer(reader, request);
        SetTimer(request.options.timeLimit);
        AbortForTest(request.program.file);
        CompilerAnswer answer = Compile(request);
        SetTimer(std::chrono::milliseconds(0)); // half an answer is none
        answer.isLast = answer.isLast || Peak() > peakAtStart + k_Growth;
        isLast = !Send(socket, answer) || answer.isLast;
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
        Work(socket);
    }
    if (worker > 0)
    {
        CompilerAnswer answer;
        answer.outcome = CompilerOutcome::Ended;
        answer.isLast = true;
        answer.waitStatus = WaitForEnd(worker, socket);
        Send(socket, answer);
    }
    _exit(0); // what the parent has open and registered is not the child's to finish
}

} // namespace

void ServeCompiler(int requests)
{
    std::signal(SIGCHLD, SIG_IGN); // children are not waited for
    for (const int signal : {SIGINT, SIGHUP, SIGQUIT})
    {
        std::signal(signal, SIG_IGN); // they end with the program that they work for
    }
    for (int socket; (socket = ReceiveDescriptor(requests)) >= 0; close(socket))
    {
        StartGlslang(); // once for all workers
        if (fork() == 0)
        {
            close(requests);
            StartWorker(socket);
        }
    }
    _exit(0);
}

} // namespace limn
