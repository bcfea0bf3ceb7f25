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

/// How many parts a loop over `count` elements is worth: handing a part to another thread takes
/// its time, above all on a busy machine.
std::size_t PartsOf(std::size_t count);

/// Threads that wait for the next loop: a loop neither starts a thread nor allocates unless it has
/// more parts than any before.
class ThreadPool
{
public:
    using Start = std::jthread (*)(std::function<void()> work);

    /// @param start  starts one; std::system_error: the machine has no room for it
    explicit ThreadPool(Start start = [](std::function<void()> work)
                        { return std::jthread(std::move(work)); })
        : m_Start(start)
    {
    }
    ~ThreadPool();

    /// Calls run(part), which does not throw, for each of k_MostParts at most and comes back after
    /// the last: one in each thread of the pool, the others in the caller's, the last always; all
    /// in the caller's while the pool runs another loop, of another thread or around this one.
    void Run(std::size_t parts, const std::function<void(std::size_t)>& run);

    /// The process's; it ends with the process.
    static ThreadPool& shared();

private:
    void StartThreads(std::size_t count);
    void Work(std::size_t part);

    const Start m_Start;
    std::mutex m_Mutex; ///< of all below
    std::condition_variable m_Begun;
    std::condition_variable m_Done;
    const std::function<void(std::size_t)>* m_Run = nullptr; ///< of the loop under way
    std::array<bool, k_MostParts> m_IsDue{};                 ///< by part: its thread is to begin it
    std::size_t m_Left = 0;                                  ///< parts the threads have not ended
    bool m_IsEnding = false;
    std::vector<std::jthread> m_Threads; ///< by part
};

/// Runs function(part, begin, end) for each of `parts` runs of elements, k_MostParts at most, in
/// the pool's threads and the caller's. An exception of any of them goes on to the caller.
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
