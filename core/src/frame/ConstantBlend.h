#pragma once

#include <limn/core/Color.h>
#include <limn/core/PipelineState.h>

namespace limn
{

/// Returns whether blending this colour in leaves every texel as it is, whatever it holds.
/// @param color  linear, the result of the fragment function
bool LeavesTargetAsItIs(const RenderTargetBlendState& blend, const Color& color);

/// Returns whether the target's contents after a draw follow from the draw alone.
bool ReplacesTarget(const RenderTargetBlendState& blend);

/// Returns whether each component of the colour stays as it is or follows from the draw alone; the
/// alpha may be blended.
bool ReplacesColor(const RenderTargetBlendState& blend);

/// Returns whether a factor of the colour's blending is made from the target's alpha.
bool FactorsReadAlpha(const RenderTargetBlendState& blend);

/// Returns whether the colour after a draw depends on the target's alpha.
bool ReadsTargetAlpha(const RenderTargetBlendState& blend);

} // namespace limn
