#pragma once

#include <functional>
#include <limn/base/TerminalText.h>
#include <nlohmann/json.hpp>
#include <string>

namespace limn
{

/// The JSON that `--json` and `limn schema` print. Keys stay in the order in which they are
/// written.
using Json = nlohmann::ordered_json;

/// Returns the JSON in the form for people, with an end of line. In names that are no UTF-8, U+FFFD
/// replaces what is invalid.
inline std::string JsonText(const Json& json)
{
    return SeveralLines(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

/// Returns null for "".
inline Json TextOrNull(const std::string& text)
{
    return text.empty() ? Json() : Json(text);
}

/// Returns the list of what `toJson` makes of each item.
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
