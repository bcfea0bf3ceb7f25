#pragma once

#include <limn/base/Diagnostic.h>

#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Returns the messages of a glslang log as diagnostics: one per line of source, without glslang's
/// summaries and with types spelt as in HLSL. A message without a place gets `fallbackFile`.
std::vector<Diagnostic> ReadGlslangLog(std::string_view log, const std::string& fallbackFile);

} // namespace limn
