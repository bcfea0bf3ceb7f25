#pragma once

#include <limn/shaderlab/Diagnostic.h>

#include <cstddef>
#include <string_view>

namespace limn
{

enum class TokenKind
{
    End,
    Identifier, ///< also words that start with a digit: 2D, 2DArray, 3D
    Number,
    String,     ///< `text` is without the quotes
    Punctuation ///< one character, or "+-"
};

/// A word of ShaderLab; `text` points into the file.
struct Token
{
    TokenKind kind = TokenKind::End;
    std::string_view text;
    SourceLocation location;
    double number = 0.0;       ///< of a Number
    bool unterminated = false; ///< a String that the file ends in
};

/// Cuts ShaderLab text into tokens, one at a time, so that the parser can switch to raw text for
/// program blocks and attributes.
class Lexer
{
public:
    explicit Lexer(std::string_view text);

    Token Next();

    /// A place to return to; used where a token that was read ahead turns out to be raw text.
    struct Mark
    {
        std::size_t position = 0;
        SourceLocation location{1, 1};
    };
    Mark mark() const { return {m_Position, m_Location}; }
    void Rewind(Mark mark);

    /// The text up to the first ']' of this line, which is passed over. Attributes know no
    /// brackets, quotes or parentheses. Without a ']' the rest of the line.
    std::string_view ReadBracket(bool& closed);

    /// The text up to the whole word `endWord`, which is passed over; the first one outside
    /// comments, else the first one at all. Without one, the rest of the file and found = false.
    std::string_view ReadBlock(std::string_view endWord, bool& found);

private:
    char Peek(std::size_t ahead = 0) const;
    void Skip(std::size_t count);
    bool SkipComment();
    void SkipBlanks();
    Token ReadString();
    Token ReadNumber();
    Token ReadWord();

    std::string_view m_Text;
    std::size_t m_Position = 0;
    SourceLocation m_Location{1, 1};
};

} // namespace limn
