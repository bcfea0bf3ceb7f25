#pragma once

#include <cstddef>
#include <string>

namespace limn
{

namespace detail
{

/// Returns memory that the thread gave back before, if there is some of about this size.
void* TakePooled(std::size_t bytes);
/// @param bytes  the size with which the memory was taken
void GivePooled(void* memory, std::size_t bytes) noexcept;

} // namespace detail

/// An allocator for what each frame makes anew: a frame like the one before asks the system for no
/// memory.
template <typename T>
struct PooledAllocator
{
    using value_type = T;

    static_assert(alignof(T) <= alignof(std::max_align_t));

    PooledAllocator() = default;
    template <typename Other>
    PooledAllocator(const PooledAllocator<Other>&)
    {
    }

    T* allocate(std::size_t count)
    {
        return static_cast<T*>(detail::TakePooled(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept
    {
        detail::GivePooled(memory, count * sizeof(T));
    }
    template <typename Other>
    bool operator==(const PooledAllocator<Other>&) const
    {
        return true;
    }
};

/// A text that is made anew in each frame.
using PooledString = std::basic_string<char, std::char_traits<char>, PooledAllocator<char>>;

} // namespace limn
