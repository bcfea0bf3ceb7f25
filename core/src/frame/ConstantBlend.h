#pragma once

#include <limn/core/Color.h>
#include <limn/core/PipelineState.h>

namespace limn
{

/// Whether blending this colour in leaves every texel as it is, whatever it holds.
/// @param color  linear, what the fragment function gives
bool LeavesTargetAsItIs(const RenderTargetBlendState& blend, const Color& color);

/// Whether what a draw leaves in a target follows from what it draws alone.
bool ReplacesTarget(const RenderTargetBlendState& blend);

/// Whether each component of the colour is left as it is or follows from the draw alone; the alpha
/// may be blended.
bool ReplacesColor(const RenderTargetBlendState& blend);

/// Returns whether a factor of the colour's blending is made of the alpha before.
bool FactorsReadAlpha(const RenderTargetBlendState& blend);

/// Whether the colour that a draw leaves depends on the alpha before.
bool ReadsTargetAlpha(const RenderTargetBlendState& blend);

} // namespace limn
