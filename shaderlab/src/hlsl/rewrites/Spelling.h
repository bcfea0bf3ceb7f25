#pragma once

#include <limn/shaderlab/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>

#include <string>
#include <vector>

namespace limn
{

/// Preprocessed HLSL with what Unity's compilers take and glslang does not spelt another way:
/// variables called `line` or `triangle`, swizzles of several elements of a matrix, samplers
/// without a texture declared as `sampler`, and what the headers that are included by its source
/// tell. Lines stay where they are.
std::string RespellForGlslang(std::string text, const PassProgram& program,
                              std::vector<Diagnostic>& warnings);

} // namespace limn
