#pragma once

#include "port/ClassIndex.h"

namespace limn
{

/// What C++ calls an int that holds a property's number.
inline constexpr const char* k_PropertyIdType = "ShaderPropertyId";

/// Gives the fields and parameters of type int that hold what Shader.PropertyToID gives, or are
/// taken for a property's number, the type ShaderPropertyId, and lists and arrays of such ints that
/// of their elements.
void MarkPropertyIds(const CSharpFiles& files);

} // namespace limn
