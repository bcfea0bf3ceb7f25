#pragma once

#include <vector>

namespace limn
{

/// Returns an empty list that keeps its memory for the thread's next call of the functions that
/// draw objects. Only one user at a time may have a list of each kind.
template <typename Value>
std::vector<Value>& ThreadScratch()
{
    static thread_local std::vector<Value> list;
    list.clear();
    return list;
}

} // namespace limn
