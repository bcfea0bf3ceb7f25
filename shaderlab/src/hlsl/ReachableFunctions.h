#pragma once

#include "hlsl/Globals.h"

#include <set>
#include <string_view>
#include <vector>

namespace limn
{

/// The functions that an entry function, or the value of a global variable, can come to. All
/// overloads of a name at once, whichever is called.
class ReachableFunctions
{
public:
    /// @param tokens   outlive this, as do
    /// @param globals  of the same text
    ReachableFunctions(const HlslTokens& tokens, const HlslGlobals& globals,
                       std::string_view entry);

    const std::set<const HlslFunction*>& functions() const { return m_Functions; }
    /// By token: whether it is of a function out of reach.
    const std::vector<bool>& isLeftOut() const { return m_IsLeftOut; }
    /// Whether the word stands in one of the functions.
    bool Names(std::string_view word) const;

private:
    void Mark(const HlslFunction& function, bool isLeftOut);

    const HlslTokens& m_Tokens;
    std::set<const HlslFunction*> m_Functions;
    std::vector<bool> m_IsLeftOut;
};

} // namespace limn
