#include "Lexer.h"

#include "Text.h"

#include <algorithm>
#include <charconv>

namespace limn
{

namespace
{

constexpr std::string_view k_ByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view k_NoBreakSpace = "\xC2\xA0";
constexpr std::string_view k_IdeographicSpace = "\xE3\x80\x80";

// Unity's lexer counts '#' among the letters.
bool isWordCharacter(char c)
{
    return isLetter(c) || isDigit(c) || c == '#';
}

bool isWholeWord(std::string_view text, std::size_t position, std::size_t size)
{
    const bool freeBefore = position == 0 || !isWordCharacter(text[position - 1]);
    const std::size_t end = position + size;
    return freeBefore && (end >= text.size() || !isWordCharacter(text[end]));
}

/// Offset of `word` as a whole word in any case, npos if absent; comments are passed over if asked.
std::size_t FindWord(std::string_view text, std::string_view word, bool skipComments)
{
    for (std::size_t i = 0; i + word.size() <= text.size(); ++i)
    {
        if (skipComments && text.substr(i, 2) == "//")
        {
            i = std::min(text.find('\n', i), text.size());
        }
        else if (skipComments && text.substr(i, 2) == "/*")
        {
            const std::size_t end = text.find("*/", i + 2);
            i = end == std::string_view::npos ? text.size() : end + 1;
        }
        else if (EqualsIgnoringCase(text.substr(i, word.size()), word) &&
                 isWholeWord(text, i, word.size()))
        {
            return i;
        }
    }
    return std::string_view::npos;
}

/// Length of the comment that `text` starts with. Unity nests block comments; where that leads to
/// the end of the file, the first closing mark ends the comment.
std::size_t BlockCommentLength(std::string_view text)
{
    int depth = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i)
    {
        const std::string_view pair = text.substr(i, 2);
        if (pair == "/*")
        {
            ++depth;
            ++i;
        }
        else if (pair == "*/")
        {
            ++i;
            if (--depth == 0)
            {
                return i + 1;
            }
        }
    }
    const std::size_t end = text.find("*/", 2);
    return end == std::string_view::npos ? text.size() : end + 2;
}

std::size_t SpecialBlankLength(std::string_view text)
{
    for (const std::string_view blank : {k_ByteOrderMark, k_NoBreakSpace, k_IdeographicSpace})
    {
        if (text.substr(0, blank.size()) == blank)
        {
            return blank.size();
        }
    }
    return 0;
}

} // namespace

Lexer::Lexer(std::string_view text) : m_Text(text) {}

char Lexer::Peek(std::size_t ahead) const
{
    return m_Position + ahead < m_Text.size() ? m_Text[m_Position + ahead] : '\0';
}

void Lexer::Skip(std::size_t count)
{
    for (; count > 0 && m_Position < m_Text.size(); --count, ++m_Position)
    {
        if (m_Text[m_Position] == '\n')
        {
            ++m_Location.line;
            m_Location.column = 1;
        }
        else
        {
            ++m_Location.column;
        }
    }
}

void Lexer::Rewind(Mark mark)
{
    m_Position = mark.position;
    m_Location = mark.location;
}

bool Lexer::SkipComment()
{
    const std::string_view rest = m_Text.substr(m_Position);
    if (rest.substr(0, 2) == "//")
    {
        Skip(std::min(rest.find('\n'), rest.size()));
        return true;
    }
    if (rest.substr(0, 2) == "/*")
    {
        Skip(BlockCommentLength(rest));
        return true;
    }
    return false;
}

void Lexer::SkipBlanks()
{
    while (m_Position < m_Text.size())
    {
        const std::size_t special = SpecialBlankLength(m_Text.substr(m_Position));
        if (special > 0)
        {
            // A byte order mark at the very start does not count as a column.
            const bool first = m_Position == 0 || m_Location == SourceLocation{1, 1};
            Skip(special);
            m_Location.column = first ? 1 : m_Location.column;
        }
        else if (isBlank(Peek()))
        {
            Skip(1);
        }
        else if (!SkipComment())
        {
            return;
        }
    }
}

Token Lexer::Next()
{
    SkipBlanks();
    if (m_Position >= m_Text.size())
    {
        return {TokenKind::End, {}, m_Location};
    }
    const char c = Peek();
    if (c == '"')
    {
        return ReadString();
    }
    const bool sign = c == '-' || c == '+';
    const char first = sign ? Peek(1) : c;
    if (isDigit(first) || (first == '.' && isDigit(Peek(sign ? 2 : 1))))
    {
        return ReadNumber();
    }
    if (isLetter(c) || c == '#')
    {
        return ReadWord();
    }
    Token token{TokenKind::Punctuation, m_Text.substr(m_Position, 1), m_Location};
    if (c == '+' && Peek(1) == '-')
    {
        token.text = m_Text.substr(m_Position, 2);
    }
    Skip(token.text.size());
    return token;
}

Token Lexer::ReadString()
{
    // No escape sequences, and line breaks are allowed: real display names contain whole JSON
    // texts.
    const std::size_t end = m_Text.find('"', m_Position + 1);
    Token token{TokenKind::String, m_Text.substr(m_Position + 1), m_Location};
    token.unterminated = end == std::string_view::npos;
    if (!token.unterminated)
    {
        token.text = m_Text.substr(m_Position + 1, end - m_Position - 1);
    }
    Skip(token.text.size() + 2);
    return token;
}

Token Lexer::ReadNumber()
{
    const std::size_t sign = Peek() == '+' || Peek() == '-' ? 1 : 0;
    const char* const begin = m_Text.data() + m_Position + (Peek() == '+' ? 1 : 0);
    Token token{TokenKind::Number, {}, m_Location};
    const auto [end, error] = std::from_chars(begin, m_Text.data() + m_Text.size(), token.number);
    std::size_t size = static_cast<std::size_t>(end - (m_Text.data() + m_Position));
    if (error != std::errc{})
    {
        token.number = 0.0;
    }
    const char suffix = ToLower(Peek(size));
    if ((suffix == 'f' || suffix == 'h') && !isWordCharacter(Peek(size + 1)))
    {
        ++size;
    }
    else if (sign == 0 && isWordCharacter(Peek(size)))
    {
        return ReadWord();
    }
    token.text = m_Text.substr(m_Position, size);
    Skip(size);
    return token;
}

Token Lexer::ReadWord()
{
    std::size_t size = 1;
    while (isWordCharacter(Peek(size)))
    {
        ++size;
    }
    const Token token{TokenKind::Identifier, m_Text.substr(m_Position, size), m_Location};
    Skip(size);
    return token;
}

std::string_view Lexer::ReadBracket(bool& closed)
{
    const std::string_view rest = m_Text.substr(m_Position);
    const std::size_t end = rest.find_first_of("]\n");
    closed = end != std::string_view::npos && rest[end] == ']';
    const std::string_view text = rest.substr(0, end);
    Skip(text.size() + (closed ? 1 : 0));
    return text;
}

std::string_view Lexer::ReadBlock(std::string_view endWord, bool& found)
{
    const std::string_view rest = m_Text.substr(m_Position);
    std::size_t end = FindWord(rest, endWord, true);
    if (end == std::string_view::npos)
    {
        end = FindWord(rest, endWord, false);
    }
    found = end != std::string_view::npos;
    const std::string_view text = rest.substr(0, end);
    Skip(text.size() + (found ? endWord.size() : 0));
    return text;
}

} // namespace limn
