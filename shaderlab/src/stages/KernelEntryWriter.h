#pragma once

#include "hlsl/Declarations.h"

#include <string>
#include <string_view>

namespace limn
{

/// The kernel's `[numthreads(…)]`; "" if it has none.
std::string_view ThreadsOf(const HlslFunction& kernel);

/// HLSL of a function k_EntryName that calls the author's kernel, with the threads of its groups.
///
/// @param prologue  statements that come first, see WriteEntryPoint
std::string WriteKernelEntry(const HlslFunction& kernel, const std::string& prologue);

} // namespace limn
