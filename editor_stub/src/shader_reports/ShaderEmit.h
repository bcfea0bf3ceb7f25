#pragma once

#include "shader_reports/ShaderCheck.h"

#include <set>

namespace limn
{

/// Writes both programs of every compiled pass of the SubShader in use into a folder, which is made
/// if it is not there: <shader>.<pass>.vert.glsl and the like.
/// @param language  "spirv", "glsl" (4.5, Vulkan's), "glsles" (ES 3.0), "msl" or "hlsl" (shader
///                  model 5.0)
/// @param stem  the beginning of the files' names
/// @return the files written
/// @throws AssetError if a file cannot be written, or the language cannot express a program
std::vector<std::filesystem::path> EmitShader(const ShaderCheck& check, const std::string& language,
                                              const std::filesystem::path& folder,
                                              const std::string& stem);

/// Makes the beginnings of the names of shaders' files: a shader's own name without the characters
/// that a file name cannot have. If several are equal, the second one gets "-2" behind it, and so
/// on.
class EmittedStems
{
public:
    std::string Take(const std::string& shaderName);

private:
    std::set<std::string> m_Taken; ///< in lower case, since some disks ignore case
};

} // namespace limn
