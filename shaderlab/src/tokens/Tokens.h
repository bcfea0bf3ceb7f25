#pragma once

#include <limn/base/Diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

class ColumnFinder;

/// A token of preprocessed HLSL. Directives and blanks lie between tokens.
struct HlslToken
{
    std::string_view text;
    bool isWord = false; ///< identifier or keyword

    std::size_t Begin(std::string_view source) const
    {
        return static_cast<std::size_t>(text.data() - source.data());
    }
    /// The character that it is; '\0' of longer ones.
    char Mark() const { return text.size() == 1 ? text[0] : '\0'; }
};

/// Views into `source`, which must outlive them.
std::vector<HlslToken> TokenizeHlsl(std::string_view source);

/// Returns how tightly an operator between two values binds, from 1; 0 for what is none. C has the
/// same order.
int PrecedenceOf(std::string_view text);

/// Where the character at `offset` of preprocessed text came from, by the #line directives before
/// it.
struct HlslPlace
{
    std::string file;
    SourceLocation location;
};
HlslPlace PlaceOf(std::string_view source, std::size_t offset);

/// What is wrong at a token.
struct HlslProblem
{
    std::size_t token = 0;
    std::string text;
};

/// The tokens of a text, and which brackets belong together.
class HlslTokens
{
public:
    /// @param source  must outlive this
    /// @param lines   for the columns of places, which are 0 without; outlives this
    explicit HlslTokens(std::string_view source, ColumnFinder* lines = nullptr);

    std::size_t size() const { return m_Tokens.size(); }
    /// "" behind the end.
    std::string_view Text(std::size_t index) const
    {
        return index < m_Tokens.size() ? m_Tokens[index].text : std::string_view();
    }
    bool isWord(std::size_t index) const
    {
        return index < m_Tokens.size() && m_Tokens[index].isWord;
    }
    /// The source from one token to the one before `end`.
    std::string_view Span(std::size_t first, std::size_t end) const;
    /// +1 for a bracket that opens, -1 for one that closes, else 0.
    int Step(std::size_t index) const;
    /// The token after the bracket that closes the one at the index; behind all where none does.
    std::size_t AfterBracket(std::size_t index) const;
    /// The bracket that opens the one that closes at the index; the index where none does.
    std::size_t MatchingOpen(std::size_t index) const;
    /// The first of the marks at or after the index that is not in brackets opened after it; where
    /// a bracket closes that was opened before, that one; else size().
    std::size_t FindOutside(std::size_t index, std::string_view mark) const;
    /// Where a token is in the author's file.
    HlslPlace Place(std::size_t index) const;
    /// "'token': message", there.
    Diagnostic Error(std::size_t index, std::string_view message) const;
    /// @throws AssetError  with all problems, if there are any
    void Refuse(const std::vector<HlslProblem>& problems) const;

    std::string_view source() const { return m_Source; }
    const std::vector<HlslToken>& all() const { return m_Tokens; }

private:
    std::string_view m_Source;
    ColumnFinder* m_Lines;
    std::vector<HlslToken> m_Tokens;
    std::vector<std::uint32_t> m_Partner; ///< of brackets; of others, and without one: size()
};

} // namespace limn
