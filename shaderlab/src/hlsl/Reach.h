#pragma once

#include "hlsl/Declarations.h"

#include <set>
#include <string_view>
#include <vector>

namespace limn
{

/// The functions that an entry function, or the value of a global variable, can come to. All
/// overloads of a name at once, whichever is called.
class HlslReach
{
public:
    /// @param tokens        outlive this, as do
    /// @param declarations  of the same text
    HlslReach(const HlslTokens& tokens, const HlslDeclarations& declarations,
              std::string_view entry);

    const std::set<const HlslFunction*>& functions() const { return m_Functions; }
    /// By token: whether it is of a function out of reach.
    const std::vector<bool>& isLeftOut() const { return m_IsLeftOut; }
    /// Whether the word stands in one of the functions.
    bool Names(std::string_view word) const;

private:
    const HlslTokens& m_Tokens;
    std::set<const HlslFunction*> m_Functions;
    std::vector<bool> m_IsLeftOut;
};

} // namespace limn
