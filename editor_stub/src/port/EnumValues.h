#pragma once

#include "port/csharp/CSharpFile.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace limn
{

/// The number of each member of an enum, in their order; nothing from the first one on whose value
/// is not made of numbers and members of the enum.
std::vector<std::optional<std::int64_t>> EnumValues(const CSharpClass& one);

} // namespace limn
