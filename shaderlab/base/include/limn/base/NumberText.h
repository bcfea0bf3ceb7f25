#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn
{

/// Returns a number as a person writes it, without trailing zeros: "3", "0.25".
std::string NumberText(double number);

/// Returns a count with its noun, plural unless it is 1: "3 samples", "1 sample".
std::string CountText(std::size_t count, std::string_view noun);

} // namespace limn
