#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderProgram.h>

#include "includes/IncludeResolver.h"

#include <span>
#include <string>

namespace limn
{

// Options become these macros in HLSL. Like keywords, they are on or off and part of the cache's
// key.

/// The macro that is defined if ShaderCompilerOptions::usesReversedZBuffer is off.
inline constexpr const char* k_StandardZMacro = "LIMN_STANDARD_Z";
/// The macro that is defined if ShaderCompilerOptions::halfIs16Bit is on.
inline constexpr const char* k_RealHalfMacro = "LIMN_REAL_HALF";

/// Compiles a program that limn supports, with all pragmas read, for one set of keywords.
///
/// @throws AssetError with columns where they are known
/// @throws UnsupportedProgramError if the included files show that limn does not support the
///     program
ShaderProgram CompileProgram(const PassProgram& program, std::span<const std::string> keywords,
                             IncludeResolver& resolver);

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
