#include "hlsl/ReachableFunctions.h"

#include <algorithm>
#include <span>

namespace limn
{

ReachableFunctions::ReachableFunctions(const HlslTokens& tokens, const HlslGlobals& globals,
                                       std::string_view entry)
    : m_Tokens(tokens), m_IsLeftOut(tokens.size(), false)
{
    for (const HlslFunction& function : globals.declarations().functions)
    {
        Mark(function, true);
    }
    std::vector<std::string_view> pending = {entry};
    const auto addWords = [&](std::size_t first, std::size_t end)
    {
        for (; first < end; ++first)
        {
            if (tokens.isWord(first) && !m_IsLeftOut[first])
            {
                pending.push_back(tokens.Text(first));
            }
        }
    };
    addWords(0, tokens.size());
    while (!pending.empty())
    {
        const auto functions = globals.FindFunctions(pending.back());
        pending.pop_back();
        for (const HlslFunction* function : functions)
        {
            if (m_Functions.insert(function).second)
            {
                Mark(*function, false);
                addWords(function->begin, function->end);
            }
        }
    }
}

void ReachableFunctions::Mark(const HlslFunction& function, bool isLeftOut)
{
    std::fill(m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function.begin),
              m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function.end), isLeftOut);
}

bool ReachableFunctions::Names(std::string_view word) const
{
    const auto names = [&](const HlslFunction* function)
    {
        const auto tokens = std::span(m_Tokens.all()).subspan(function->begin);
        return std::ranges::any_of(tokens.first(function->end - function->begin),
                                   [&](const HlslToken& token) { return token.text == word; });
    };
    return std::ranges::any_of(m_Functions, names);
}

} // namespace limn
