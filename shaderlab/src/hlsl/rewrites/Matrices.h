#pragma once

#include <string>

namespace limn
{

/// Preprocessed HLSL in which a cast to a matrix and a swizzle of several elements of one are calls
/// of functions that stand before it: of an integer cast to a matrix glslang takes the bits for
/// floats, and what it makes of the swizzle is not valid. Lines stay where they are.
std::string SpellMatrices(std::string text);

} // namespace limn
