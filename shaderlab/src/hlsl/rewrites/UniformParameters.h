#pragma once

#include <set>
#include <string>
#include <string_view>

namespace limn
{

/// Preprocessed HLSL in which the `uniform` parameters of entry functions are uniforms of the
/// program, which is what they mean; in other functions they are ordinary parameters. Lines stay
/// where they are.
std::string TakeUniformParameters(std::string text, const std::set<std::string_view>& entries);

} // namespace limn
