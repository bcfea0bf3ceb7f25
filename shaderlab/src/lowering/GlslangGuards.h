#pragma once

#include "lowering/StageLowering.h"

#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// @throws AssetError  at the first bracket without a partner
void RequirePairs(const HlslTokens& tokens);

/// Requires that expressions, blocks and structs are not nested so deeply that compilers, which
/// recurse for each level, run out of stack.
///
/// @throws AssetError where the text is nested too deeply
void RequireShallow(const HlslTokens& tokens);

/// Returns the line of a text that is not preprocessed yet in which brackets, around the arguments
/// of macros or in an `#if`, are nested too deeply for a preprocessor.
std::optional<int> FindDeepMacros(std::string_view text, int firstLine);
/// Returns the message for that line: "nested …".
std::string DescribeDeepMacros();

/// Requires that there is no code on which glslang 12 crashes without a message (uniforms whose
/// name is taken, and methods called on the result of a function), and none that it reports at a
/// wrong place (unknown macros among the declarations).
///
/// @throws AssetError with all such places
void RequireSound(const HlslSource& source);

/// Requires that labels are in a switch and constant, because glslang crashes on others; that
/// `GatherCmp` is called on textures that are no cubes, for their first component; and that lists
/// in lists are not empty.
///
/// @param nodes  must be resolved
/// @throws AssetError  at the nodes that are wrong
void RequireSoundNodes(const HlslNodes& nodes, const HlslTokens& tokens,
                       const HlslGlobals& globals);

} // namespace limn
