#pragma once

#include <limn/shaderlab/PassProgram.h>

namespace limn
{

/// Fills entry points, target, keyword sets and other pragmas of `program` from its chunks. A later
/// `vertex`, `fragment` or `target` replaces an earlier one.
void ScanPragmas(PassProgram& program);

} // namespace limn
