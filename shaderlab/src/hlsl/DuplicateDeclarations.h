#pragma once

#include "hlsl/Declarations.h"
#include "hlsl/TokenEdits.h"

#include <utility>
#include <vector>

namespace limn
{

/// The names that are declared more than once at file scope or in cbuffers.
struct DuplicateDeclarations
{
    /// The declarations that are equal to another one, which is enough. Newer versions of Unity's
    /// library declare names that authors had to declare before and still do.
    std::vector<const HlslVariable*> superfluous;
    /// Pairs of a superfluous declaration and the equal one behind it, a buffer's member.
    std::vector<std::pair<const HlslVariable*, const HlslVariable*>> early;
    /// The loose uniforms whose name is already something else. glslang 12 crashes on them.
    std::vector<const HlslVariable*> redefinitions;
};

/// Returns the duplicates as pointers into `declarations`.
DuplicateDeclarations FindDuplicates(const HlslDeclarations& declarations);

/// Removes the superfluous declarations, and buffers that become empty.
/// @return what it found
DuplicateDeclarations RemoveDuplicates(TokenEdits& code, const HlslDeclarations& declarations);

/// Moves a buffer up to where an equal declaration was removed before it, if the name is used
/// between the two. Its tokens must not be edited any more.
/// @param isLeftOut  by token: those that will not be compiled
void MoveBuffersUp(TokenEdits& code, const DuplicateDeclarations& removed,
                   const std::vector<bool>& isLeftOut);

} // namespace limn
