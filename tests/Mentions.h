#pragma once

#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace limn::test
{

/// Matches a text that has each of these parts, one behind the other. Tests of messages name what a
/// better wording would keep: the place, names, figures, and the words of the cause and the remedy.
MATCHER_P(MentionsInOrder, parts, "has, in this order, " + testing::PrintToString(parts))
{
    const std::string& text = arg;
    std::size_t at = 0;
    for (const std::string& part : parts)
    {
        const std::size_t found = text.find(part, at);
        if (found == std::string::npos)
        {
            *result_listener << "no '" << part << "' stands behind character " << at;
            return false;
        }
        at = found + part.size();
    }
    return true;
}

template <typename... Parts>
auto Mentions(const Parts&... parts)
{
    return MentionsInOrder(std::vector<std::string>{std::string(parts)...});
}

} // namespace limn::test
