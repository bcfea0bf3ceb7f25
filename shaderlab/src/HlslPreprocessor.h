#pragma once

#include <limn/shaderlab/PassProgram.h>

#include "IncludeResolver.h"

#include <span>
#include <string>
#include <vector>

namespace limn
{

/// The HLSL of one stage with all includes and macros resolved. `#line N "file"` directives in it
/// say where each line comes from; no other directives but `#pragma pack_matrix` are left.
///
/// @param warnings  gets those of `#warning` and of glslang
/// @throws AssetError at the lines of unknown includes and other mistakes
/// @throws UnsupportedProgramError where a file of another render pipeline is missing
std::string PreprocessHlsl(const PassProgram& program, ShaderStage stage,
                           std::span<const std::string> keywords, IncludeResolver& resolver,
                           std::vector<Diagnostic>& warnings);

} // namespace limn
