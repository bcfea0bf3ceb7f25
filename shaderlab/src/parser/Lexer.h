#pragma once

#include <limn/base/Diagnostic.h>

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
    float number = 0.0f; ///< the value of a Number; the largest float if it is beyond all floats
    bool unterminated = false; ///< true for a String that the end of the file cuts off
    bool unusual = false;      ///< a Number with '+', exponent or suffix, or beyond all floats
};

/// The raw text of a program or include block.
struct RawBlock
{
    std::string_view text;    ///< "" if nothing closes it
    std::string_view endWord; ///< the word that closes it, as written; "" = nothing closes it
    bool inComment = false;   ///< no end word was outside comments, so it is the first one inside
    std::string_view opener;  ///< the first word in it that opens a block, outside comments
};

/// Cuts ShaderLab text into tokens, one at a time, so that the parser can switch to raw text for
/// program blocks and attributes. It reads every byte a bounded number of times.
class Lexer
{
public:
    explicit Lexer(std::string_view text);

    Token Next();

    /// Returns the line of the place directly behind the last token.
    int line() const { return m_Line; }

    /// Returns the beginning of the comment that the end of the file cuts off; line 0 = there is
    /// none, or it was forgotten.
    SourceLocation openComment() const { return m_OpenComment; }
    void ForgetOpenComment() { m_OpenComment = {}; }

    /// Returns whether the next token is this punctuation mark; skips only blanks.
    bool isNext(char mark);

    /// Returns the text up to the first ']' of this line, and skips the ']'. Attributes have no
    /// nested brackets, quotes or parentheses. Without a ']' it returns the rest of the line.
    std::string_view ReadBracket(bool& closed);

    /// Returns the rest of the line without its end.
    std::string_view ReadLine();

    /// Returns the text up to the whole word `endWord`, the first one outside comments, and skips
    /// the word. If none comes before the next block opens, it takes the first end word at all,
    /// even in a comment or of another language. It skips nothing if there is none.
    RawBlock ReadBlock(std::string_view endWord);

    /// Skips to the end, so that Next() returns only End.
    void SkipToEnd();

private:
    /// The next place of something, so that searching for it again from a later place costs
    /// nothing.
    struct Finding
    {
        std::size_t from = 1;
        std::size_t to = 0; ///< npos = nowhere
    };

    char Peek(std::size_t ahead = 0) const;
    void SkipTo(std::size_t position);
    bool SkipComment();
    void SkipBlanks();
    std::size_t SpecialBlank() const;
    Token TokenHere(TokenKind kind, std::size_t size) const;
    Token ReadString();
    Token ReadNumber();
    Token ReadWord();
    std::size_t Find(Finding& finding, std::string_view text, std::size_t from) const;
    std::string_view WordAt(std::size_t position) const;
    std::size_t CommentEnd(std::size_t position);
    std::size_t BlockCommentEnd(std::size_t position);
    void LookIntoComment(std::size_t from, std::size_t to, std::string_view endWord,
                         RawBlock& block) const;
    RawBlock FindBlockEnd(std::string_view endWord);

    std::string_view m_Text;
    std::size_t m_Position = 0;
    int m_Line = 1;
    std::size_t m_LineStart = 0;
    bool m_CommentsNest = true; ///< false once nesting has led to the end of the file
    SourceLocation m_OpenComment;
    Finding m_CommentClose;
    Finding m_LineEnd;
    Finding m_NoBlockEnd; ///< between these places no block end stands outside comments
};

} // namespace limn
