#pragma once

#include "stages/StageLinkage.h"

#include <string>
#include <string_view>

namespace limn
{

inline constexpr std::string_view k_EntryName = "limn_Entry";

/// What #line calls the generated text; compilers' messages carry it where the entry is at fault.
inline constexpr std::string_view k_EntryFile = "limn";

/// A name that compilers keep for themselves.
inline constexpr std::string_view k_TakenName = "main";
/// What the author's entry function is called in the rewritten text, and whatever else is called
/// k_TakenName.
std::string AuthorFunctionName(std::string_view name);

/// Declarations of a local variable for each parameter of the author's function, streams apart.
std::string ArgumentLocals(const StageInterface& interface);

/// HLSL of a function k_EntryName that calls the author's entry function.
///
/// @param prologue  statements that come first, e.g. filling the copies of uniforms
/// @param usesDrawIndex  the code asks which draw it runs for (see limn/PerDraw.hlsl)
std::string WriteEntryPoint(const StageInterface& interface, const StageLinkage& linkage,
                            ShaderStage stage, const std::string& prologue, bool usesDrawIndex);

} // namespace limn
