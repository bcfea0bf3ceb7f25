#pragma once

#include "report/figures/Pareto.h"

#include <optional>

namespace limn::study
{

struct PlotPoint
{
    TimeAndError at{}; ///< x and y, whatever they are of
    std::pair<double, double> barX{};
    std::pair<double, double> barY{}; ///< NaN for none
    std::string name;                 ///< stands beside it; "" for none
    bool isOnFront = false;
};

/// Points that look alike.
struct PlotSeries
{
    std::string name;
    std::size_t style = 0;  ///< the same for a technique in all plots
    bool isArticle = false; ///< hollow points, broken lines
    bool hasLine = false;
    std::vector<PlotPoint> points;
};

/// What is to be drawn; both axes are logarithmic.
struct Plot
{
    std::string file; ///< its name without ending, "error_time"
    std::string title;
    std::string caption; ///< sentences: what is drawn, of what
    std::string labelX;
    std::string labelY;
    std::vector<std::pair<double, std::string>> ticksX;    ///< {} = by the values
    std::vector<std::pair<double, std::string>> verticals; ///< lines and what they are
    std::vector<PlotSeries> series;
    std::vector<TimeAndError> front; ///< {} = none

    bool isEmpty() const; ///< it has no point that is finite
};

/// Error against time, error against width, time against resolution, time against the number of
/// objects, flicker against time; those for which nothing was measured are empty.
std::vector<Plot> PlotsOf(const Study& study, const Comparison& comparison,
                          std::optional<double> budgetMilliseconds);

enum class PlotFormat
{
    Svg,
    NarrowSvg, ///< for a phone
    Png
};

/// The plot in gnuplot's language, to its standard output.
std::string PlotScript(const Plot& plot, PlotFormat format);

} // namespace limn::study
