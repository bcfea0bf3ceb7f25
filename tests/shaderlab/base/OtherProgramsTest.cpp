#include <limn/base/OtherPrograms.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{
namespace
{

/// Another program that uses so many seconds of a processor, however long that takes.
void RunAnotherProgram(double seconds)
{
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0)
    {
        const std::clock_t begin = std::clock();
        while (static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < seconds)
        {
        }
        _exit(0);
    }
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
}

TEST(OtherPrograms, AreThoseThatUseProcessorsMeanwhile)
{
    const auto begin = std::chrono::steady_clock::now();
    const OtherPrograms others;
    if (std::isnan(others.BusyProcessors()))
    {
        GTEST_SKIP() << "there is no /proc/stat";
    }
    RunAnotherProgram(0.5);
    const double busy = others.BusyProcessors();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    EXPECT_GT(busy * elapsed.count(), 0.4) << "a tick is a hundredth of a second";
}

} // namespace
} // namespace limn
