#pragma once

#include "hlsl/Tokens.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Preprocessed HLSL in which tokens are spelled anew. What lies between them, line ends and
/// directives, stays, so that positions of messages hold.
class HlslEditor
{
public:
    /// @param text  must outlive this
    explicit HlslEditor(const std::string& text);

    std::size_t size() const { return m_Tokens.size(); }
    /// As written; "" behind the end.
    std::string_view Text(std::size_t index) const;
    bool isWord(std::size_t index) const;
    /// The source from one token to the one before `end`.
    std::string_view Span(std::size_t first, std::size_t end) const;
    /// The token after the bracket that closes the one at the index.
    std::size_t AfterBracket(std::size_t index) const;
    /// The first of the marks at or after the index that is not in brackets opened after it; where
    /// a bracket closes that was opened before, that one; else size().
    std::size_t FindOutside(std::size_t index, std::string_view mark) const;
    /// Where a token is in the author's file.
    HlslPlace Place(std::size_t index) const;

    /// What stands in the place of the token.
    std::string& Spelling(std::size_t index) { return m_Spelling[index]; }
    void Erase(std::size_t first, std::size_t end);
    std::string Assemble() const;

    /// +1 for a bracket that opens, -1 for one that closes, else 0.
    int Step(std::size_t index) const;

private:
    const std::string& m_Text;
    const std::vector<HlslToken> m_Tokens;
    std::vector<std::string> m_Spelling; ///< by token
};

} // namespace limn
