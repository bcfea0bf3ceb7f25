#include <limn/core/PooledAllocator.h>

#include <array>
#include <bit>
#include <new>
#include <utility>

namespace limn::detail
{

namespace
{

constexpr std::size_t k_Smallest = 64; // bytes
constexpr std::size_t k_ClassCount = 11;
constexpr std::size_t k_MostKept = 64; // of a size
constexpr std::size_t k_TooLarge = k_ClassCount;

struct Free
{
    Free* next;
};

/// Each size is twice the one before.
std::size_t ClassOf(std::size_t bytes)
{
    if (bytes <= k_Smallest)
    {
        return 0;
    }
    const auto index = static_cast<std::size_t>(std::bit_width((bytes - 1) / k_Smallest));
    return index < k_ClassCount ? index : k_TooLarge;
}

class Pool
{
public:
    ~Pool();

    void* Take(std::size_t index)
    {
        Free* memory = m_First[index];
        if (memory == nullptr)
        {
            return ::operator new(k_Smallest << index);
        }
        m_First[index] = memory->next;
        --m_Count[index];
        return memory;
    }
    bool Keep(void* memory, std::size_t index) noexcept
    {
        if (m_Count[index] == k_MostKept)
        {
            return false;
        }
        m_First[index] = new (memory) Free{m_First[index]};
        ++m_Count[index];
        return true;
    }

private:
    std::array<Free*, k_ClassCount> m_First{};
    std::array<std::size_t, k_ClassCount> m_Count{};
};

// Static objects give their memory back after the thread's pool is gone.
thread_local bool isGone = false;

Pool::~Pool()
{
    isGone = true;
    for (Free* memory : m_First)
    {
        while (memory != nullptr)
        {
            ::operator delete(std::exchange(memory, memory->next));
        }
    }
}

Pool& OfThread()
{
    thread_local Pool pool;
    return pool;
}

} // namespace

void* TakePooled(std::size_t bytes)
{
    const std::size_t index = ClassOf(bytes);
    if (index == k_TooLarge)
    {
        return ::operator new(bytes);
    }
    return isGone ? ::operator new(k_Smallest << index) : OfThread().Take(index);
}

void GivePooled(void* memory, std::size_t bytes) noexcept
{
    const std::size_t index = ClassOf(bytes);
    if (index == k_TooLarge || isGone || !OfThread().Keep(memory, index))
    {
        ::operator delete(memory);
    }
}

} // namespace limn::detail
