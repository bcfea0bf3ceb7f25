#pragma once

#include <limn/shaderlab/PassProgram.h>

#include "includes/IncludeResolver.h"

#include <functional>

namespace limn
{

/// Gives the file that `#include_with_pragmas` names, from the file that includes it.
using PragmaFileReader =
    std::function<std::optional<IncludedFile>(std::string_view include, std::string_view includer)>;

/// Fills what a program's pragmas say from the text of its chunks; what they said before is gone.
///
/// @param reader  none: pragmas of included files are left out. Theirs get the place of the
///                directive in the .shader file.
void ScanPragmas(PassProgram& program, const PragmaFileReader& reader = {});

} // namespace limn
