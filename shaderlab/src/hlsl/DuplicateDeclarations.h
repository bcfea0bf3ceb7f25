#pragma once

#include "hlsl/Declarations.h"
#include "hlsl/TokenEdits.h"

#include <vector>

namespace limn
{

/// The names that are declared more than once at file scope or in cbuffers.
struct DuplicateDeclarations
{
    /// The declarations that are equal to another one, which is enough. Newer versions of Unity's
    /// library declare names that authors had to declare before and still do.
    std::vector<const HlslVariable*> superfluous;
    /// The loose uniforms whose name is already something else. glslang 12 crashes on them.
    std::vector<const HlslVariable*> redefinitions;
};

/// Returns the duplicates as pointers into `declarations`.
DuplicateDeclarations FindDuplicates(const HlslDeclarations& declarations);

/// Removes the superfluous declarations, and buffers that become empty.
void RemoveDuplicates(TokenEdits& code, const HlslDeclarations& declarations);

} // namespace limn
