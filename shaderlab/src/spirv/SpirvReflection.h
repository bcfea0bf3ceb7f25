#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include "hlsl/Declarations.h"
#include "stages/StageLinkage.h"

#include <string>
#include <vector>

namespace limn
{

/// Reads the layout of a pass from the SPIR-V of its stages and writes descriptor set 0 and final
/// binding numbers into that SPIR-V.
///
/// @param pass      its SPIR-V is there; its layout is filled
/// @param objects   textures, samplers and buffers as HLSL declares them
/// @param messages  gets what limn cannot bind, without a place
void ReflectLayout(ShaderProgram& pass, const StageLinkage& linkage,
                   const std::vector<HlslVariable>& objects, std::vector<std::string>& messages);

/// The same of a kernel, and its groups' size.
void ReflectKernel(ShaderProgram& kernel, const std::vector<HlslVariable>& objects,
                   std::vector<std::string>& messages);

} // namespace limn
