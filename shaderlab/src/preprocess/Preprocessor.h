#pragma once

#include <limn/shaderlab/PassProgram.h>

#include "includes/IncludeResolver.h"
#include "tokens/ColumnFinder.h"

#include <span>
#include <string>
#include <vector>

namespace limn
{

struct PreprocessedHlsl
{
    std::string text;
    /// The text names a SHADER_STAGE_… macro, so other stages may have another text. Most programs
    /// name none, and then one run of the preprocessor serves all stages.
    bool namesStages = false;
};

/// Returns the HLSL of one stage with all includes and macros resolved. Its `#line N "file"`
/// directives say where each line comes from; of the other directives only `#pragma pack_matrix` is
/// left.
///
/// @param warnings  receives those of `#warning` and of glslang
/// @throws AssetError at the lines of unknown includes and other mistakes
/// @throws UnsupportedProgramError where a file of another render pipeline is missing
PreprocessedHlsl PreprocessHlsl(const PassProgram& program, ShaderStage stage,
                                std::span<const std::string> keywords, IncludeResolver& resolver,
                                ColumnFinder& lines, std::vector<Diagnostic>& warnings);

} // namespace limn
