#include "compiler/CompilerProcess.h"

#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/ProgramBytes.h"
#include "compiler/ProgramCompiler.h"
#include "program/IncludeResolver.h"
#include "spirv/GlslangSession.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

/// The first byte of an answer; the dependencies and the program follow, of an error only its
/// diagnostics.
enum class Outcome : char
{
    Compiled,
    Unsupported,
    MissingInclude,
    Failed
};

AssetError ProgramError(const PassProgram& program, const std::string& reason)
{
    return AssetError(program.file, program.location, "program: " + reason);
}

std::string Answer(Outcome outcome, const ShaderProgram& program,
                   const std::vector<IncludeDependency>& dependencies)
{
    ByteWriter writer;
    writer.Value(outcome);
    Transfer(writer, dependencies);
    Transfer(writer, program);
    return writer.bytes();
}

std::string FailedAnswer(const AssetError& error)
{
    ShaderProgram program;
    program.diagnostics = error.diagnostics();
    return Answer(Outcome::Failed, program, {});
}

std::string Compile(const PassProgram& program, std::span<const std::string> keywords,
                    IncludeResolver& resolver)
{
    ShaderProgram compiled;
    Outcome outcome = Outcome::Failed;
    const auto fail = [&](Outcome kind, const AssetError& error)
    {
        outcome = kind;
        compiled.diagnostics = error.diagnostics();
    };
    try
    {
        compiled = CompileProgram(program, keywords, resolver);
        outcome = Outcome::Compiled;
    }
    catch (const UnsupportedProgramError& error)
    {
        fail(Outcome::Unsupported, error);
    }
    catch (const MissingIncludeError& error)
    {
        fail(Outcome::MissingInclude, error);
    }
    catch (const AssetError& error)
    {
        fail(Outcome::Failed, error);
    }
    catch (const std::bad_alloc&)
    {
        fail(Outcome::Failed, ProgramError(program, "program: compiling it takes more than 2 GiB "
                                                    "of memory; make it smaller"));
    }
    catch (const std::exception& error)
    {
        fail(Outcome::Failed,
             ProgramError(program, "the HLSL compiler failed: " + std::string(error.what())));
    }
    return Answer(outcome, compiled, resolver.dependencies());
}

// The address sanitizer's shadow counts as memory, terabytes of it.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool k_HasShadow = true;
#elif defined(__has_feature)
constexpr bool k_HasShadow = __has_feature(address_sanitizer);
#else
constexpr bool k_HasShadow = false;
#endif

/// No core files, std::bad_alloc where macros grow and grow, and the end by SIGALRM when the time
/// is over.
void LimitProcess(std::chrono::milliseconds limit)
{
    constexpr rlim_t k_Memory = rlim_t{2} << 30;
    const rlimit noCore{};
    const rlimit memory{k_Memory, k_Memory};
    setrlimit(RLIMIT_CORE, &noCore);
    if (!k_HasShadow)
    {
        setrlimit(RLIMIT_DATA, &memory);
    }
    std::signal(SIGALRM, SIG_DFL);
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGALRM);
    sigprocmask(SIG_UNBLOCK, &signals, nullptr);
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

/// False where the other side is gone.
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

/// Up to where the other side stops sending.
std::string ReceiveAll(int socket)
{
    std::string bytes;
    char buffer[1 << 16];
    for (;;)
    {
        const ssize_t size = recv(socket, buffer, sizeof(buffer), 0);
        if (size == 0 || (size < 0 && errno != EINTR))
        {
            return bytes;
        }
        bytes.append(buffer, size < 0 ? 0 : static_cast<std::size_t>(size));
    }
}

/// The message that carries a descriptor from one process to another: one byte and the descriptor.
struct DescriptorMessage
{
    char byte = 0;
    iovec bytes{&byte, 1};
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

bool SendDescriptor(int socket, int descriptor)
{
    DescriptorMessage message;
    cmsghdr* const part = CMSG_FIRSTHDR(&message.header);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(part), &descriptor, sizeof(int));
    return sendmsg(socket, &message.header, MSG_NOSIGNAL) == 1;
}

/// -1 where the other side is gone.
int ReceiveDescriptor(int socket)
{
    DescriptorMessage message;
    ssize_t size = -1;
    do
    {
        size = recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC);
    } while (size < 0 && errno == EINTR);
    const cmsghdr* const part = size == 1 ? CMSG_FIRSTHDR(&message.header) : nullptr;
    int descriptor = -1;
    if (part)
    {
        std::memcpy(&descriptor, CMSG_DATA(part), sizeof(int));
    }
    return descriptor;
}

