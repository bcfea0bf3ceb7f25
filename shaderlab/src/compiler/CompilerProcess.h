#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderCompiler.h>

#include <mutex>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace limn
{

class IncludeResolver;

/// A process whose children, the workers, compile programs. A worker is kept for the next program;
/// one that dies or hangs costs only the program that it was at.
///
/// The process is forked off when it is made and has one thread ever after: a child forked off a
/// process with several threads would find locks that nobody gives back.
///
/// LIMN_TEST_ABORT=NAME in the environment makes a worker abort on files whose path ends in NAME,
/// for tests.
class CompilerProcess
{
public:
    /// Forks: other threads of this process should be at rest.
    CompilerProcess();
    /// Ends the workers, too.
    ~CompilerProcess();
    CompilerProcess(const CompilerProcess&) = delete;
    CompilerProcess& operator=(const CompilerProcess&) = delete;

    /// CompileProgram in a worker. Any thread.
    ///
    /// @param options   those that the resolver has
    /// @param resolver  gets the dependencies, also where this throws
    /// @throws what CompileProgram throws
    ShaderProgram Compile(const PassProgram& program, std::span<const std::string> keywords,
                          const ShaderCompilerOptions& options, IncludeResolver& resolver);

private:
    /// Gives the socket of a worker that has nothing to do; -1 where none can be started.
    int TakeWorker();
    void GiveBack(int worker);

    pid_t m_Process = -1;
    int m_Requests = -1; ///< a socket that takes one end of a socket for each new worker
    std::mutex m_Mutex;
    std::vector<int> m_Idle; ///< the sockets of workers
};

} // namespace limn
