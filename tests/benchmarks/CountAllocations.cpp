#include "CountAllocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace
{

std::atomic<long> s_Count{0};

} // namespace

long limn::benchmarks::AllocationCount()
{
    return s_Count;
}

// Not inlined: GCC takes the halves of an inlined pair for a mismatch. The other forms of `new`
// lead to these.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    s_Count.fetch_add(1, std::memory_order_relaxed);
    if (void* const memory = std::malloc(size))
    {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
