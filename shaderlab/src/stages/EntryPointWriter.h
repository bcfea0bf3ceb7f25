#pragma once

#include "stages/StageLinkage.h"

#include <string>
#include <string_view>

namespace limn
{

inline constexpr std::string_view k_EntryName = "limn_Entry";

/// The name of the generated text in #line; compilers' messages have it if the entry is the cause.
inline constexpr std::string_view k_EntryFile = "limn";

/// A name that compilers reserve.
inline constexpr std::string_view k_TakenName = "main";
/// Returns the name in the rewritten text of the author's entry function, or of anything else
/// called k_TakenName.
std::string AuthorFunctionName(std::string_view name);

/// Returns the HLSL of a function k_EntryName that calls the author's entry function.
///
/// @param prologue  the statements that come first, e.g. to fill the copies of uniforms
/// @param usesDrawIndex  true if the code asks for which draw it runs (see limn/PerDraw.hlsl)
std::string WriteEntryPoint(const StageInterface& interface, const StageLinkage& linkage,
                            ShaderStage stage, const std::string& prologue, bool usesDrawIndex);

// The author's geometry function stays an ordinary function, except for two things: its stream
// takes vertices of a generated type with explicit locations, and each vertex goes through a
// generated function into that type.

inline constexpr std::string_view k_GeometryOutput = "limn_Output"; ///< the generated type
inline constexpr std::string_view k_PackFunction = "limn_Pack";

/// Returns the HLSL, on one line, of the generated types and of k_PackFunction. It needs the
/// author's type of output vertices before it.
std::string WriteGeometryTypes(const StageInterface& interface, const StageLinkage& linkage);

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
