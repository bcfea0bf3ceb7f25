#pragma once

#include "port/PortModel.h"

#include <string>

namespace limn
{

/// The lines of a generated test that say which objects the feature's filter takes: what the first
/// `new FilteringSettings(...)` of the C# says where that is known, everything elsewhere.
std::string FilterLines(const PortModel& model);

} // namespace limn