/// Why the child has no answer; "" = it has one.
std::string Wait(pid_t child, std::chrono::milliseconds limit)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
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
    return WEXITSTATUS(status) == 0
               ? ""
               : "the HLSL compiler ends with exit code " + std::to_string(WEXITSTATUS(status));
}

/// What the children do with a program: one compiles it, the other waits for its end.
class Request
{
public:
    Request(int socket, const ShaderCompilerOptions& options) : m_Socket(socket), m_Options(options)
    {
        const std::string request = ReceiveAll(socket);
        ByteReader reader(request);
        Transfer(reader, m_Program);
        reader.List(m_Keywords, [&](std::string& keyword) { reader.Value(keyword); });
        Transfer(reader, m_FilesBeside);
    }

    void Serve() const
    {
        std::signal(SIGCHLD, SIG_DFL);
        const pid_t child = fork();
        if (child == 0)
        {
            LimitProcess(m_Options.timeLimit);
            AbortForTest(m_Program.file);
            IncludeResolver resolver(m_Options, m_Program.file);
            resolver.SetFilesBeside(m_FilesBeside);
            const std::string answer = Compile(m_Program, m_Keywords, resolver);
            alarm(0); // half an answer is none
            _exit(SendAll(m_Socket, answer) ? 0 : 1);
        }
        const std::string reason = child < 0 ? "no process for the HLSL compiler can be started: " +
                                                   std::string(std::strerror(errno))
                                             : Wait(child, m_Options.timeLimit);
        if (!reason.empty())
        {
            SendAll(m_Socket, FailedAnswer(ProgramError(m_Program, reason)));
        }
    }

private:
    int m_Socket;
    const ShaderCompilerOptions& m_Options;
    PassProgram m_Program;
    std::vector<std::string> m_Keywords;
    FilesBeside m_FilesBeside;
};

/// The whole life of the process: until the other side is gone.
[[noreturn]] void ServeRequests(int requests, const ShaderCompilerOptions& options)
{
    std::signal(SIGCHLD, SIG_IGN); // children are not waited for
    for (int socket; (socket = ReceiveDescriptor(requests)) >= 0; close(socket))
    {
        StartGlslang(); // once for all children
        if (fork() == 0)
        {
            Request(socket, options).Serve();
            _exit(0); // what the parent has open and registered is not the child's to finish
        }
    }
    _exit(0);
}

} // namespace

CompilerProcess::CompilerProcess(const ShaderCompilerOptions& options)
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
        ServeRequests(requests, options);
    }
    close(ends[1]);
    m_Requests = ends[0];
}

CompilerProcess::~CompilerProcess()
{
    close(m_Requests);
    while (m_Process > 0 && waitpid(m_Process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
}

ShaderProgram CompilerProcess::Compile(const PassProgram& program,
                                       std::span<const std::string> keywords,
                                       IncludeResolver& resolver) const
{
    ByteWriter request;
    Transfer(request, program);
    request.List(std::vector(keywords.begin(), keywords.end()),
                 [&](const std::string& keyword) { request.Value(keyword); });
    Transfer(request, resolver.filesBeside());
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    {
        throw ProgramError(program, "no socket to the HLSL compiler can be opened: " +
                                        std::string(std::strerror(errno)));
    }
    const bool isSent = SendDescriptor(m_Requests, ends[1]);
    close(ends[1]);
    if (isSent && SendAll(ends[0], request.bytes()))
    {
        shutdown(ends[0], SHUT_WR);
    }
    const std::string answer = ReceiveAll(ends[0]);
    close(ends[0]);
    if (answer.empty())
    {
        throw ProgramError(program, "no process for the HLSL compiler can be started");
    }
    Outcome outcome = Outcome::Failed;
    std::vector<IncludeDependency> dependencies;
    ShaderProgram compiled;
    ByteReader reader(answer);
    reader.Value(outcome);
    Transfer(reader, dependencies);
    Transfer(reader, compiled);
    resolver.SetDependencies(std::move(dependencies));
    switch (outcome)
    {
    case Outcome::Compiled:
        return compiled;
    case Outcome::Unsupported:
        throw UnsupportedProgramError(compiled.diagnostics.at(0));
    case Outcome::MissingInclude:
        throw MissingIncludeError(std::move(compiled.diagnostics));
    case Outcome::Failed:
        break;
    }
    throw AssetError(std::move(compiled.diagnostics));
}

} // namespace limn
