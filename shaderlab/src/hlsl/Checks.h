#pragma once

#include "hlsl/Rewriter.h"

#include <string>

namespace limn
{

/// Refuses expressions and blocks that are nested so deeply that compilers, which call themselves
/// for each level, run out of stack.
///
/// @throws AssetError where the text goes too deep
void RequireShallow(const std::string& hlsl);

/// Refuses what glslang 12 crashes on instead of complaining, uniforms whose name is taken and
/// methods called on what a function returns, and what it complains of elsewhere: unknown macros
/// among the declarations.
///
/// @throws AssetError with all of them
void RequireSound(const HlslSource& source);

} // namespace limn
