#pragma once

#include <string>

namespace limn
{

/// Preprocessed HLSL in which the variables of a `for` loop, if one is used after the loop, are
/// declared before it: Unity's compilers let it live to the end of the block, glslang to the end of
/// the loop. Lines stay where they are.
std::string HoistLoopVariables(std::string text);

} // namespace limn
