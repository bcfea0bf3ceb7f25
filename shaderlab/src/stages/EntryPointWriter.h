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

/// Returns the declarations of a local variable for each parameter of the author's function, except
/// streams.
std::string ArgumentLocals(const StageInterface& interface);

/// Returns the HLSL of a function k_EntryName that calls the author's entry function.
///
/// @param prologue  the statements that come first, e.g. to fill the copies of uniforms
/// @param usesDrawIndex  true if the code asks for which draw it runs (see limn/PerDraw.hlsl)
std::string WriteEntryPoint(const StageInterface& interface, const StageLinkage& linkage,
                            ShaderStage stage, const std::string& prologue, bool usesDrawIndex);

} // namespace limn
