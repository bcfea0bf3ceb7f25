#pragma once

#include <limn/base/TerminalText.h>
#include <nlohmann/json.hpp>
#include <string>

namespace limn
{

/// What `--json` and `limn schema` print: keys stay in the order they are written in.
using Json = nlohmann::ordered_json;

/// As people read it, with a line's end; names that are no UTF-8 get U+FFFD in place of what is
/// none.
inline std::string JsonText(const Json& json)
{
    return SeveralLines(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

} // namespace limn
