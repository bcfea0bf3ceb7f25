#include "support/ParallelFor.h"

#include <algorithm>
#include <system_error>

namespace limn
{

std::size_t PartsOf(std::size_t count)
{
    constexpr std::size_t k_LeastElements = 200'000;
    static const std::size_t cores = // asking for it opens files
        std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, k_MostParts);
    return std::max<std::size_t>(std::min(count / k_LeastElements, cores), 1);
}

ThreadPool::~ThreadPool()
{
    {
        const std::lock_guard lock(m_Mutex);
        m_IsEnding = true;
    }
    m_Begun.notify_all();
    m_Threads.clear(); // joins them
}

ThreadPool& ThreadPool::shared()
{
    static ThreadPool pool;
    return pool;
}

void ThreadPool::Run(std::size_t parts, const std::function<void(std::size_t)>& run)
{
    std::unique_lock lock(m_Mutex);
    const bool isFree = m_Run == nullptr;
    std::size_t handedOn = 0;
    if (isFree)
    {
        StartThreads(parts - 1);
        handedOn = std::min(parts - 1, m_Threads.size());
        std::fill_n(m_IsDue.begin(), handedOn, true);
        m_Left = handedOn;
        m_Run = &run;
    }
    lock.unlock();
    m_Begun.notify_all();
    for (std::size_t part = handedOn; part < parts; ++part)
    {
        run(part);
    }
    if (isFree)
    {
        lock.lock();
        m_Done.wait(lock, [&] { return m_Left == 0; });
        m_Run = nullptr;
    }
}

void ThreadPool::StartThreads(std::size_t count)
try
{
    while (m_Threads.size() < count)
    {
        m_Threads.push_back(m_Start([this, part = m_Threads.size()] { Work(part); }));
    }
}
catch (const std::system_error&)
{
    // A limit of the machine is reached: it takes longer, that is all.
}

void ThreadPool::Work(std::size_t part)
{
    std::unique_lock lock(m_Mutex);
    while (true)
    {
        m_Begun.wait(lock, [&] { return m_IsDue[part] || m_IsEnding; });
        if (m_IsEnding)
        {
            return;
        }
        m_IsDue[part] = false;
        const auto& run = *m_Run;
        lock.unlock();
        run(part);
        lock.lock();
        if (--m_Left == 0)
        {
            m_Done.notify_one();
        }
    }
}

} // namespace limn
