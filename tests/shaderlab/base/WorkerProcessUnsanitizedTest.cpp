#include <limn/base/WorkerProcess.h>

#include <gtest/gtest.h>
#include <new>

namespace limn
{
namespace
{

std::string AskForThreeGibibytes(std::string_view)
{
    try
    {
        const std::string large(std::size_t{3} << 30, 'm');
        return "has " + std::to_string(large.size());
    }
    catch (const std::bad_alloc&)
    {
        return "bad_alloc";
    }
}

} // namespace

TEST(WorkerProcess, HasNoMoreThanItsShareOfMemory)
{
    WorkerProcess process;
    const WorkerAnswer answer =
        process.Run({AskForThreeGibibytes, nullptr, std::chrono::seconds(30)}, "");
    EXPECT_EQ(answer.bytes, "bad_alloc");
}

} // namespace limn
