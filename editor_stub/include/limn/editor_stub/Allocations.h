#pragma once

#include <atomic>
#include <cstdint>

namespace limn
{

/// What a program counts that replaces `operator new`, as `limn` does in its Allocations.cpp; the
/// library itself cannot.
struct Allocations
{
    static inline std::atomic<bool> areCounted{false}; ///< by this program, if it is asked to
    static inline std::atomic<bool> isAsked{false};    ///< that it counts
    static inline std::atomic<std::uint64_t> soFar{0}; ///< by all threads, while it is asked to
};

} // namespace limn
