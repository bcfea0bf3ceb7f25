#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace limn
{

inline constexpr std::size_t k_MostParts = 16;

/// Returns the number of parts into which a loop over `count` elements should be divided: passing a
/// part to another thread takes time, above all on a busy machine.
std::size_t PartsOf(std::size_t count);

/// Threads that wait for the next loop. A loop neither starts a thread nor allocates unless it has
/// more parts than any before.
class ThreadPool
{
public:
    using Start = std::jthread (*)(std::function<void()> work);

    /// @param start  starts a thread; throws std::system_error if the machine has no room for it
    explicit ThreadPool(Start start = [](std::function<void()> work)
                        { return std::jthread(std::move(work)); })
        : m_Start(start)
    {
    }
    ~ThreadPool();

    /// Calls run(part), which must not throw, for each part, of which there are at most
    /// k_MostParts, and returns after the last. One part runs in each thread of the pool, the
    /// others, always including the last, in the caller's thread. All run in the caller's thread
    /// while the pool runs another loop, of another thread or around this one.
    void Run(std::size_t parts, const std::function<void(std::size_t)>& run);

    /// Returns the pool of the process, which lives until the process ends.
    static ThreadPool& shared();

private:
    void StartThreads(std::size_t count);
    void Work(std::size_t part);

    const Start m_Start;
    std::mutex m_Mutex; ///< guards everything below
    std::condition_variable m_Begun;
    std::condition_variable m_Done;
    const std::function<void(std::size_t)>* m_Run = nullptr; ///< of the loop under way
    std::array<bool, k_MostParts> m_IsDue{};                 ///< by part: its thread must begin it
    std::size_t m_Left = 0;                                  ///< parts not ended by threads
    bool m_IsEnding = false;
    std::vector<std::jthread> m_Threads; ///< by part
};

/// Calls function(part, begin, end) for each of `parts` ranges of elements, at most k_MostParts, in
/// the pool's threads and the caller's. An exception of any of them is rethrown to the caller.
template <typename Function>
void ForEachPart(std::size_t count, std::size_t parts, const Function& function,
                 ThreadPool& pool = ThreadPool::shared())
{
    if (parts == 1)
    {
        function(0, 0, count);
        return;
    }
    std::array<std::exception_ptr, k_MostParts> failures;
    const auto run = [&](std::size_t part)
    {
        try
        {
            function(part, count * part / parts, count * (part + 1) / parts);
        }
        catch (...)
        {
            failures[part] = std::current_exception();
        }
    };
    pool.Run(parts, std::ref(run));
    for (const std::exception_ptr& failure : failures)
    {
        if (failure)
        {
            std::rethrow_exception(failure);
        }
    }
}

} // namespace limn
