#pragma once

#include <limn/base/Diagnostic.h>

#include "lowering/StageLowering.h"

#include <vector>

namespace limn
{

/// Returns the compiler's messages about the rewritten text, whose lines are tokens, with the
/// places in the author's files. Messages that only follow from another mistake in the same
/// expression are left out.
///
/// @param hlsl  the rewritten text of the source
std::vector<Diagnostic> PlaceMessages(const std::vector<Diagnostic>& messages,
                                      const HlslSource& source, const RewrittenHlsl& hlsl);

/// Describes types and names that are not declared, each once; the types come first, each with the
/// name that may be meant.
std::vector<Diagnostic> DescribeUndeclared(const HlslSource& source, const RewrittenHlsl& hlsl);

} // namespace limn
