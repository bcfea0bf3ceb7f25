#include "yaml/Text.h"

#include <algorithm>
#include <limn/base/TerminalText.h>

namespace limn
{

std::optional<std::size_t> FindNonText(std::string_view text)
{
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t length = text[at] == '\0' ? 0 : DecodeCharacter(text.substr(at)).size;
        if (length == 0)
        {
            return at;
        }
        at += length;
    }
    return std::nullopt;
}

SourceLocation LocationOf(std::string_view text, std::size_t offset, int firstLine)
{
    const std::string_view before = text.substr(0, offset);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    return {static_cast<int>(lines) + firstLine, static_cast<int>(offset - lineStart) + 1};
}

std::size_t EndOfQuotes(std::string_view text)
{
    if (!text.starts_with('"') && !text.starts_with('\''))
    {
        return 0;
    }
    const char quote = text.front();
    for (std::size_t i = 1; i < text.size(); ++i)
    {
        const bool isDoubled = quote == '\'' && text.substr(i, 2) == "''";
        if (isDoubled || (quote == '"' && text[i] == '\\'))
        {
            ++i;
        }
        else if (text[i] == quote)
        {
            return i + 1;
        }
    }
    return text.npos;
}

bool IsQuoteClosed(std::string_view text, std::size_t offset)
{
    return EndOfQuotes(WithoutMarks(text.substr(std::min(offset, text.size())))) != text.npos;
}

std::string_view WithoutMarks(std::string_view text)
{
    while (!text.empty() && (text.front() == '&' || text.front() == '!'))
    {
        text.remove_prefix(std::min(text.find_first_of(" \t\r\n"), text.size()));
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    }
    return text;
}

std::string InQuotes(const std::string& text, char quote)
{
    constexpr std::string_view k_Control = "\n\r\t";
    std::string quoted(1, quote);
    for (const char c : text)
    {
        const std::size_t control = quote == '"' ? k_Control.find(c) : k_Control.npos;
        const bool isSpecial =
            c == quote || (quote == '"' && c == '\\') || control != k_Control.npos;
        quoted += isSpecial ? std::string(1, quote == '"' ? '\\' : c) : std::string();
        quoted += control != k_Control.npos ? "nrt"[control] : c;
    }
    return quoted + quote;
}

} // namespace limn
