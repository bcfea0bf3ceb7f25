#pragma once

#include "shaders/ShaderCheck.h"

namespace limn
{

/// Writes both programs of every compiled pass of the SubShader in use into a folder, which is made
/// if it is not there: <shader>.<pass>.vert.glsl and the like.
/// @param language  "spirv", "glsl" (4.5, Vulkan's), "glsles" (ES 3.0), "msl" or "hlsl" (shader
///                  model 5.0)
/// @return the files written
/// @throws AssetError if a file cannot be written, or the language cannot express a program
std::vector<std::filesystem::path> EmitShader(const ShaderCheck& check, const std::string& language,
                                              const std::filesystem::path& folder);

} // namespace limn
