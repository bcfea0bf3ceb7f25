#pragma once

#include "report/figures/Pareto.h"

#include <optional>

namespace limn::study
{

struct PlotPoint
{
    TimeAndError at{}; ///< x and y, in the units of the plot; finite
    std::pair<double, double> barX{};
    std::pair<double, double> barY{}; ///< NaN for none
    std::string name = {};            ///< shown beside the point; "" for none
    bool isOnFront = false;
};

/// Points that have the same look.
struct PlotSeries
{
    std::string name;
    std::size_t style = 0;  ///< the same for a technique in all plots
    bool isArticle = false; ///< true for hollow points and broken lines
    bool hasLine = false;
    std::vector<PlotPoint> points = {};
};

/// A plot to draw. Both axes are logarithmic.
struct Plot
{
    std::string file; ///< the file's name without its ending, "error_time"
    std::string title;
    std::string caption; ///< sentences about what is drawn
    std::string labelX;
    std::string labelY;
    std::vector<std::pair<double, std::string>> ticksX = {};    ///< {} = by the values
    std::vector<std::pair<double, std::string>> verticals = {}; ///< vertical lines and their texts
    std::vector<PlotSeries> series = {};
    std::vector<TimeAndError> front = {}; ///< {} = none
    bool isLessBetter = false;            ///< true if an arrow points to small values of both axes

    bool isEmpty() const; ///< true if it has no point
};

/// Returns the plots: error against time, error against width, time against resolution, time
/// against the number of objects, flicker against time. Plots for which nothing was measured are
/// empty.
std::vector<Plot> PlotsOf(const Study& study, const Comparison& comparison,
                          std::optional<double> budgetMilliseconds);

enum class PlotFormat
{
    Svg,
    NarrowSvg, ///< for a phone
    Png
};

/// Returns a script in gnuplot's language that draws the plot to gnuplot's standard output.
std::string PlotScript(const Plot& plot, PlotFormat format);

} // namespace limn::study
