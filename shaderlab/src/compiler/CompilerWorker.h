#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <string>

namespace limn
{

/// The whole life of a CompilerProcess: starts a worker for each socket that comes, until the other
/// side is gone.
[[noreturn]] void ServeCompiler(int requests);

} // namespace limn
