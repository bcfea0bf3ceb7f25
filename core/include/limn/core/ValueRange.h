#pragma once

#include <limits>

namespace limn
{

/// The smallest and the largest number allowed; both are allowed themselves.
struct ValueRange
{
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();

    bool operator==(const ValueRange&) const = default;
};

} // namespace limn
