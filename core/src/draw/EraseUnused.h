#pragma once

#include <iterator>
#include <utility>

namespace limn
{

/// Keeps those of a map's values that were marked isUsed, and takes the mark from them.
template <typename Map>
void EraseUnused(Map& map)
{
    for (auto entry = map.begin(); entry != map.end();)
    {
        entry = std::exchange(entry->second.isUsed, false) ? std::next(entry) : map.erase(entry);
    }
}

} // namespace limn
