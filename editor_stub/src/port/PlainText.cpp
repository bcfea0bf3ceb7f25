#include "port/PortExpression.h"

namespace limn
{

namespace
{

/// C++ once had characters that begin with ??.
std::string WithoutTrigraphs(std::string text)
{
    for (std::size_t at = text.find("??"); at != std::string::npos; at = text.find("??", at))
    {
        text.insert(++at, "\\");
    }
    return text;
}

} // namespace

std::optional<std::vector<CSharpWords>> NewArguments(CSharpWords words)
{
    for (std::size_t i = 0; i < words.size() && words.front().Is("new"); ++i)
    {
        if (words[i].Is("("))
        {
            return SplitArguments(
                words.subspan(i + 1, static_cast<std::size_t>(words[i].match) - 1));
        }
    }
    return std::nullopt;
}

std::optional<std::string> PlainText(CSharpWords words)
{
    if (words.size() > 2 && words.size() % 2 == 1 && words[1].Is("+"))
    {
        const auto first = PlainText(words.first(1));
        const auto rest = PlainText(words.subspan(2));
        return first && rest ? std::optional(WithoutTrigraphs(*first + *rest)) : std::nullopt;
    }
    if (words.size() != 1 || words[0].kind != CSharpTokenKind::String)
    {
        return std::nullopt;
    }
    const std::string_view text = words[0].text;
    const bool isPlain = text.size() >= 2 && text[0] == '"' && !text.starts_with("\"\"\"");
    const std::string_view inner = isPlain ? text.substr(1, text.size() - 2) : "\\";
    for (std::size_t at = inner.find('\\'); at < inner.size(); at = inner.find('\\', at + 2))
    {
        if (at + 1 >= inner.size() ||
            std::string_view("\\\"nt").find(inner[at + 1]) == std::string_view::npos)
        {
            return std::nullopt;
        }
    }
    return WithoutTrigraphs(std::string(inner));
}

} // namespace limn
