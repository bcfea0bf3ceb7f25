#include "renderers/SortEntries.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace limn
{

namespace
{

constexpr int k_DigitBits = 11;
constexpr std::size_t k_DigitCount = std::size_t{1} << k_DigitBits;
constexpr std::size_t k_Few = 64;

/// Passes over the digits of `value` that are not the same in all entries, the lowest first.
template <typename Entry, typename Value>
void SortBy(std::vector<Entry>& entries, std::vector<Entry>& spare, Value value)
{
    std::uint64_t differing = 0;
    for (const Entry& entry : entries)
    {
        differing |= value(entry) ^ value(entries.front());
    }
    while (differing != 0)
    {
        const int shift = std::countr_zero(differing);
        const auto digit = [&](const Entry& entry)
        {
            return (value(entry) >> shift) & (k_DigitCount - 1);
        };
        std::array<std::uint32_t, k_DigitCount> place{};
        for (const Entry& entry : entries)
        {
            ++place[digit(entry)];
        }
        std::uint32_t next = 0;
        for (std::uint32_t& count : place)
        {
            next += std::exchange(count, next);
        }
        for (const Entry& entry : entries)
        {
            spare[place[digit(entry)]++] = entry;
        }
        entries.swap(spare);
        differing = shift + k_DigitBits < 64
                        ? differing >> (shift + k_DigitBits) << (shift + k_DigitBits)
                        : 0;
    }
}

/// Sorts by insertion, without passes over tables that are longer than the entries.
template <typename Entry, typename Before>
void SortFew(std::vector<Entry>& entries, Before isBefore)
{
    for (auto entry = entries.begin(); entry != entries.end(); ++entry)
    {
        std::rotate(std::upper_bound(entries.begin(), entry, *entry, isBefore), entry, entry + 1);
    }
}

} // namespace

void RadixSort(std::vector<SortEntry>& entries, std::vector<SortEntry>& spare, int stateBits)
{
    const std::uint64_t mask = (std::uint64_t{1} << stateBits) - 1;
    if (entries.size() <= k_Few)
    {
        SortFew(entries, [mask](const SortEntry& a, const SortEntry& b)
                { return a.key != b.key ? a.key < b.key : (a.state & mask) < (b.state & mask); });
        return;
    }
    spare.resize(entries.size());
    SortBy(entries, spare, [mask](const SortEntry& entry) { return entry.state & mask; });
    SortBy(entries, spare, [](const SortEntry& entry) { return entry.key; });
}

void RadixSort(std::vector<std::uint64_t>& words, std::vector<std::uint64_t>& spare, int firstBit)
{
    if (firstBit >= 64)
    {
        return;
    }
    if (words.size() <= k_Few)
    {
        SortFew(words, [firstBit](std::uint64_t a, std::uint64_t b)
                { return a >> firstBit < b >> firstBit; });
    }
    else
    {
        spare.resize(words.size());
        SortBy(words, spare, [firstBit](std::uint64_t word) { return word >> firstBit; });
    }
}

} // namespace limn
