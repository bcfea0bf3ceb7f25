// Counts the heap allocations of `limn` for --stats. Not in builds with sanitizers, which have an
// operator new of their own.

#include <cstdlib>
#include <limn/editor_stub/Allocations.h>
#include <new>

namespace
{

[[maybe_unused]] const bool s_AreCounted = limn::Allocations::areCounted = true;

} // namespace

void* operator new(std::size_t size)
{
    if (limn::Allocations::isAsked.load(std::memory_order_relaxed))
    {
        limn::Allocations::soFar.fetch_add(1, std::memory_order_relaxed);
    }
    for (;;)
    {
        if (void* memory = std::malloc(size == 0 ? 1 : size))
        {
            return memory;
        }
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr)
        {
            throw std::bad_alloc();
        }
        handler();
    }
}

// The others lead to this one, but for those of types with an alignment of their own, of which
// limn has none.

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
