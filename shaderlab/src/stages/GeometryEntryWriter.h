#pragma once

#include "stages/StageLinkage.h"

#include <string>
#include <string_view>

namespace limn
{

// The author's geometry function stays an ordinary function, except for two things: its stream
// takes vertices of a generated type with explicit locations, and each vertex goes through a
// generated function into that type.

inline constexpr std::string_view k_GeometryOutput = "limn_Output"; ///< the generated type
inline constexpr std::string_view k_PackFunction = "limn_Pack";

/// Returns the HLSL, on one line, of the generated types and of k_PackFunction. It needs the
/// author's type of output vertices before it.
std::string WriteGeometryTypes(const StageInterface& interface, const StageLinkage& linkage);

/// Returns the HLSL of a function k_EntryName that calls the author's geometry function.
///
/// @param prologue  the statements that come first
std::string WriteGeometryEntry(const StageInterface& interface, const StageLinkage& linkage,
                               const std::string& prologue);

} // namespace limn
