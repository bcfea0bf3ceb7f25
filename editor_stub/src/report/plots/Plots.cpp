#include "report/plots/Plots.h"

#include "console/Texts.h"
#include "report/figures/Numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace limn::study
{

namespace
{

constexpr double k_NoBar = std::numeric_limits<double>::quiet_NaN();
constexpr const char* k_TimeLabel = "GPU time added, ms";
constexpr const char* k_ErrorLabel = "mean error of the coverage";

/// It has both figures; without its uncertainty, a time would look as if it were known.
bool HasPlace(const Standing& standing)
{
    return std::isfinite(standing.at.error) && std::isfinite(standing.LongestTime());
}

/// One point a technique, in two series: limn's own and the articles'.
std::vector<PlotSeries> NamedPoints(const std::vector<Standing>& standings,
                                    std::span<const std::size_t> front = {})
{
    std::vector<PlotSeries> series = {{"limn's", 0, false, false},
                                      {"an article's own formula", 1, true, false}};
    for (std::size_t i = 0; i < standings.size(); ++i)
    {
        const Standing& standing = standings[i];
        const Technique& technique = *standing.technique;
        if (HasPlace(standing))
        {
            series[technique.isArticle ? 1 : 0].points.push_back(
                {standing.at,
                 {standing.ShortestTime(), standing.LongestTime()},
                 standing.errorQuartiles,
                 technique.name,
                 std::ranges::count(front, i) > 0});
        }
    }
    return series;
}

std::string NotDrawn(const Comparison& comparison)
{
    std::vector<std::string> names;
    for (const Standing& standing : comparison.standings)
    {
        if (!HasPlace(standing))
        {
            names.push_back(standing.technique->name);
        }
    }
    return names.empty() ? ""
                         : " Not in it, for want of an error or of a time that this run knows: " +
                               Joined(names, ", ") + ".";
}

Plot ErrorAgainstTime(const Comparison& comparison, std::optional<double> budget)
{
    const std::string width = Readable(comparison.width);
    Plot plot{
        "error_time", "Error against GPU time, " + width + " px wide",
        std::string("Mean error (") +
            (comparison.subject.empty() ? "median over all shapes" : "the outline in the scene") +
            ") of an outline of " + width + " px against the GPU time it adds to a frame of " +
            SizeText(comparison.pictureWidth, comparison.pictureHeight) +
            "; less is better of both. Bars show where the median of the time lies with "
            "95 %. No technique is better in both than one on the line." +
            NotDrawn(comparison),
        k_TimeLabel, k_ErrorLabel};
    plot.isLessBetter = true;
    plot.series = NamedPoints(comparison.standings, comparison.front);
    for (const std::size_t index : comparison.front)
    {
        plot.front.push_back(comparison.standings[index].at);
    }
    if (comparison.floorMilliseconds > 0.0 && std::isfinite(comparison.floorMilliseconds))
    {
        plot.verticals.emplace_back(comparison.floorMilliseconds, "floor");
        plot.caption += " Floor: " + Readable(comparison.floorMilliseconds) +
                        " ms, the outline's pixels copied once at this device's bandwidth.";
    }
    if (budget && *budget > 0.0 && std::isfinite(*budget))
    {
        plot.verticals.emplace_back(*budget, "budget");
    }
    return plot;
}

/// A line a technique through the cells that are wanted.
/// @param x  of a cell; NaN where it is not wanted
std::vector<PlotSeries> Lines(const Study& study, const char* metric,
                              const std::function<double(const CellResult&)>& x)
{
    std::vector<PlotSeries> result;
    for (std::size_t i = 0; i < study.techniques.size(); ++i)
    {
        const Technique& technique = study.techniques[i];
        PlotSeries series{technique.name, i, technique.isArticle, true};
        for (const CellResult& cell : study.cells)
        {
            if (cell.id.technique == technique.name && std::isfinite(cell.Value(metric)) &&
                std::isfinite(x(cell)))
            {
                series.points.push_back(
                    {{x(cell), cell.Value(metric)}, {k_NoBar, k_NoBar}, cell.Quartiles(metric)});
            }
        }
        std::ranges::stable_sort(series.points, {},
                                 [](const PlotPoint& point) { return point.at.milliseconds; });
        if (!series.points.empty())
        {
            result.push_back(std::move(series));
        }
    }
    return result;
}

/// Without lines if there is but one place along the axis.
void SetTicks(Plot& plot, const std::map<double, std::string>& ticks)
{
    plot.ticksX.assign(ticks.begin(), ticks.end());
    if (ticks.size() < 2)
    {
        plot.series.clear();
    }
}

bool IsPlainError(const CellResult& cell)
{
    return cell.id.kind == CellKind::Geometry && cell.id.variant.empty() && cell.id.width > 0.0 &&
           std::isfinite(cell.id.width) && std::isfinite(cell.Value("meanAbsoluteError"));
}

/// Returns the subject that was outlined in the most widths; of several it is the scene.
std::string SubjectOfMostWidths(const Study& study)
{
    std::map<std::string, std::set<double>> widths;
    for (const CellResult& cell : study.cells)
    {
        if (IsPlainError(cell))
        {
            widths[cell.id.subject].insert(cell.id.width);
        }
    }
    const auto best = std::ranges::max_element(
        widths, {},
        [](const auto& entry) { return std::pair(entry.second.size(), entry.first == "scene"); });
    return best == widths.end() ? "" : best->first;
}

Plot ErrorAgainstWidth(const Study& study)
{
    const std::string subject = SubjectOfMostWidths(study);
    Plot plot{"error_width", "Error against width: " + subject,
              "Mean error of the outline of '" + subject + "' against the width asked.",
              "width asked, px", k_ErrorLabel};
    std::map<double, std::string> ticks;
    plot.series = Lines(study, "meanAbsoluteError",
                        [&](const CellResult& cell)
                        {
                            if (!IsPlainError(cell) || cell.id.subject != subject)
                            {
                                return k_NoBar;
                            }
                            ticks[cell.id.width] = Readable(cell.id.width);
                            return cell.id.width;
                        });
    SetTicks(plot, ticks);
    return plot;
}

Plot TimeAgainstResolution(const Study& study, const Comparison& comparison)
{
    const std::string width = Readable(comparison.width);
    Plot plot{"time_resolution", "GPU time against resolution, " + width + " px wide",
              "GPU time that an outline of " + width +
                  " px adds to a frame, against the frame's pixels; bars from the lower to the "
                  "upper quartile.",
              "picture, pixels", k_TimeLabel};
    std::map<double, std::string> ticks;
    plot.series = Lines(
        study, "gpuAddedMilliseconds",
        [&](const CellResult& cell)
        {
            const CellId& id = cell.id;
            if (id.kind != CellKind::Cost || !id.variant.empty() || id.width != comparison.width)
            {
                return k_NoBar;
            }
            const double pixels = static_cast<double>(id.pictureWidth) * id.pictureHeight;
            ticks[pixels] = SizeText(id.pictureWidth, id.pictureHeight);
            return pixels;
        });
    SetTicks(plot, ticks);
    return plot;
}

/// Returns 100 for a variant "100 objects", NaN for other variants.
double ObjectCount(const CellId& id)
{
    double count = 0.0;
    const char* const end = id.variant.data() + id.variant.size();
    const auto [rest, error] = std::from_chars(id.variant.data(), end, count);
    const bool isCount = error == std::errc() && std::string_view(rest, end).starts_with(" object");
    return isCount && id.kind == CellKind::Cost ? count : k_NoBar;
}

Plot TimeAgainstObjects(const Study& study)
{
    Plot plot{"time_objects", "GPU time against the number of objects", "", "outlined objects",
              k_TimeLabel};
    std::map<double, std::string> ticks;
    std::set<std::string> what;
    plot.series = Lines(study, "gpuAddedMilliseconds",
                        [&](const CellResult& cell)
                        {
                            const double count = ObjectCount(cell.id);
                            if (count > 0.0)
                            {
                                ticks[count] = Readable(count);
                                what.insert(Readable(cell.id.width) + " px at " +
                                            SizeText(cell.id.pictureWidth, cell.id.pictureHeight));
                            }
                            return count;
                        });
    plot.caption =
        "GPU time that outlines add to a frame, against how many objects are outlined (" +
        Joined(what, ", ") + "); bars from the lower to the upper quartile.";
    SetTicks(plot, ticks);
    return plot;
}

Plot FlickerAgainstTime(const Comparison& comparison)
{
    Plot plot{"flicker_time", "Flicker against GPU time",
              "The change beyond that of the exact outline in motion by sixteenths of a pixel (" +
                  Readable(comparison.flickerWidth) +
                  " px wide, median over what moved, bars over its quartiles and where the median "
                  "of the time lies with 95 %), against the GPU time added to a frame of " +
                  SizeText(comparison.pictureWidth, comparison.pictureHeight) + " (" +
                  Readable(comparison.width) + " px wide).",
              k_TimeLabel, "flicker"};
    plot.isLessBetter = true;
    std::vector<Standing> standings = comparison.standings;
    for (Standing& standing : standings)
    {
        standing.at.error = standing.flicker.median;
        standing.errorQuartiles = {standing.flicker.lower, standing.flicker.upper};
    }
    plot.series = NamedPoints(standings);
    return plot;
}

} // namespace

bool Plot::isEmpty() const
{
    return std::ranges::all_of(series, [](const PlotSeries& one) { return one.points.empty(); });
}

std::vector<Plot> PlotsOf(const Study& study, const Comparison& comparison,
                          std::optional<double> budgetMilliseconds)
{
    return {ErrorAgainstTime(comparison, budgetMilliseconds), ErrorAgainstWidth(study),
            TimeAgainstResolution(study, comparison), TimeAgainstObjects(study),
            FlickerAgainstTime(comparison)};
}

} // namespace limn::study
