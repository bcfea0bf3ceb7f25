#pragma once

#include "hlsl/Globals.h"

#include <set>
#include <string_view>
#include <vector>

namespace limn
{

/// The functions that an entry function, or the value of a global variable, can reach. A call
/// reaches all overloads of its name.
class ReachableFunctions
{
public:
    /// @param tokens   must outlive this
    /// @param globals  the globals of the same text; must outlive this
    ReachableFunctions(const HlslTokens& tokens, const HlslGlobals& globals,
                       std::string_view entry);

    const std::set<const HlslFunction*>& functions() const { return m_Functions; }
    /// Returns for each token whether it belongs to a function out of reach.
    const std::vector<bool>& isLeftOut() const { return m_IsLeftOut; }
    /// Returns whether the word occurs in one of the functions.
    bool Names(std::string_view word) const;

private:
    void Mark(const HlslFunction& function, bool isLeftOut);

    const HlslTokens& m_Tokens;
    std::set<const HlslFunction*> m_Functions;
    std::vector<bool> m_IsLeftOut;
};

} // namespace limn
