#pragma once

#include <set>
#include <string>
#include <string_view>

namespace limn
{

/// HLSL with overloads of the named functions that take larger arguments and cut them to what the
/// function wants: a float4x4 where it has a float3x3, a vector where it has a scalar. The language
/// does so by itself; glslang only from vector to vector. Lines stay where they are.
std::string AddConversions(const std::string& hlsl, const std::set<std::string>& functions);

} // namespace limn
