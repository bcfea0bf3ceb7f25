#pragma once

#include <limn/core/Shader.h>

namespace limn
{

/// Draws any mesh in plain magenta, lit by nothing: what stands in for a shader that does not
/// compile. Unity: Hidden/Core/FallbackError (URP 14).
std::shared_ptr<const Shader> MakeErrorShader(const std::shared_ptr<ShaderCompiler>& compiler);

} // namespace limn
