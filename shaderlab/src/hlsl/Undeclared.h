#pragma once

#include <limn/shaderlab/Diagnostic.h>

#include "hlsl/Declarations.h"

#include <map>
#include <string_view>
#include <vector>

namespace limn
{

/// Types and names that nobody declares, each once.
struct HlslUndeclared
{
    std::vector<std::size_t> types;                ///< tokens
    std::map<std::size_t, std::string_view> names; ///< token → what is said of it

    /// The types first, each with the name that may be meant.
    std::vector<Diagnostic> Describe(const HlslTokens& tokens,
                                     const HlslDeclarations& declarations) const;
};

} // namespace limn
