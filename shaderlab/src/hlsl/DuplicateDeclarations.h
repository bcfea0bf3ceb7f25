#pragma once

#include "hlsl/Declarations.h"
#include "hlsl/TokenEdits.h"

#include <vector>

namespace limn
{

/// Names that are declared more than once at file scope or in cbuffers.
struct DuplicateDeclarations
{
    /// Equal to another declaration, which is enough. Newer versions of Unity's library declare
    /// what authors had to declare before, and authors still do.
    std::vector<const HlslVariable*> superfluous;
    /// Loose uniforms whose name is something else already. glslang 12 crashes on them.
    std::vector<const HlslVariable*> redefinitions;
};

/// Pointers into `declarations`.
DuplicateDeclarations FindDuplicates(const HlslDeclarations& declarations);

/// Takes out what is superfluous, and buffers that nothing is left of.
void RemoveDuplicates(TokenEdits& code, const HlslDeclarations& declarations);

} // namespace limn
