#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace limn::vulkan
{

/// Allocates ranges of [0, size) by first fit. Returned ranges are merged with their neighbours.
class RangeAllocator
{
public:
    explicit RangeAllocator(std::uint64_t size);

    /// Returns the offset, a multiple of `alignment` (a power of two), or nullopt if no gap is
    /// large enough.
    std::optional<std::uint64_t> Allocate(std::uint64_t size, std::uint64_t alignment);

    /// Frees a range, which must be exactly as it was allocated.
    void Free(std::uint64_t offset, std::uint64_t size);

    std::uint64_t usedBytes() const { return m_Used; }

private:
    std::uint64_t m_Used = 0;
    std::map<std::uint64_t, std::uint64_t> m_Gaps; ///< offset → size, never touching each other
};

} // namespace limn::vulkan
