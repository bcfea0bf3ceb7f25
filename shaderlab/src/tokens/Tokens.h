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
    /// Returns the only character of the token, or '\0' if it is longer.
    char Mark() const { return text.size() == 1 ? text[0] : '\0'; }
};

/// Returns the tokens as views into `source`, which must outlive them.
std::vector<HlslToken> TokenizeHlsl(std::string_view source);

/// Returns the precedence of a binary operator, from 1, or 0 if the text is none. The order is that
/// of C.
int PrecedenceOf(std::string_view text);

/// The origin of the character at `offset` of preprocessed text, by the #line directives before it.
struct HlslPlace
{
    std::string file;
    SourceLocation location;
};
HlslPlace PlaceOf(std::string_view source, std::size_t offset);

/// A problem at a token.
struct HlslProblem
{
    std::size_t token = 0;
    std::string text;
};

/// The tokens of a text, and its pairs of brackets.
class HlslTokens
{
public:
    /// @param source  must outlive this
    /// @param lines   gives the columns of places, which are 0 without it; must outlive this
    explicit HlslTokens(std::string_view source, ColumnFinder* lines = nullptr);

    std::size_t size() const { return m_Tokens.size(); }
    /// Returns the text of a token, or "" behind the end.
    std::string_view Text(std::size_t index) const
    {
        return index < m_Tokens.size() ? m_Tokens[index].text : std::string_view();
    }
    bool isWord(std::size_t index) const
    {
        return index < m_Tokens.size() && m_Tokens[index].isWord;
    }
    /// Returns the source from one token to the one before `end`.
    std::string_view Span(std::size_t first, std::size_t end) const;
    /// Returns +1 for an opening bracket, -1 for a closing one, and 0 for other tokens.
    int Step(std::size_t index) const;
    /// Returns the token after the bracket that closes the one at the index, or size() if none
    /// does.
    std::size_t AfterBracket(std::size_t index) const;
    /// Returns the opening bracket of the closing one at the index, or the index itself if there is
    /// none.
    std::size_t MatchingOpen(std::size_t index) const;
    /// Returns the first of the marks at or after the index that is not in brackets opened after
    /// it. Returns a closing bracket that comes first and was opened before, or size() if there is
    /// no mark.
    std::size_t FindOutside(std::size_t index, std::string_view mark) const;
    /// Returns the place of a token in the author's file.
    HlslPlace Place(std::size_t index) const;
    /// Returns the error "'token': message" at the place of a token.
    Diagnostic Error(std::size_t index, std::string_view message) const;
    /// @throws AssetError with all problems, if there are any
    void Refuse(const std::vector<HlslProblem>& problems) const;

    std::string_view source() const { return m_Source; }
    const std::vector<HlslToken>& all() const { return m_Tokens; }

private:
    std::string_view m_Source;
    ColumnFinder* m_Lines;
    std::vector<HlslToken> m_Tokens;
    /// The partner of a bracket; size() for other tokens and for brackets without one.
    std::vector<std::uint32_t> m_Partner;
};

} // namespace limn
