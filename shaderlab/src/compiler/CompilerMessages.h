#pragma once

#include <limn/base/Diagnostic.h>

#include "lowering/StageLowering.h"

#include <vector>

namespace limn
{

/// What the compiler says of the rewritten text, at the author's places: its lines are tokens. What
/// it says only because something else is wrong in the same expression is left out.
///
/// @param hlsl  is of the source
std::vector<Diagnostic> PlaceMessages(const std::vector<Diagnostic>& messages,
                                      const HlslSource& source, const RewrittenHlsl& hlsl);

/// Types and names that nobody declares, each once; the types first, each with the name that may be
/// meant.
std::vector<Diagnostic> DescribeUndeclared(const HlslSource& source, const RewrittenHlsl& hlsl);

} // namespace limn
