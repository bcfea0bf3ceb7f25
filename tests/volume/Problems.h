#pragma once

#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <string>
#include <vector>

namespace limn::test
{

/// "7:5: message" per diagnostic, just the message where it has no place.
inline std::vector<std::string> Texts(const std::vector<Diagnostic>& diagnostics)
{
    std::vector<std::string> texts;
    for (const Diagnostic& d : diagnostics)
    {
        const std::string place =
            d.location.line == 0
                ? std::string()
                : std::to_string(d.location.line) + ":" + std::to_string(d.location.column) + ": ";
        texts.push_back(place + d.message);
    }
    return texts;
}

/// Texts of the AssetError that `action` throws; fails the test if it throws none.
template <typename Action>
std::vector<std::string> Problems(Action&& action)
{
    try
    {
        action();
    }
    catch (const AssetError& error)
    {
        return Texts(error.diagnostics());
    }
    ADD_FAILURE() << "no AssetError was thrown";
    return {};
}

} // namespace limn::test
