#pragma once

#include "hlsl/Declarations.h"

#include <string>
#include <string_view>

namespace limn
{

/// Returns the kernel's `[numthreads(…)]`, or "" if it has none.
std::string_view ThreadsOf(const HlslFunction& kernel);

/// Returns whether a `[numthreads(x, y, z)]` has three constants within the limits of Direct3D 11
/// (cs_5_0): 1 to 1024 along x and y, 1 to 64 along z, and 1024 in all. glslang crashes if one is
/// no constant.
bool HasValidThreads(std::string_view attribute, const IntegerNames& constants);

/// Returns the HLSL of a function k_EntryName that calls the author's kernel, with the threads of
/// its groups.
///
/// @param prologue  the statements that come first, see WriteEntryPoint
std::string WriteKernelEntry(const HlslFunction& kernel, const std::string& prologue);

} // namespace limn
