#pragma once

#include <algorithm>
#include <initializer_list>
#include <limn/base/Lists.h>
#include <limn/base/NumberText.h>
#include <limn/base/Text.h>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

inline bool StartsWithAny(std::string_view text, std::initializer_list<std::string_view> beginnings)
{
    return std::ranges::any_of(beginnings, [text](auto one) { return text.starts_with(one); });
}

/// Returns the text with `value` in place of each `what`.
inline std::string Replaced(std::string text, std::string_view what, std::string_view value)
{
    for (std::size_t at = text.find(what); at != std::string::npos;
         at = text.find(what, at + value.size()))
    {
        text.replace(at, what.size(), value);
    }
    return text;
}

/// Returns the texts between the separators, one more than there are separators.
inline std::vector<std::string> SplitText(const std::string& text, char separator)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
    {
        end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
    }
    return parts;
}

} // namespace limn
