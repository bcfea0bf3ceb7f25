#include "parser/Lexer.h"

#include <limn/base/TerminalText.h>
#include <limn/base/Text.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <span>

namespace limn
{

namespace
{

constexpr std::string_view k_ByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view k_NoBreakSpace = "\xC2\xA0";
constexpr std::string_view k_IdeographicSpace = "\xE3\x80\x80";

/// End of the comment that starts at `begin`, comments within it counted; npos if the text ends
/// first.
std::size_t NestedCommentEnd(std::string_view text, std::size_t begin)
{
    std::size_t depth = 0;
    std::size_t i = begin;
    while (i + 1 < text.size())
    {
        if (text[i] == '/' && text[i + 1] == '*')
        {
            ++depth;
            i += 2;
        }
        else if (text[i] == '*' && text[i + 1] == '/')
        {
            i += 2;
            if (--depth == 0)
            {
                return i;
            }
        }
        else
        {
            i = std::min(text.find_first_of("/*", i + 1), text.size());
        }
    }
    return std::string_view::npos;
}

/// Returns the value of a number that no float can hold: 0 if it is too small, otherwise the
/// largest float.
float Saturated(std::string_view text)
{
    const bool isSmall =
        text.find("e-") != text.npos || text.find("E-") != text.npos ||
        text.substr(0, std::min(text.find('.'), text.size())).find_first_of("123456789") ==
            text.npos;
    return isSmall ? 0.0f : std::numeric_limits<float>::max();
}

constexpr std::string_view k_EndWords[] = {"ENDCG", "ENDHLSL", "ENDGLSL"};
constexpr std::string_view k_Openers[] = {"CGPROGRAM", "HLSLPROGRAM", "GLSLPROGRAM",
                                          "CGINCLUDE", "HLSLINCLUDE", "GLSLINCLUDE"};

bool isAnyOf(std::string_view word, std::span<const std::string_view> words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view candidate)
                       { return EqualsIgnoringCase(word, candidate); });
}

/// The meaning of a word outside comments in the search for the end of a block.
enum class BlockWord
{
    None,
    RightEnd,
    OtherEnd,
    Opener
};

BlockWord Classify(std::string_view word, std::string_view endWord)
{
    const char first = ToLower(word[0]);
    if (word.size() < 5 || word.size() > 11 ||
        (first != 'e' && first != 'c' && first != 'h' && first != 'g'))
    {
        return BlockWord::None; // as nearly all words
    }
    if (EqualsIgnoringCase(word, endWord))
    {
        return BlockWord::RightEnd;
    }
    if (isAnyOf(word, k_EndWords))
    {
        return BlockWord::OtherEnd;
    }
    return isAnyOf(word, k_Openers) ? BlockWord::Opener : BlockWord::None;
}

} // namespace

Lexer::Lexer(std::string_view text) : m_Text(text)
{
    // Byte order marks at the start do not count as columns.
    while (m_Text.substr(m_Position, k_ByteOrderMark.size()) == k_ByteOrderMark)
    {
        m_Position += k_ByteOrderMark.size();
    }
    m_LineStart = m_Position;
}

char Lexer::Peek(std::size_t ahead) const
{
    return m_Position + ahead < m_Text.size() ? m_Text[m_Position + ahead] : '\0';
}

void Lexer::SkipTo(std::size_t position)
{
    const char* const text = m_Text.data();
    while (m_Position < position)
    {
        const void* const end = std::memchr(text + m_Position, '\n', position - m_Position);
        if (end == nullptr)
        {
            break;
        }
        m_Position = static_cast<std::size_t>(static_cast<const char*>(end) - text) + 1;
        m_LineStart = m_Position;
        ++m_Line;
    }
    m_Position = position;
}

void Lexer::SkipToEnd()
{
    m_Position = m_Text.size();
}

std::size_t Lexer::Find(Finding& finding, std::string_view text, std::size_t from) const
{
    if (from < finding.from || from > finding.to)
    {
        finding = {from, m_Text.find(text, from)};
    }
    return finding.to;
}

