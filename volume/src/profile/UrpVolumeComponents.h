#pragma once

#include <string_view>

namespace limn
{

/// Whether URP comes with a volume component of this name. (URP 7 to 17)
bool IsUrpVolumeComponent(std::string_view component);

/// Whether that component has a parameter of this name.
bool IsUrpParameter(std::string_view component, std::string_view parameter);

} // namespace limn
