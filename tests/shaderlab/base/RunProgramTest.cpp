#include <limn/base/RunProgram.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <system_error>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

TEST(ProgramRun, GivesWhatTheProgramPrintsOfWhatItReads)
{
    const std::string input(200'000, 'x'); // more than a pipe holds
    EXPECT_EQ(input, RunProgram({"cat"}, input, ""));
    EXPECT_EQ("a 'b' $c\n", RunProgram({"echo", "a 'b' $c"}, "", "")) << "no shell has a say";
}

TEST(ProgramRun, SaysWhatAProgramThatFailsComplainsOf)
{
    try
    {
        RunProgram({"sh", "-c", "echo broken >&2; exit 3"}, "", "");
        FAIL() << "nothing was thrown";
    }
    catch (const std::system_error&)
    {
        FAIL() << "it was started";
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("the program 'sh' failed: broken"));
    }
}

TEST(ProgramRun, SaysWhereAMissingProgramIsToBeHad)
{
    try
    {
        RunProgram({"limn-no-such-program"}, "", "install it");
        FAIL() << "nothing was thrown";
    }
    catch (const std::system_error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("install it"));
    }
}

} // namespace

} // namespace limn::test
