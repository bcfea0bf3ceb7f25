#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace limn::vulkan
{

// All pools use these functions. Each pool is a map to objects that have some of the members
// `owner`, a weak pointer, and `createdBy` and `lastUse`, numbers of submissions.

/// Returns the pool's object, or null if there is none.
template <typename Pool, typename Key>
auto* FindPooled(Pool& pool, const Key& key)
{
    const auto found = pool.find(key);
    return found == pool.end() ? nullptr : &found->second;
}

/// Adds the `lastUse` of the objects that submission `number` uses.
template <typename Pool>
void AddPooledUses(Pool& pool, std::uint64_t number, std::vector<std::uint64_t*>& uses)
{
    for (auto& [key, object] : pool)
    {
        if (object.lastUse == number)
        {
            uses.push_back(&object.lastUse);
        }
    }
}

/// Undoes the uses of a submission that will never happen.
template <typename Pool>
void UndoPooledUses(Pool& pool, std::uint64_t number) noexcept
{
    for (auto& [key, object] : pool)
    {
        object.lastUse = std::min(object.lastUse, number - 1);
    }
}

/// Erases the objects that a submission made.
template <typename Pool>
void ErasePooledOf(Pool& pool, std::uint64_t number) noexcept
{
    std::erase_if(pool, [&](const auto& entry) { return entry.second.createdBy == number; });
}

/// Erases the objects that have no owner and no use. Returns their number.
template <typename Pool>
std::size_t SweepPooled(Pool& pool, std::uint64_t finished)
{
    return std::erase_if(
        pool, [&](const auto& entry)
        { return entry.second.owner.expired() && entry.second.lastUse <= finished; });
}

} // namespace limn::vulkan
