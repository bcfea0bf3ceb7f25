#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderCompiler.h>

#include <span>
#include <string>

namespace limn
{

class IncludeResolver;

/// Calls CompileProgram in a worker of the options' process. May be called on any thread.
///
/// LIMN_TEST_ABORT=NAME in the environment makes a worker abort on files whose path ends in NAME,
/// for tests.
///
/// @param options   the options of the resolver
/// @param resolver  receives the dependencies, even if this throws
/// @throws the errors of CompileProgram, and AssetError if the worker ends
ShaderProgram CompileInWorker(const PassProgram& program, std::span<const std::string> keywords,
                              const ShaderCompilerOptions& options, IncludeResolver& resolver);

} // namespace limn
