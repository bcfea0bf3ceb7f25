#pragma once

#include "hlsl/Rewriter.h"

namespace limn
{

/// Refuses what glslang 12 crashes on instead of complaining: uniforms whose name is taken, and
/// methods called on what a function returns.
///
/// @throws AssetError with all of them
void RequireSound(const HlslSource& source);

} // namespace limn
