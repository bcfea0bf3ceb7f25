#pragma once

#include <limn/shaderlab/RenderState.h>

#include <string>
#include <vector>

namespace limn
{

/// Returns a number as ShaderLab writes it, without an exponent and with the fewest digits that
/// read back to the same float.
std::string NumberToShaderLab(float number);

/// Returns the commands that turn `base` into `state`, one per line. A Stencil block has several
/// lines and is indented by four spaces inside.
std::vector<std::string> StateCommands(const RenderState& state, const RenderState& base);

} // namespace limn
