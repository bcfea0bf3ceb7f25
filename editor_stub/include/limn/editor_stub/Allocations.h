#pragma once

#include <atomic>
#include <cstdint>

namespace limn
{

/// The heap allocations of a program that replaces `operator new`, as `limn` does in its
/// Allocations.cpp. The library itself cannot count them.
struct Allocations
{
    static inline std::atomic<bool> areCounted{false}; ///< true if this program can count
    static inline std::atomic<bool> isAsked{false}; ///< true while this program is asked to count
    /// The number of allocations of all threads while the program was asked to count.
    static inline std::atomic<std::uint64_t> soFar{0};
};

} // namespace limn
