#include "memory/RangeAllocator.h"

#include <cassert>

namespace limn::vulkan
{

RangeAllocator::RangeAllocator(std::uint64_t size)
{
    m_Gaps.emplace(0, size);
}

std::optional<std::uint64_t> RangeAllocator::Allocate(std::uint64_t size, std::uint64_t alignment)
{
    assert(size > 0 && alignment > 0 && (alignment & (alignment - 1)) == 0);
    for (auto gap = m_Gaps.begin(); gap != m_Gaps.end(); ++gap)
    {
        const auto [begin, length] = *gap;
        const std::uint64_t offset = (begin + alignment - 1) & ~(alignment - 1);
        const std::uint64_t padding = offset - begin;
        if (padding > length || size > length - padding)
        {
            continue;
        }
        m_Gaps.erase(gap);
        if (padding > 0)
        {
            m_Gaps.emplace(begin, padding);
        }
        if (padding + size < length)
        {
            m_Gaps.emplace(offset + size, length - padding - size);
        }
        m_Used += size;
        return offset;
    }
    return std::nullopt;
}

void RangeAllocator::Free(std::uint64_t offset, std::uint64_t size)
{
    assert(size <= m_Used);
    m_Used -= size;
    auto next = m_Gaps.lower_bound(offset);
    if (next != m_Gaps.end() && offset + size == next->first)
    {
        size += next->second;
        next = m_Gaps.erase(next);
    }
    if (next != m_Gaps.begin())
    {
        const auto previous = std::prev(next);
        if (previous->first + previous->second == offset)
        {
            previous->second += size;
            return;
        }
    }
    m_Gaps.emplace_hint(next, offset, size);
}

} // namespace limn::vulkan
