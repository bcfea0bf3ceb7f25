#pragma once

#include <string>

namespace limn
{

/// What a person is told about a parameter, beside its name, default and range.
struct ParameterInfo
{
    std::string tooltip = {}; ///< one sentence; Unity's [Tooltip]
    std::string unit = {};    ///< of the number: "pixels", "metres", "degrees"; "" for none
};

} // namespace limn
