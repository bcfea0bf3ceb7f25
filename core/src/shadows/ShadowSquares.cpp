#include "shadows/ShadowSquares.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>

namespace limn
{

namespace
{

/// The even bits of a number: one coordinate of a place that goes through squares of squares.
int EvenBits(std::uint64_t bits)
{
    int result = 0;
    for (int i = 0; i < 31; ++i)
    {
        result |= static_cast<int>((bits >> (2 * i)) & 1) << i;
    }
    return result;
}

} // namespace

void PlaceShadowSquares(std::span<const ShadowSquares> requests, int size,
                        std::vector<ViewportRect>& result)
{
    static thread_local std::vector<std::size_t> order; // for its memory, as the next one
    static thread_local std::vector<std::size_t> first;
    const auto region = static_cast<int>(std::bit_floor(static_cast<unsigned>(size)));
    const auto sideOf = [&](std::size_t i)
    {
        const int side = std::clamp(requests[i].side, 1, region);
        return static_cast<int>(std::bit_floor(static_cast<unsigned>(side)));
    };
    order.resize(requests.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(-sideOf(i), i); });
    first.clear();
    std::size_t count = 0;
    for (const ShadowSquares& request : requests)
    {
        first.push_back(count);
        count += static_cast<std::size_t>(request.count);
    }
    result.assign(count, ViewportRect());

    int factor = 1;
    for (; !order.empty(); order.pop_back(), factor = 1)
    {
        double area = 0.0;
        for (const std::size_t i : order)
        {
            area += static_cast<double>(sideOf(i)) * sideOf(i) * requests[i].count;
        }
        const double room = static_cast<double>(region) * region;
        while (area > room * factor * factor)
        {
            factor *= 2;
        }
        if (sideOf(order.back()) / factor >= requests[order.back()].least)
        {
            break;
        }
    }
    std::uint64_t used = 0; // texels: of larger squares, so that it is a multiple of each
    for (const std::size_t i : order)
    {
        const int side = sideOf(i) / factor;
        const auto area = static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
        for (int k = 0; k < requests[i].count; ++k, used += area)
        {
            const std::uint64_t place = used / area;
            result[first[i] + static_cast<std::size_t>(k)] = {
                EvenBits(place) * side, EvenBits(place >> 1) * side, side, side};
        }
    }
}

} // namespace limn