std::size_t Lexer::BlockCommentEnd(std::size_t position)
{
    if (m_CommentsNest)
    {
        const std::size_t end = NestedCommentEnd(m_Text, position);
        m_CommentsNest = end != std::string_view::npos;
        if (m_CommentsNest)
        {
            return end;
        }
    }
    const std::size_t end = Find(m_CommentClose, "*/", position + 2);
    if (end == std::string_view::npos)
    {
        m_OpenComment = {m_Line, static_cast<int>(position - m_LineStart) + 1};
        return m_Text.size();
    }
    return end + 2;
}

bool Lexer::SkipComment()
{
    const bool isLine = Peek(1) == '/';
    if (isLine || Peek(1) == '*')
    {
        SkipTo(isLine ? std::min(m_Text.find('\n', m_Position), m_Text.size())
                      : BlockCommentEnd(m_Position));
        return true;
    }
    return false;
}

std::size_t Lexer::SpecialBlank() const
{
    for (const std::string_view blank : {k_ByteOrderMark, k_NoBreakSpace, k_IdeographicSpace})
    {
        if (m_Text.substr(m_Position, blank.size()) == blank)
        {
            return blank.size();
        }
    }
    return 0;
}

void Lexer::SkipBlanks()
{
    while (m_Position < m_Text.size())
    {
        const char c = m_Text[m_Position];
        if (c == '\n')
        {
            m_LineStart = ++m_Position;
            ++m_Line;
        }
        else if (isBlank(c) || c == '\0')
        {
            ++m_Position;
        }
        else if (c == '/' && SkipComment())
        {
            continue;
        }
        else
        {
            const std::size_t special = static_cast<signed char>(c) < 0 ? SpecialBlank() : 0;
            if (special == 0)
            {
                return;
            }
            m_Position += special;
        }
    }
}

Token Lexer::TokenHere(TokenKind kind, std::size_t size) const
{
    Token token;
    token.kind = kind;
    token.text = m_Text.substr(m_Position, size);
    token.location = {m_Line, static_cast<int>(m_Position - m_LineStart) + 1};
    return token;
}

Token Lexer::Next()
{
    SkipBlanks();
    if (m_Position >= m_Text.size())
    {
        return TokenHere(TokenKind::End, 0);
    }
    const char c = Peek();
    if (isLetter(c) || c == '#')
    {
        return ReadWord();
    }
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
    const std::size_t size =
        c == '+' && Peek(1) == '-' ? 2 : PrintableSize(m_Text.substr(m_Position));
    const Token token = TokenHere(TokenKind::Punctuation, std::max<std::size_t>(size, 1));
    m_Position += token.text.size();
    return token;
}

bool Lexer::isNext(char mark)
{
    SkipBlanks();
    return Peek() == mark;
}

Token Lexer::ReadString()
{
    // No escape sequences, and line breaks are allowed: real display names contain whole JSON
    // texts.
    const std::size_t end = m_Text.find('"', m_Position + 1);
    Token token = TokenHere(TokenKind::String, 1);
    token.unterminated = end == std::string_view::npos;
    const std::size_t size = std::min(end, m_Text.size()) - m_Position - 1;
    token.text = m_Text.substr(m_Position + 1, size);
    SkipTo(m_Position + 1 + size + (token.unterminated ? 0 : 1));
    return token;
}

Token Lexer::ReadNumber()
{
    const bool plus = Peek() == '+';
    const bool sign = plus || Peek() == '-';
    const char* const begin = m_Text.data() + m_Position + (plus ? 1 : 0);
    Token token = TokenHere(TokenKind::Number, 0);
    const auto [end, error] = std::from_chars(begin, m_Text.data() + m_Text.size(), token.number);
    std::size_t size = static_cast<std::size_t>(end - (m_Text.data() + m_Position));
    const std::string_view digits = m_Text.substr(m_Position, size);
    token.unusual = plus || error != std::errc{} || digits.find_first_of("eE") != digits.npos;
    if (error != std::errc{})
    {
        const float value = Saturated(digits);
        token.number = digits.front() == '-' ? -value : value;
    }
    const char suffix = ToLower(Peek(size));
    if ((suffix == 'f' || suffix == 'h') && !isWordCharacter(Peek(size + 1)))
    {
        token.unusual = true;
        ++size;
    }
    else if (!sign && isWordCharacter(Peek(size)) && Peek() != '.')
    {
        return ReadWord();
    }
    token.text = m_Text.substr(m_Position, size);
    m_Position += size;
    return token;
}

