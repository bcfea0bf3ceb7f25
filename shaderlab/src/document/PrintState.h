#pragma once

#include <limn/shaderlab/RenderState.h>

#include <string>
#include <vector>

namespace limn
{

/// A number as ShaderLab writes it: no exponent, the fewest digits that read back to the same
/// float.
std::string NumberToShaderLab(float number);

/// The commands that turn `base` into `state`, one a line; a Stencil block is several lines,
/// indented by four spaces inside.
std::vector<std::string> StateCommands(const RenderState& state, const RenderState& base);

} // namespace limn
