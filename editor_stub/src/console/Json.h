#pragma once

#include <functional>
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

/// The list of what `toJson` makes of each item.
template <typename Items, typename Make>
Json JsonList(const Items& items, const Make& toJson)
{
    Json list = Json::array();
    for (const auto& item : items)
    {
        list.push_back(std::invoke(toJson, item));
    }
    return list;
}

} // namespace limn
