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

/// What #line calls the text whose lines are tokens.
inline constexpr const char* k_TokenFile = "tokens";

/// Preprocessed HLSL in which tokens are spelled anew. What lies between them, line ends and
/// directives, stays, so that positions of messages hold.
class TokenEdits
{
public:
    /// @param tokens  must outlive this
    explicit TokenEdits(const HlslTokens& tokens) : m_Tokens(tokens), m_Edit(tokens.size()) {}

    const HlslTokens& tokens() const { return m_Tokens; }
    std::size_t size() const { return m_Tokens.size(); }
    // As written; see HlslTokens.
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

    /// What stands in the place of the token.
    std::string& Spelling(std::size_t index);
    /// What stands in the place of the tokens from one to the one before `end`, blanks between.
    std::string Spelled(std::size_t first, std::size_t end) const;
    /// Puts text around what stands in the place of the tokens from one to the one before `end`.
    void Wrap(std::size_t first, std::size_t end, std::string_view before, std::string_view after);
    void Erase(std::size_t first, std::size_t end);
    /// Text behind the token, there even if the token is left out.
    void Insert(std::size_t index, std::string_view text) { m_Inserted[index] += text; }

    /// Whether any token is spelled anew.
    bool isEdited() const { return !m_Spelling.empty(); }
    /// Without what is inserted.
    std::string Assemble() const;
    /// For a compiler: each token is in a line of its own, which it is the number of, from 1; so
    /// messages tell the token. Of directives between tokens only pragmas stay.
    ///
    /// @param isLeftOut  by token; of those only what is inserted stays
    std::string AssembleByToken(const std::vector<bool>& isLeftOut) const;

private:
    /// What stands in the place of the token now.
    std::string_view Now(std::size_t index) const;
    /// The last one behind the token before.
    std::string_view PragmaBefore(std::size_t index) const;

    const HlslTokens& m_Tokens;
    std::vector<std::uint32_t> m_Edit; ///< by token: one more than its place in m_Spelling, or 0
    std::deque<std::string> m_Spelling;
    std::map<std::size_t, std::string> m_Inserted; ///< by token
};

} // namespace limn
