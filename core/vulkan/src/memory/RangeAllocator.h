#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace limn::vulkan
{

/// Hands out ranges of [0, size): first fit, neighbours merged on return.
class RangeAllocator
{
public:
    explicit RangeAllocator(std::uint64_t size);

    /// The offset, a multiple of `alignment` (a power of two); none if no gap is large enough.
    std::optional<std::uint64_t> Allocate(std::uint64_t size, std::uint64_t alignment);

    /// Returns a range exactly as it was handed out.
    void Free(std::uint64_t offset, std::uint64_t size);

    std::uint64_t usedBytes() const { return m_Used; }

private:
    std::uint64_t m_Used = 0;
    std::map<std::uint64_t, std::uint64_t> m_Gaps; ///< offset → size, never touching each other
};

} // namespace limn::vulkan
