#include "compiler/CompilerProcess.h"

#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "compiler/ProgramCompiler.h"
#include "compiler/ShaderCache.h"
#include "spirv/GlslangSession.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

/// The first byte of an answer; a pass follows, of an error only its diagnostics.
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

std::string Compile(const PassProgram& program, std::span<const std::string> keywords,
                    IncludeResolver& resolver)
{
    ShaderProgram pass;
    Outcome outcome = Outcome::Failed;
    const auto fail = [&](Outcome kind, const AssetError& error)
    {
        outcome = kind;
        pass.diagnostics = error.diagnostics();
    };
    try
    {
        pass = CompileProgram(program, keywords, resolver);
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
    catch (const std::exception& error)
    {
        fail(Outcome::Failed,
             ProgramError(program, "the HLSL compiler failed: " + std::string(error.what())));
    }
    return static_cast<char>(outcome) + WriteProgram(pass, resolver.dependencies());
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

/// The child's whole life.
[[noreturn]] void Answer(int pipe, const std::string& answer)
{
    for (std::string_view rest = answer; !rest.empty();)
    {
        const ssize_t written = write(pipe, rest.data(), rest.size());
        if (written < 0 && errno != EINTR)
        {
            _exit(1);
        }
        rest.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    _exit(0); // what the parent has open and registered is not the child's to finish
}

std::string ReadAll(int pipe)
{
    std::string bytes;
    char buffer[1 << 16];
    for (;;)
    {
        const ssize_t size = read(pipe, buffer, sizeof(buffer));
        if (size == 0 || (size < 0 && errno != EINTR))
        {
            return bytes;
        }
        bytes.append(buffer, size < 0 ? 0 : static_cast<std::size_t>(size));
    }
}

struct Child
{
    pid_t id = -1;
    int pipe = -1; ///< to read from
};

/// @param run  what the child does, with the end of the pipe that it writes to
template <typename F>
Child Start(F&& run)
{
    // A child started meanwhile would have the end that is written to as well, and keep it open.
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    Child child;
    int ends[2];
    if (pipe(ends) != 0)
    {
        return child;
    }
    child.id = fork();
    if (child.id == 0)
    {
        run(ends[1]);
    }
    const int error = errno;
    close(ends[1]);
    if (child.id < 0)
    {
        close(ends[0]);
    }
    errno = error; // of fork
    child.pipe = ends[0];
    return child;
}

/// Why the child has no answer; "" = it has one.
std::string Wait(const Child& child, std::chrono::milliseconds limit)
{
    int status = 0;
    while (waitpid(child.id, &status, 0) < 0 && errno == EINTR)
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

} // namespace

ShaderProgram CompileInProcess(const PassProgram& program, std::span<const std::string> keywords,
                               IncludeResolver& resolver, std::chrono::milliseconds limit)
{
    StartGlslang(); // once for all children
    const Child child = Start(
        [&](int pipe)
        {
            LimitProcess(limit);
            AbortForTest(program.file);
            Answer(pipe, Compile(program, keywords, resolver));
        });
    if (child.id < 0)
    {
        throw ProgramError(program, "no process for the HLSL compiler can be started: " +
                                        std::string(std::strerror(errno)));
    }
    const std::string answer = ReadAll(child.pipe);
    close(child.pipe);
    if (const std::string reason = Wait(child, limit); !reason.empty() || answer.empty())
    {
        throw ProgramError(program, reason);
    }
    std::vector<IncludeDependency> dependencies;
    ShaderProgram pass = ReadProgram(std::string_view(answer).substr(1), dependencies);
    resolver.SetDependencies(std::move(dependencies));
    switch (static_cast<Outcome>(answer[0]))
    {
    case Outcome::Compiled:
        return pass;
    case Outcome::Unsupported:
        throw UnsupportedProgramError(pass.diagnostics.at(0));
    case Outcome::MissingInclude:
        throw MissingIncludeError(std::move(pass.diagnostics));
    case Outcome::Failed:
        break;
    }
    throw AssetError(std::move(pass.diagnostics));
}

} // namespace limn
