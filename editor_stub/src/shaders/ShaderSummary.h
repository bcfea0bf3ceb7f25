#pragma once

#include "shaders/ShaderCheck.h"

#include <array>

namespace limn
{

/// What many files came to.
struct ShaderSummary
{
    int files = 0;
    int parsed = 0; ///< without an error
    int errors = 0;
    std::array<int, 5> passes{}; ///< by PassOutcome

    int passesOf(PassOutcome outcome) const { return passes[static_cast<std::size_t>(outcome)]; }
    /// Vertex and fragment programs of which everything they include is there.
    int passesTried() const
    {
        return passesOf(PassOutcome::Compiled) + passesOf(PassOutcome::Failed);
    }
};

ShaderSummary Summarize(const std::vector<ShaderCheck>& checks);

/// "2 files: 1 parsed (50.0 %), 1 with 3 errors; 4 of 5 passes compiled (80.0 %), 1 failed, 2
/// refused, 1 with a missing include"; what is 0 is left out.
std::string ToString(const ShaderSummary& summary);

} // namespace limn
