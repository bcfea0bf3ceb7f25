#pragma once

#include <limn/shaderlab/PassProgram.h>

#include "program/IncludeResolver.h"

#include <vector>

namespace limn
{

/// Gives diagnostics that have a line only the column of the word they name, where that line of the
/// file holds it; glslang counts no columns. Words that macros make are in no line.
void AddColumns(std::vector<Diagnostic>& diagnostics, const PassProgram& program,
                IncludeResolver& resolver);

} // namespace limn
