#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace limn::study
{

/// A logarithmic axis that all finite values from 1e-150 to 1e150 are on. Those of zero and below
/// have no place on one: they are drawn at its lower end, whose tick says so.
struct LogAxis
{
    double low = 0.1;
    double high = 1.0;
    bool clamps = false; ///< some values are drawn at `low`
    /// Where ticks are and what stands there.
    std::vector<std::pair<double, std::string>> ticks;

    double Clamped(double value) const; ///< NaN stays
    double Part(double value) const;    ///< of the axis: 0 at `low`, 1 at `high`
};

/// @param values  those that are not finite have no say
LogAxis MakeLogAxis(std::span<const double> values);
/// With ticks where they are given, of which there must be one above zero, and nowhere else.
LogAxis MakeLogAxis(std::vector<std::pair<double, std::string>> ticks);

} // namespace limn::study
