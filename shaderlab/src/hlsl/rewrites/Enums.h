#pragma once

#include <string>

namespace limn
{

/// Preprocessed HLSL in which enumerators are integer constants and the types of `enum`s int, which
/// is all that they mean; glslang does not read them. Lines stay where they are.
std::string SpellEnums(std::string text);

} // namespace limn
