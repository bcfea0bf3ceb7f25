#pragma once

#include "lowering/StageLowering.h"

#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// @throws AssetError  at the first bracket that has no other
void RequirePairs(const HlslTokens& tokens);

/// Refuses expressions, blocks and structs that are nested so deeply that compilers, which call
/// themselves for each level, run out of stack.
///
/// @throws AssetError where the text goes too deep
void RequireShallow(const HlslTokens& tokens);

/// Text before it is preprocessed: the line where brackets, around the arguments of macros or in an
/// `#if`, are nested too deeply for a preprocessor.
std::optional<int> FindDeepMacros(std::string_view text, int firstLine);
/// What is wrong there: "nested …".
std::string DescribeDeepMacros();

/// Refuses what glslang 12 crashes on instead of complaining, uniforms whose name is taken and
/// methods called on what a function returns, and what it complains of elsewhere: unknown macros
/// among the declarations.
///
/// @throws AssetError with all of them
void RequireSound(const HlslSource& source);

/// Labels stand in a switch and are constants; glslang crashes on others. `GatherCmp` is of
/// textures that are no cubes, and of their first number. Lists in lists are not empty.
///
/// @param nodes  resolved
/// @throws AssetError  at those that are wrong
void RequireSoundNodes(const HlslNodes& nodes, const HlslTokens& tokens,
                       const HlslGlobals& globals);

} // namespace limn
