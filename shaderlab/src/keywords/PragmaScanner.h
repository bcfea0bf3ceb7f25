#pragma once

#include <limn/shaderlab/PassProgram.h>

#include "includes/IncludeResolver.h"

#include <functional>

namespace limn
{

/// Returns the names of the pragmas that declare keywords with the most common suffixes, to suggest
/// one for a misspelt name.
std::vector<std::string> KeywordDirectives();

/// Returns the file that `#include_with_pragmas` names in a given file.
using PragmaFileReader =
    std::function<std::optional<IncludedFile>(std::string_view include, std::string_view includer)>;

/// Sets the members of a program that its pragmas define, from the text of its chunks; replaces
/// their former values.
///
/// @param reader  reads included files; without one their pragmas are left out. These pragmas get
///     the place of the directive in the .shader file.
void ScanPragmas(PassProgram& program, const PragmaFileReader& reader = {});

} // namespace limn
