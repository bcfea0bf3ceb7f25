#pragma once

#include <limn/shaderlab/RenderState.h>
#include <string>

namespace limn
{

/// A pass's fixed state as ShaderLab would have it, on one line: "Cull Back, ZTest LEqual, ...".
/// Depth test and write and culling always, the rest where it is not the default.
std::string StateText(const RenderState& state);

} // namespace limn
