#include "tokens/Tokens.h"

#include "tokens/ColumnFinder.h"
#include "tokens/Lines.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <utility>

namespace limn
{

namespace
{

constexpr std::array<std::string_view, 22> k_Operators = {
    "<<=", ">>=", "==", "!=", "<=", ">=", "+=", "-=", "*=", "/=", "%=",
    "&=",  "|=",  "^=", "++", "--", "&&", "||", "<<", ">>", "::", "->"};

std::size_t TokenLength(std::string_view text)
{
    std::size_t size = 1;
    if (isLetter(text[0]))
    {
        return Beginning(text, isNameCharacter).size();
    }
    if (isDigit(text[0]) || (text[0] == '.' && text.size() > 1 && isDigit(text[1])))
    {
        while (size < text.size() &&
               (isNameCharacter(text[size]) || text[size] == '.' ||
                ((text[size] == '+' || text[size] == '-') && ToLower(text[size - 1]) == 'e')))
        {
            ++size;
        }
        return size;
    }
    if (text[0] == '"')
    {
        return std::min(text.find('"', 1), text.size() - 1) + 1;
    }
    // Most other characters stand for themselves, and nearly all of a shader passes here.
    if (text.size() < 2 || std::string_view("<>=!+-*/%&|^:").find(text[0]) == text.npos ||
        std::string_view("<>=+-&|:").find(text[1]) == text.npos)
    {
        return size;
    }
    const auto found = std::ranges::find_if(k_Operators, [&](std::string_view candidate)
                                            { return text.starts_with(candidate); });
    return found == k_Operators.end() ? size : found->size();
}

} // namespace

int PrecedenceOf(std::string_view text)
{
    constexpr std::pair<std::string_view, int> k_Precedences[] = {
        {"||", 1}, {"&&", 2}, {"|", 3}, {"^", 4},  {"&", 5},  {"==", 6},
        {"!=", 6}, {"<", 7},  {">", 7}, {"<=", 7}, {">=", 7}, {"<<", 8},
        {">>", 8}, {"+", 9},  {"-", 9}, {"*", 10}, {"/", 10}, {"%", 10}};
    const auto* const found =
        std::ranges::find_if(k_Precedences, [&](const auto& item) { return item.first == text; });
    return found == std::end(k_Precedences) ? 0 : found->second;
}

std::vector<HlslToken> TokenizeHlsl(std::string_view source)
{
    std::vector<HlslToken> tokens;
    bool lineStart = true;
    for (std::size_t i = 0; i < source.size();)
    {
        if (isBlank(source[i]))
        {
            lineStart = lineStart || source[i] == '\n';
            ++i;
        }
        else if (source[i] == '#' && lineStart)
        {
            i = std::min(source.find('\n', i), source.size());
        }
        else
        {
            const std::size_t size = TokenLength(source.substr(i));
            tokens.push_back({source.substr(i, size), isLetter(source[i])});
            i += size;
            lineStart = false;
        }
    }
    return tokens;
}

HlslPlace PlaceOf(std::string_view source, std::size_t offset)
{
    HlslPlace place{"", {1, 0}};
    for (std::size_t line = 0; line < source.size();)
    {
        const std::size_t end = std::min(source.find('\n', line), source.size());
        if (offset <= end)
        {
            return place;
        }
        const std::string_view text = Trim(source.substr(line, end - line));
        ++place.location.line;
        if (text.substr(0, 6) == "#line ")
        {
            const std::string_view rest = text.substr(6);
            std::from_chars(rest.data(), rest.data() + rest.size(), place.location.line);
            const std::size_t quote = rest.find('"');
            if (quote != rest.npos)
            {
                place.file =
                    SwapMarks(std::string(rest.substr(quote + 1, rest.rfind('"') - quote - 1)));
            }
        }
        line = end + 1;
    }
    return place;
}

HlslTokens::HlslTokens(std::string_view source, ColumnFinder* lines)
    : m_Source(source),
      m_Lines(lines),
      m_Tokens(TokenizeHlsl(source)),
      m_Partner(m_Tokens.size(), static_cast<std::uint32_t>(m_Tokens.size()))
{
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < m_Tokens.size(); ++i)
    {
        const int step = Step(i);
        if (step > 0)
        {
            open.push_back(i);
        }
        else if (step < 0 && !open.empty())
        {
            m_Partner[i] = open.back();
            m_Partner[open.back()] = i;
            open.pop_back();
        }
    }
}

std::string_view HlslTokens::Span(std::size_t first, std::size_t end) const
{
    if (first >= end || first >= size())
    {
        return {};
    }
    const char* const begin = Text(first).data();
    const std::string_view last = Text(std::min(end, size()) - 1);
    return {begin, static_cast<std::size_t>(last.data() + last.size() - begin)};
}

int HlslTokens::Step(std::size_t index) const
{
    const char mark = index < size() ? m_Tokens[index].Mark() : '\0';
    const bool isOpen = mark == '(' || mark == '[' || mark == '{';
    const bool isClose = mark == ')' || mark == ']' || mark == '}';
    return isOpen ? 1 : isClose ? -1 : 0;
}

std::size_t HlslTokens::AfterBracket(std::size_t index) const
{
    if (Step(index) <= 0)
    {
        return std::min(index + 1, size());
    }
    return std::min<std::size_t>(m_Partner[index] + std::size_t{1}, size());
}

std::size_t HlslTokens::MatchingOpen(std::size_t index) const
{
    return Step(index) < 0 && m_Partner[index] < index ? m_Partner[index] : index;
}

std::size_t HlslTokens::FindOutside(std::size_t index, std::string_view mark) const
{
    while (index < size() && Text(index) != mark && Step(index) >= 0)
    {
        index = AfterBracket(index);
    }
    return std::min(index, size());
}

HlslPlace HlslTokens::Place(std::size_t index) const
{
    const auto isNewLine = [&](std::size_t token)
    {
        const std::size_t end = m_Tokens[token - 1].Begin(m_Source) + Text(token - 1).size();
        return m_Source.substr(end, m_Tokens[token].Begin(m_Source) - end).find('\n') !=
               m_Source.npos;
    };
    HlslPlace place = PlaceOf(m_Source, m_Tokens[index].Begin(m_Source));
    if (m_Lines)
    {
        std::size_t first = index;
        std::size_t end = index + 1;
        for (; first > 0 && !isNewLine(first); --first)
        {
        }
        for (; end < size() && !isNewLine(end); ++end)
        {
        }
        place.location.column =
            m_Lines->Column(place, std::span(m_Tokens).subspan(first, end - first), index - first);
    }
    return place;
}

Diagnostic HlslTokens::Error(std::size_t index, std::string_view message) const
{
    const HlslPlace place = Place(index);
    return {Severity::Error, place.file, place.location,
            "'" + std::string(Text(index)) + "': " + std::string(message)};
}

void HlslTokens::Refuse(const std::vector<HlslProblem>& problems) const
{
    constexpr std::size_t k_MaxTold = 100; // finding the place of each takes its time
    std::vector<Diagnostic> diagnostics;
    for (const HlslProblem& problem : problems)
    {
        if (diagnostics.size() == k_MaxTold)
        {
            diagnostics.back().message +=
                "; " + std::to_string(problems.size() - k_MaxTold) + " more errors are not shown";
            break;
        }
        diagnostics.push_back(Error(problem.token, problem.text));
    }
    if (!diagnostics.empty())
    {
        throw AssetError(std::move(diagnostics));
    }
}

} // namespace limn
