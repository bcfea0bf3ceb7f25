#pragma once

#include "console/Console.h"
#include "shaders/ShaderCheck.h"

namespace limn
{

/// Warns of keywords that no pass of the shaders declares, with those that there are.
void PrintUnknownKeywords(const std::vector<ShaderCheck>& checks,
                          const std::vector<std::string>& keywords, Console& console);

} // namespace limn
