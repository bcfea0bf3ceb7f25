#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderCompiler.h>

#include <span>
#include <string>
#include <sys/types.h>

namespace limn
{

class IncludeResolver;

/// A process that compiles programs, each in a child of its own, which may die or hang: that is an
/// AssetError at the program's place.
///
/// It is forked off when it is made and has one thread ever after: a child forked off a process
/// with several threads would find locks that nobody gives back.
///
/// LIMN_TEST_ABORT=NAME in the environment makes the child abort on files whose path ends in NAME,
/// for tests.
class CompilerProcess
{
public:
    /// Forks: other threads of this process should be at rest.
    explicit CompilerProcess(const ShaderCompilerOptions& options);
    ~CompilerProcess();
    CompilerProcess(const CompilerProcess&) = delete;
    CompilerProcess& operator=(const CompilerProcess&) = delete;

    /// CompileProgram in a child. Any thread.
    ///
    /// @param resolver  gets the dependencies, also where this throws
    /// @throws what CompileProgram throws
    ShaderProgram Compile(const PassProgram& program, std::span<const std::string> keywords,
                          IncludeResolver& resolver) const;

private:
    pid_t m_Process = -1;
    int m_Requests = -1; ///< a socket that takes one end of a socket for each program
};

} // namespace limn
