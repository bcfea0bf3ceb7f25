#pragma once

#include <atomic>
#include <cstdint>

namespace limn
{

/// Returns a number that no other object of this process has or had; never 0. Any thread may call
/// it.
inline std::uint64_t NextUniqueId()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace limn
