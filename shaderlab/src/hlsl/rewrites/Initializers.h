#pragma once

#include <string>

namespace limn
{

/// Preprocessed HLSL in which the numbers that an array of vectors or matrices is initialised with
/// stand in constructors: `float2 a[] = {1, 2, float2(3, 4)}` means `{float2(1, 2), float2(3, 4)}`,
/// which glslang does not see by itself. Lines stay where they are.
std::string GroupInitializers(std::string text);

} // namespace limn
