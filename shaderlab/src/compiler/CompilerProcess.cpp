#include "compiler/CompilerProcess.h"

#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/CompilerWorker.h"
#include "compiler/WorkerMessages.h"

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

AssetError ProgramError(const PassProgram& program, const std::string& reason)
{
    return AssetError(program.file, program.location, "program: " + reason);
}

std::string ReasonOfEnd(int status, std::chrono::milliseconds limit)
{
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    {
        return "compiling it takes longer than " + std::to_string(limit.count()) +
               " ms; make it smaller";
    }
    if (WIFSIGNALED(status))
    {
        return "the HLSL compiler crashes on it: " + std::string(strsignal(WTERMSIG(status))) +
               " (signal " + std::to_string(WTERMSIG(status)) + ")";
    }
    return "the HLSL compiler ends with exit code " + std::to_string(WEXITSTATUS(status));
}

/// Returns whether a worker waits: one that has ended has sent that, or closed its socket.
bool isWaiting(int worker)
{
    char byte = 0;
    return recv(worker, &byte, 1, MSG_PEEK | MSG_DONTWAIT) < 0 && errno == EAGAIN;
}

/// Returns no answer where the worker is gone.
std::optional<CompilerAnswer> Ask(int worker, const CompilerRequest& request)
{
    ByteWriter writer;
    Transfer(writer, request);
    const std::optional<std::string> bytes =
        SendMessage(worker, writer.bytes()) ? ReceiveMessage(worker) : std::nullopt;
    if (!bytes)
    {
        return std::nullopt;
    }
    try
    {
        CompilerAnswer answer;
        ByteReader reader(*bytes);
        Transfer(reader, answer);
        return answer;
    }
    catch (const std::out_of_range&) // it was killed while it sent
    {
        return std::nullopt;
    }
}

} // namespace

std::shared_ptr<CompilerProcess> StartCompilerProcess()
{
    return std::make_shared<CompilerProcess>();
}

CompilerProcess::CompilerProcess()
{
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    {
        return; // Compile says so
    }
    m_Process = fork();
    if (m_Process == 0)
    {
        // Neither this end of other compilers' sockets nor a file that someone waits for the end of
        // stays open here.
        const int requests = dup2(ends[1], STDERR_FILENO + 1);
        close_range(STDERR_FILENO + 2, ~0U, 0);
        ServeCompiler(requests);
    }
    close(ends[1]);
    m_Requests = ends[0];
}

CompilerProcess::~CompilerProcess()
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

int CompilerProcess::TakeWorker()
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
    const bool isSent = SendDescriptor(m_Requests, ends[1]);
    close(ends[1]);
    if (!isSent)
    {
        close(ends[0]);
        return -1;
    }
    return ends[0];
}

void CompilerProcess::GiveBack(int worker)
{
    const std::lock_guard lock(m_Mutex);
    m_Idle.push_back(worker);
}

ShaderProgram CompilerProcess::Compile(const PassProgram& program,
                                       std::span<const std::string> keywords,
                                       const ShaderCompilerOptions& options,
                                       IncludeResolver& resolver)
{
    const CompilerRequest request{
        program, {keywords.begin(), keywords.end()}, options, resolver.filesBeside()};
    const int worker = TakeWorker();
    std::optional<CompilerAnswer> answer = Ask(worker, request);
    if (answer && !answer->isLast)
    {
        GiveBack(worker);
    }
    else
    {
        close(worker);
    }
    if (!answer)
    {
        throw ProgramError(program, "no process for the HLSL compiler can be started");
    }
    resolver.SetDependencies(std::move(answer->dependencies));
    std::vector<Diagnostic>& diagnostics = answer->program.diagnostics;
    switch (answer->outcome)
    {
    case CompilerOutcome::Compiled:
        return std::move(answer->program);
    case CompilerOutcome::Unsupported:
        throw UnsupportedProgramError(diagnostics.at(0));
    case CompilerOutcome::MissingInclude:
        throw MissingIncludeError(std::move(diagnostics));
    case CompilerOutcome::Ended:
        throw ProgramError(program, ReasonOfEnd(answer->waitStatus, options.timeLimit));
    case CompilerOutcome::Failed:
        break;
    }
    throw AssetError(std::move(diagnostics));
}

} // namespace limn
