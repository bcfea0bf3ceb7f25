#include "parser/Lexer.h"

#include <limn/base/Text.h>

#include <algorithm>
#include <span>

namespace limn
{

namespace
{

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
                            BlockEnd& end) const
{
    for (std::size_t i = from; i < to && end.begin == std::string_view::npos;)
    {
        const std::size_t wordEnd = std::min(WordEnd(i), to);
        if (EqualsIgnoringCase(m_Text.substr(i, wordEnd - i), endWord))
        {
            end = {i, wordEnd - i, true};
        }
        i = std::max(wordEnd, i + 1);
    }
}

Lexer::BlockEnd Lexer::FindBlockEnd(std::string_view endWord)
{
    constexpr std::size_t npos = std::string_view::npos;
    std::string_view opener;
    BlockEnd second;                 // taken where none of the right ones turns up
    std::size_t searchedFrom = npos; // first place outside comments behind it
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
            const std::size_t size = WordEnd(i) - i;
            const BlockWord meaning = Classify(m_Text.substr(i, size), endWord);
            if (meaning == BlockWord::RightEnd)
            {
                return {i, size, false, opener};
            }
            if (meaning == BlockWord::Opener && opener.empty())
            {
                opener = m_Text.substr(i, size);
            }
            if (meaning == BlockWord::Opener && second.begin != npos)
            {
                break;
            }
            if (meaning == BlockWord::OtherEnd && second.begin == npos)
            {
                second = {i, size, false};
            }
            i += size;
        }
        else
        {
            ++i;
            continue;
        }
        if (second.begin != npos)
        {
            searchedFrom = std::min(searchedFrom, i);
            if (i >= m_NoBlockEnd.from && i <= m_NoBlockEnd.to)
            {
                return second;
            }
        }
    }
    if (second.begin != npos)
    {
        m_NoBlockEnd = {searchedFrom, i};
    }
    return second;
}

RawBlock Lexer::ReadBlock(std::string_view endWord)
{
    const BlockEnd end = FindBlockEnd(endWord);
    if (end.begin == std::string_view::npos)
    {
        return {m_Text.substr(m_Position), {}, false, {}};
    }
    RawBlock block{m_Text.substr(m_Position, end.begin - m_Position),
                   m_Text.substr(end.begin, end.size), end.inComment, end.opener};
    SkipTo(end.begin + end.size);
    return block;
}

} // namespace limn
