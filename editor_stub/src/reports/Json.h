#pragma once

#include <nlohmann/json.hpp>

namespace limn
{

/// What `--json` and `limn schema` print: keys stay in the order they are written in.
using Json = nlohmann::ordered_json;

} // namespace limn
