#include "support/ParallelFor.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

namespace limn
{

namespace
{

int g_Started = 0;

/// Starts a thread on a machine that has room for two.
std::jthread StartScarceThread(std::function<void()> work)
{
    if (g_Started == 2)
    {
        throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
    }
    ++g_Started;
    return std::jthread(std::move(work));
}

/// The thread of each of 3 parts.
std::array<std::thread::id, 3> ThreadsOfALoop(ThreadPool& pool)
{
    std::array<std::thread::id, 3> threads;
    ForEachPart(
        3, 3,
        [&](std::size_t part, std::size_t, std::size_t)
        { threads[part] = std::this_thread::get_id(); },
        pool);
    return threads;
}

} // namespace

TEST(ForEachPart, GoesOnInTheCallersThreadWhereNoOtherCanBeStarted)
{
    g_Started = 0;
    ThreadPool pool(&StartScarceThread);
    std::vector<int> visits(1003);
    std::vector<std::thread::id> threads(7);
    ForEachPart(
        visits.size(), threads.size(),
        [&](std::size_t part, std::size_t begin, std::size_t end)
        {
            threads[part] = std::this_thread::get_id();
            for (std::size_t i = begin; i < end; ++i)
            {
                ++visits[i];
            }
        },
        pool);
    EXPECT_EQ(std::vector<int>(1003, 1), visits);
    EXPECT_EQ(5, std::ranges::count(threads, std::this_thread::get_id()));
}

TEST(ForEachPart, KeepsItsThreadsFromLoopToLoop)
{
    g_Started = 0;
    ThreadPool pool(&StartScarceThread);
    const auto threads = ThreadsOfALoop(pool);
    EXPECT_EQ(3u, std::set(threads.begin(), threads.end()).size());
    EXPECT_EQ(std::this_thread::get_id(), threads[2]);
    for (int i = 0; i < 1000; ++i)
    {
        ASSERT_EQ(threads, ThreadsOfALoop(pool));
    }
    EXPECT_EQ(2, g_Started);
}

TEST(ForEachPart, RunsALoopInsideALoopInTheThreadOfItsPart)
{
    ThreadPool pool;
    std::array<std::array<std::thread::id, 3>, 3> inner;
    std::array<std::thread::id, 3> outer;
    ForEachPart(
        3, 3,
        [&](std::size_t part, std::size_t, std::size_t)
        {
            outer[part] = std::this_thread::get_id();
            inner[part] = ThreadsOfALoop(pool);
        },
        pool);
    for (std::size_t part = 0; part < 3; ++part)
    {
        EXPECT_EQ(3, std::ranges::count(inner[part], outer[part])) << part;
    }
}

TEST(ForEachPart, RunsEveryPartOnceForCallersAtTheSameTime)
{
    ThreadPool pool;
    std::array<std::vector<int>, 4> visits;
    const auto call = [&](std::vector<int>& own)
    {
        own.resize(300);
        for (int i = 0; i < 1000; ++i)
        {
            ForEachPart(
                own.size(), 3,
                [&](std::size_t, std::size_t begin, std::size_t end)
                {
                    for (std::size_t k = begin; k < end; ++k)
                    {
                        ++own[k];
                    }
                },
                pool);
        }
    };
    {
        std::vector<std::jthread> callers;
        for (std::vector<int>& own : visits)
        {
            callers.emplace_back(call, std::ref(own));
        }
    }
    for (const std::vector<int>& own : visits)
    {
        EXPECT_EQ(std::vector<int>(300, 1000), own);
    }
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
