#pragma once

#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

namespace limn::test
{

/// what() of the Exception that `action` throws; fails the test and is "" if it throws none.
template <typename Exception, typename Action>
std::string ThrownMessage(Action&& action)
{
    try
    {
        action();
    }
    catch (const Exception& exception)
    {
        return exception.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

/// The lines of a message that lists several problems.
inline std::vector<std::string> MessageLines(const std::string& message)
{
    std::istringstream text(message);
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

/// `message`, which must name one problem only.
inline std::string OnlyLine(const std::string& message)
{
    EXPECT_LE(MessageLines(message).size(), 1u) << message;
    return message;
}

} // namespace limn::test
