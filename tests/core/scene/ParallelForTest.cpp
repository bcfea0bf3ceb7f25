#include "scene/ParallelFor.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace limn
{

namespace
{

/// A thread of a machine that has room for two.
class ScarceThread
{
public:
    template <typename Function>
    ScarceThread(const Function& function, std::size_t part)
    {
        if (started == 2)
        {
            throw std::system_error(
                std::make_error_code(std::errc::resource_unavailable_try_again));
        }
        ++started;
        m_Thread = std::jthread(function, part);
    }

    static inline int started = 0;

private:
    std::jthread m_Thread;
};

} // namespace

TEST(ForEachPart, GoesOnInTheCallersThreadWhereNoOtherCanBeStarted)
{
    ScarceThread::started = 0;
    std::vector<int> visits(1003);
    std::vector<std::thread::id> threads(7);
    ForEachPart<ScarceThread>(visits.size(), threads.size(),
                              [&](std::size_t part, std::size_t begin, std::size_t end)
                              {
                                  threads[part] = std::this_thread::get_id();
                                  for (std::size_t i = begin; i < end; ++i)
                                  {
                                      ++visits[i];
                                  }
                              });
    EXPECT_EQ(std::vector<int>(1003, 1), visits);
    EXPECT_EQ(5, std::ranges::count(threads, std::this_thread::get_id()));
}

TEST(ForEachPart, HandsOnWhatAnyPartThrows)
{
    for (const std::size_t bad : {0u, 1u, 2u})
    {
        const auto function = [bad](std::size_t part, std::size_t, std::size_t)
        {
            if (part == bad)
            {
                throw std::runtime_error("part " + std::to_string(part));
            }
        };
        EXPECT_THROW(ForEachPart(10, 3, function), std::runtime_error) << bad;
    }
}

} // namespace limn
