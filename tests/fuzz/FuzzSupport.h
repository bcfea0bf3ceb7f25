#pragma once

#include "TemporaryFolder.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limn/base/Diagnostic.h>
#include <string_view>

namespace limn::test
{

/// Ends the program, so that the fuzzer reports the input.
inline void RequireInFuzzer(bool holds, const char* problem)
{
    if (!holds)
    {
        std::fprintf(stderr, "fuzzer: %s\n", problem);
        std::abort();
    }
}

inline std::string_view FuzzText(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// Calls `work`, which may do what it is for or throw AssetError with sentences, and nothing else.
template <typename Work>
void OrSentence(const Work& work)
{
    try
    {
        work();
    }
    catch (const AssetError& error)
    {
        RequireInFuzzer(!error.diagnostics().empty(), "an error says nothing");
        for (const Diagnostic& problem : error.diagnostics())
        {
            RequireInFuzzer(!problem.message.empty(), "an empty sentence");
        }
    }
}

} // namespace limn::test
