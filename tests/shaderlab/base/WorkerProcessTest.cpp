#include <limn/base/WorkerProcess.h>

#include "Paths.h"

#include <csignal>
#include <cstdlib>
#include <future>
#include <gmock/gmock.h>
#include <new>
#include <stdexcept>
#include <unistd.h>

namespace limn
{
namespace
{

using Ending = WorkerAnswer::Ending;
using namespace std::chrono_literals;

int s_Prepared = 0;

void PrepareForTest()
{
    ++s_Prepared;
}

/// Does what the request's first letter stands for.
std::string WorkForTest(std::string_view request)
{
    switch (request.empty() ? ' ' : request.front())
    {
    case 'a':
        std::abort();
    case 'k':
        std::raise(SIGKILL);
        return {};
    case 'h':
        for (;;)
        {
            pause();
        }
    case 'x':
        _exit(7);
    case 't':
        throw std::runtime_error("nobody catches this");
    case 'p':
        return std::to_string(s_Prepared);
    case 'i':
        return std::to_string(getpid());
    default:
        return std::string(request.rbegin(), request.rend());
    }
}

WorkerAnswer RunForTest(WorkerProcess& process, std::string_view request,
                        std::chrono::milliseconds limit = 30s)
{
    return process.Run({WorkForTest, PrepareForTest, limit}, request);
}

} // namespace

TEST(WorkerProcess, AnswersOfAnySize)
{
    WorkerProcess process;
    EXPECT_EQ(RunForTest(process, "").bytes, "");
    EXPECT_EQ(RunForTest(process, "BCD").bytes, "DCB");
    std::string large(20'000'001, 'e');
    large.back() = 'f';
    const WorkerAnswer answer = RunForTest(process, large);
    EXPECT_EQ(answer.ending, Ending::Answered);
    ASSERT_EQ(answer.bytes.size(), large.size());
    EXPECT_EQ(answer.bytes.front(), 'f');
}

TEST(WorkerProcess, SaysHowAWorkerEndedAndGoesOn)
{
    WorkerProcess process;
    const auto expect = [&](std::string_view request, Ending ending, int number)
    {
        const WorkerAnswer answer = RunForTest(process, request);
        EXPECT_EQ(answer.ending, ending) << request;
        EXPECT_EQ(answer.number, number) << request;
        EXPECT_EQ(RunForTest(process, "BC").bytes, "CB") << "after " << request;
    };
    expect("kill", Ending::Signal, SIGKILL);
    expect("x", Ending::Exit, 7);
    expect("abort", Ending::Signal, SIGABRT);
    expect("throw", Ending::Signal, SIGABRT);
    EXPECT_EQ(SignalText(6), "Aborted (signal 6)");
}

TEST(WorkerProcess, EndsAWorkerWhoseTimeIsOver)
{
    WorkerProcess process;
    EXPECT_EQ(RunForTest(process, "hang", 20ms).ending, Ending::OutOfTime);
    EXPECT_EQ(RunForTest(process, "BC", 30s).bytes, "CB");
}

TEST(WorkerProcess, KeepsAWorkerAndPreparesOnce)
{
    WorkerProcess process;
    const std::string first = RunForTest(process, "id").bytes;
    EXPECT_EQ(RunForTest(process, "id").bytes, first);
    EXPECT_NE(first, std::to_string(getpid()));
    RunForTest(process, "kill");
    EXPECT_NE(RunForTest(process, "id").bytes, first);
    EXPECT_EQ(RunForTest(process, "prepared").bytes, "1");
    EXPECT_EQ(s_Prepared, 0) << "it is the other process that is prepared";
}

TEST(WorkerProcess, DoesTasksOfSeveralThreadsAtATime)
{
    WorkerProcess process;
    std::vector<std::future<std::string>> answers;
    for (int i = 0; i < 8; ++i)
    {
        answers.push_back(
            std::async(std::launch::async, [&process, i]
                       { return RunForTest(process, i % 2 == 0 ? "kill" : "BC").bytes; }));
    }
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
        EXPECT_EQ(answers[i].get(), i % 2 == 0 ? "" : "CB");
    }
}

} // namespace limn
