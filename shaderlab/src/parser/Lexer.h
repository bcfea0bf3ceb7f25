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
    float number = 0.0f;       ///< of a Number; the largest float where it is beyond them
    bool unterminated = false; ///< a String that the file ends in
    bool unusual = false;      ///< a Number with '+', exponent or suffix, or beyond all floats
};

/// The raw text of a program or include block.
struct RawBlock
{
    std::string_view text;
    std::string_view endWord; ///< the word that closes it, as written; "" = nothing closes it
    bool inComment = false;   ///< no end word stood outside comments: it is the first one inside
    std::string_view opener;  ///< the first word in it that opens a block, outside comments
};

/// Cuts ShaderLab text into tokens, one at a time, so that the parser can switch to raw text for
/// program blocks and attributes. Every byte is looked at a bounded number of times.
class Lexer
{
public:
    explicit Lexer(std::string_view text);

    Token Next();

    /// Line of the place right behind the last token.
    int line() const { return m_Line; }

    /// Where the comment starts that the file ends in; line 0 = there is none, or it was forgotten.
    SourceLocation openComment() const { return m_OpenComment; }
    void ForgetOpenComment() { m_OpenComment = {}; }

    /// Whether the next token is this punctuation mark; passes nothing over but blanks.
    bool isNext(char mark);

    /// The text up to the first ']' of this line, which is passed over. Attributes know no
    /// brackets, quotes or parentheses. Without a ']' the rest of the line.
    std::string_view ReadBracket(bool& closed);

    /// The rest of the line, without its end.
    std::string_view ReadLine();

    /// The text up to the whole word `endWord`, which is passed over: the first one outside
    /// comments. Where none comes before the next block opens, the first end word at all, be it in
    /// a comment or one of another language. Nothing is passed over where there is none.
    RawBlock ReadBlock(std::string_view endWord);

    /// Goes to the end: all that Next() gives is End.
    void SkipToEnd();

private:
    /// Where something is next, so that looking for it again from further on costs nothing.
    struct Finding
    {
        std::size_t from = 1;
        std::size_t to = 0; ///< npos = nowhere
    };
    struct BlockEnd
    {
        std::size_t begin = std::string_view::npos;
        std::size_t size = 0;
        bool inComment = false;
        std::string_view opener = {};
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
    std::size_t WordEnd(std::size_t position) const;
    std::size_t CommentEnd(std::size_t position);
    std::size_t BlockCommentEnd(std::size_t position);
    void LookIntoComment(std::size_t from, std::size_t to, std::string_view endWord,
                         BlockEnd& end) const;
    BlockEnd FindBlockEnd(std::string_view endWord);

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
