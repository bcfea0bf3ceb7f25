#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace limn::test
{

/// The sum of up to eight numbers, right but for the last rounding; its sign is always right, and
/// it is 0 only where the sum is. Kept as numbers that do not overlap, smallest first (Shewchuk,
/// "Adaptive Precision Floating-Point Arithmetic", 1997, grow-expansion).
/// @param terms  finite, and so are their sums
inline double ExactSum(std::initializer_list<double> terms)
{
    std::array<double, 9> parts{};
    std::size_t count = 0;
    for (double sum : terms)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i)
        {
            const double part = parts[i];
            const double rounded = sum + part;
            const double ofPart = rounded - sum;
            const double lost = (sum - (rounded - ofPart)) + (part - ofPart);
            if (lost != 0.0)
            {
                parts[kept++] = lost;
            }
            sum = rounded;
        }
        parts[kept++] = sum;
        count = kept;
    }
    double total = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
        total += parts[i];
    }
    return total;
}

} // namespace limn::test
