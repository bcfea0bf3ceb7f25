#pragma once

#include <vector>

namespace limn
{

/// A list that keeps its memory for the thread's next call of the functions that draw
/// objects. Each kind is used by one at a time.
template <typename Value>
std::vector<Value>& ThreadScratch()
{
    static thread_local std::vector<Value> list;
    list.clear();
    return list;
}

} // namespace limn
