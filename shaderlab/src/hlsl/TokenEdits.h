#pragma once

#include "tokens/Tokens.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The name in #line of the text whose lines are tokens.
inline constexpr const char* k_TokenFile = "tokens";

/// Preprocessed HLSL in which tokens are replaced. The text between them, such as line ends and
/// directives, stays, so that the positions of messages are right.
class TokenEdits
{
public:
    /// @param tokens  must outlive this
    explicit TokenEdits(const HlslTokens& tokens) : m_Tokens(tokens), m_Edit(tokens.size()) {}

    const HlslTokens& tokens() const { return m_Tokens; }
    std::size_t size() const { return m_Tokens.size(); }
    // These return the original text; see HlslTokens.
    std::string_view Text(std::size_t index) const { return m_Tokens.Text(index); }
    bool isWord(std::size_t index) const { return m_Tokens.isWord(index); }
    int Step(std::size_t index) const { return m_Tokens.Step(index); }
    std::size_t AfterBracket(std::size_t index) const { return m_Tokens.AfterBracket(index); }
    std::string_view Span(std::size_t first, std::size_t end) const
    {
        return m_Tokens.Span(first, end);
    }
    std::size_t FindOutside(std::size_t index, std::string_view mark) const
    {
        return m_Tokens.FindOutside(index, mark);
    }

    /// Returns the text in place of the token, for editing.
    std::string& Spelling(std::size_t index);
    /// Returns the texts in place of the tokens from one to the one before `end`, with blanks
    /// between them.
    std::string Spelled(std::size_t first, std::size_t end) const;
    void Erase(std::size_t first, std::size_t end);
    /// Adds text behind the token, which stays even if the token is left out.
    void Insert(std::size_t index, std::string_view text) { m_Inserted[index] += text; }

    /// Returns whether any token is replaced.
    bool isEdited() const { return !m_Spelling.empty(); }
    /// Returns the edited text without inserted texts.
    std::string Assemble() const;
    /// Returns the edited text for a compiler: each token is in a line of its own, whose number is
    /// that of the token, from 1, so that a message's line gives the token. Only pragmas stay of
    /// the directives between tokens.
    ///
    /// @param isLeftOut  by token; only inserted texts stay of tokens that are left out
    std::string AssembleByToken(const std::vector<bool>& isLeftOut) const;

private:
    /// Returns the present text in place of the token.
    std::string_view Now(std::size_t index) const;
    /// Returns the last pragma between the token and the one before.
    std::string_view PragmaBefore(std::size_t index) const;

    const HlslTokens& m_Tokens;
    std::vector<std::uint32_t> m_Edit; ///< by token: one more than its place in m_Spelling, or 0
    std::deque<std::string> m_Spelling;
    std::map<std::size_t, std::string> m_Inserted; ///< by token
};

} // namespace limn
