#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderCompiler.h>

#include <span>
#include <string>

namespace limn
{

class IncludeResolver;

/// CompileProgram in a worker of the options' process. Any thread.
///
/// LIMN_TEST_ABORT=NAME in the environment makes a worker abort on files whose path ends in NAME,
/// for tests.
///
/// @param options   those that the resolver has
/// @param resolver  gets the dependencies, also where this throws
/// @throws what CompileProgram throws, and AssetError where the worker ends
ShaderProgram CompileInWorker(const PassProgram& program, std::span<const std::string> keywords,
                              const ShaderCompilerOptions& options, IncludeResolver& resolver);

} // namespace limn
