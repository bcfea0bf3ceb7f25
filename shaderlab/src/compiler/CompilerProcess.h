#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderProgram.h>

#include "program/IncludeResolver.h"

#include <chrono>
#include <span>
#include <string>

namespace limn
{

/// CompileProgram in a child process, which may die or hang: that is an AssetError at the program's
/// place. Any thread.
///
/// LIMN_TEST_ABORT=NAME in the environment makes the child abort on files whose path ends in NAME,
/// for tests.
///
/// @param resolver  gets the dependencies, also where this throws
/// @param limit  the time that the child gets
/// @throws what CompileProgram throws
ShaderProgram CompileInProcess(const PassProgram& program, std::span<const std::string> keywords,
                               IncludeResolver& resolver, std::chrono::milliseconds limit);

} // namespace limn
