#pragma once

#include <gtest/gtest.h>
#include <string>

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

} // namespace limn::test
