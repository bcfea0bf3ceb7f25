#pragma once

#include <string>

namespace limn
{

/// Preprocessed HLSL with what Unity's compilers take and glslang does not spelt another way:
/// variables called `line` or `triangle`, swizzles of several elements of a matrix, samplers
/// without a texture declared as `sampler`, loop variables that outlive their loop. Lines stay
/// where they are.
std::string RespellForGlslang(std::string text);

} // namespace limn