std::string_view Lexer::WordAt(std::size_t position) const
{
    return Beginning(m_Text.substr(position), isWordCharacter);
}

Token Lexer::ReadWord()
{
    const Token token = TokenHere(TokenKind::Identifier, WordAt(m_Position).size());
    m_Position += token.text.size();
    return token;
}

std::string_view Lexer::ReadBracket(bool& closed)
{
    const std::size_t end = std::min(m_Text.find_first_of("]\n", m_Position), m_Text.size());
    closed = end < m_Text.size() && m_Text[end] == ']';
    const std::string_view text = m_Text.substr(m_Position, end - m_Position);
    m_Position = end + (closed ? 1 : 0);
    return text;
}

std::string_view Lexer::ReadLine()
{
    const std::size_t end = std::min(m_Text.find('\n', m_Position), m_Text.size());
    const std::string_view text = m_Text.substr(m_Position, end - m_Position);
    m_Position = end;
    return text;
}

/// End of the C comment that starts at `position`; `position` itself where none does. An opening
/// mark that nothing closes starts no comment.
std::size_t Lexer::CommentEnd(std::size_t position)
{
    const char second = position + 1 < m_Text.size() ? m_Text[position + 1] : '\0';
    if (second == '/')
    {
        return std::min(Find(m_LineEnd, "\n", position), m_Text.size());
    }
    if (second == '*')
    {
        const std::size_t end = Find(m_CommentClose, "*/", position + 2);
        return end == std::string_view::npos ? position : end + 2;
    }
    return position;
}

/// Takes the first `endWord` in the comment for the end of the block if there is none yet.
void Lexer::LookIntoComment(std::size_t from, std::size_t to, std::string_view endWord,
                            RawBlock& block) const
{
    for (std::size_t i = from; i < to && block.endWord.empty();)
    {
        const std::string_view word = WordAt(i).substr(0, to - i);
        if (EqualsIgnoringCase(word, endWord))
        {
            block.endWord = word;
            block.inComment = true;
        }
        i += std::max<std::size_t>(word.size(), 1);
    }
}

/// Finds the end of a block; its text is still to be cut.
RawBlock Lexer::FindBlockEnd(std::string_view endWord)
{
    std::string_view opener;
    RawBlock second;                          // taken where none of the right ones turns up
    std::size_t searchedFrom = m_Text.size(); // first place outside comments behind it
    std::size_t i = m_Position;
    while (i < m_Text.size())
    {
        if (m_Text[i] == '/')
        {
            const std::size_t end = CommentEnd(i);
            LookIntoComment(i, end, endWord, second);
            i = std::max(end, i + 1);
        }
        else if (isWordCharacter(m_Text[i]))
        {
            const std::string_view word = WordAt(i);
            const BlockWord meaning = Classify(word, endWord);
            if (meaning == BlockWord::RightEnd)
            {
                return {{}, word, false, opener};
            }
            if (meaning == BlockWord::Opener && opener.empty())
            {
                opener = word;
            }
            if (meaning == BlockWord::Opener && !second.endWord.empty())
            {
                break;
            }
            if (meaning == BlockWord::OtherEnd && second.endWord.empty())
            {
                second.endWord = word;
            }
            i += word.size();
        }
        else
        {
            ++i;
            continue;
        }
        if (!second.endWord.empty())
        {
            searchedFrom = std::min(searchedFrom, i);
            if (i >= m_NoBlockEnd.from && i <= m_NoBlockEnd.to)
            {
                return second;
            }
        }
    }
    if (!second.endWord.empty())
    {
        m_NoBlockEnd = {searchedFrom, i};
    }
    return second;
}

RawBlock Lexer::ReadBlock(std::string_view endWord)
{
    RawBlock block = FindBlockEnd(endWord);
    if (!block.endWord.empty())
    {
        const auto end = static_cast<std::size_t>(block.endWord.data() - m_Text.data());
        block.text = m_Text.substr(m_Position, end - m_Position);
        SkipTo(end + block.endWord.size());
    }
    return block;
}

} // namespace limn
