#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include "hlsl/Declarations.h"
#include "stages/StageLinkage.h"

#include <string>
#include <vector>

namespace limn
{

/// Reads the layout of a pass or kernel from the SPIR-V of its stages, and the size of a kernel's
/// groups. Writes descriptor set 0 and final binding numbers into that SPIR-V.
///
/// @param pass      must have its SPIR-V; receives its layout
/// @param objects   the textures, samplers and buffers that HLSL declares
/// @param messages  receives what limn cannot bind, without a place
void ReflectLayout(ShaderProgram& pass, const StageLinkage& linkage,
                   const std::vector<HlslVariable>& objects, std::vector<std::string>& messages);

} // namespace limn
