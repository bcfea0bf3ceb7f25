#pragma once

#include <string>
#include <typeindex>

namespace limn
{

/// A type's name as C++ writes it, without the namespace limn.
std::string TypeName(std::type_index type);

} // namespace limn
