#include "report/figures/Pareto.h"

#include "report/figures/Numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace limn::study
{

namespace
{

constexpr double k_NaN = std::numeric_limits<double>::quiet_NaN();
constexpr const char* k_Error = "meanAbsoluteError";
constexpr const char* k_Time = "gpuAddedMilliseconds";
constexpr const char* k_TimeUncertainty = "gpuAddedUncertainty";
constexpr const char* k_Flicker = "flicker";
constexpr const char* k_QuietPart = "quietPart";
constexpr const char* k_Scene = "scene";

bool HasFinite(const CellResult& cell, const char* metric)
{
    return std::isfinite(cell.Value(metric));
}

/// A cell as most are: of the kind, nothing unusual.
bool IsPlain(const CellResult& cell, CellKind kind, double width)
{
    return cell.id.kind == kind && cell.id.variant.empty() && cell.id.width == width;
}

/// Returns the things with the highest count, in their order.
template <typename Thing>
std::vector<Thing> MostFrequent(const std::map<Thing, std::size_t>& counts)
{
    std::vector<Thing> best;
    const auto most =
        std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
    for (const auto& [thing, count] : counts)
    {
        if (count == most->second)
        {
            best.push_back(thing);
        }
    }
    return best;
}

double BestWidth(const Study& study)
{
    std::map<double, std::set<std::string>> errors; // the techniques that have one, by width
    std::map<double, std::set<std::string>> times;
    for (const CellResult& cell : study.cells)
    {
        const double width = cell.id.width;
        if (std::isfinite(width) && IsPlain(cell, CellKind::Geometry, width))
        {
            std::set<std::string>& names = errors[width]; // empty without an error
            if (HasFinite(cell, k_Error))
            {
                names.insert(cell.id.technique);
            }
        }
        if (IsPlain(cell, CellKind::Cost, width) && HasFinite(cell, k_Time))
        {
            times[width].insert(cell.id.technique);
        }
    }
    std::map<double, std::size_t> counts; // techniques with both figures
    for (const auto& [width, names] : errors)
    {
        counts[width] = static_cast<std::size_t>(std::ranges::count_if(
            names, [&both = times[width]](const auto& name) { return both.contains(name); }));
    }
    const std::vector<double> widths = MostFrequent(counts);
    return widths.empty() ? 0.0 : widths[(widths.size() - 1) / 2];
}

/// Width and height of the pictures whose cost most techniques have.
std::pair<int, int> BestSize(const Study& study, double width)
{
    std::map<std::pair<int, int>, std::size_t> counts;
    std::pair<int, int> ofScene;
    for (const CellResult& cell : study.cells)
    {
        const std::pair<int, int> size(cell.id.pictureWidth, cell.id.pictureHeight);
        if (IsPlain(cell, CellKind::Cost, width) && HasFinite(cell, k_Time))
        {
            ++counts[size];
        }
        if (IsPlain(cell, CellKind::Geometry, width) && cell.id.subject == k_Scene)
        {
            ofScene = size;
        }
    }
    const auto sizes = MostFrequent(counts);
    const bool hasScenes = std::ranges::find(sizes, ofScene) != sizes.end();
    return hasScenes ? ofScene : sizes.empty() ? std::pair(0, 0) : sizes.back();
}

bool IsCompared(const CellResult& cell, const Comparison& comparison)
{
    return IsPlain(cell, CellKind::Cost, comparison.width) &&
           cell.id.pictureWidth == comparison.pictureWidth &&
           cell.id.pictureHeight == comparison.pictureHeight && HasFinite(cell, k_Time);
}

/// Everything that was measured of a technique and belongs to the comparison.
Standing StandingOf(const Technique& technique, const Study& study, const Comparison& comparison)
{
    Standing standing{&technique};
    std::vector<double> errors;
    std::vector<double> flicker;
    for (const CellResult& cell : study.cells)
    {
        if (cell.id.technique != technique.name)
        {
            continue;
        }
        if (IsPlain(cell, CellKind::Geometry, comparison.width) && cell.Has(k_Error) &&
            (comparison.subject.empty() || cell.id.subject == comparison.subject))
        {
            errors.push_back(cell.Value(k_Error));
            standing.errorQuartiles = cell.Quartiles(k_Error);
        }
        else if (IsCompared(cell, comparison))
        {
            standing.at.milliseconds = cell.Value(k_Time);
            standing.timeQuartiles = cell.Quartiles(k_Time);
            standing.timeUncertainty = cell.Value(k_TimeUncertainty);
        }
        else if (IsPlain(cell, CellKind::Temporal, comparison.flickerWidth))
        {
            flicker.push_back(cell.Value(k_Flicker));
        }
        else if (cell.id.kind == CellKind::Stability)
        {
            ++standing.stabilityCells;
            standing.failures += cell.Value("failures") > 0.0 ? 1 : 0;
        }
    }
    const Spread spread = SpreadOf(errors);
    standing.at.error = errors.size() == 1 ? errors.front() : spread.median;
    if (errors.size() > 1)
    {
        standing.errorQuartiles = {spread.lower, spread.upper};
    }
    standing.flicker = SpreadOf(flicker);
    return standing;
}

LoadOfStudy LoadOf(const Study& study, const Comparison& comparison)
{
    LoadOfStudy load;
    std::set<std::string> measurements;
    for (const CellResult& cell : study.cells)
    {
        // Measurements that were not made at once differ in this.
        const std::string name =
            cell.id.NameForAllTechniques() + Exact(cell.Value("quietMilliseconds"));
        if (!cell.Has(k_QuietPart) || !measurements.insert(name).second)
        {
            continue;
        }
        const double part = cell.Value(k_QuietPart);
        ++load.measurements;
        load.changed += HasLoadChanged(part) ? 1 : 0;
        if (!IsCompared(cell, comparison))
        {
            continue;
        }
        load.otherPrograms = std::max(load.otherPrograms, cell.Value("otherPrograms"));
        if (!(part >= load.quietPart))
        {
            load.quietPart = part;
            load.quietMilliseconds = cell.Value("quietMilliseconds");
            load.busyMilliseconds = cell.Value("busyMilliseconds");
        }
    }
    return load;
}

double MedianFloor(const Study& study, const Comparison& comparison)
{
    std::vector<double> floors;
    for (const CellResult& cell : study.cells)
    {
        if (IsCompared(cell, comparison))
        {
            floors.push_back(cell.Value("floorMilliseconds"));
        }
    }
    return SpreadOf(floors).median;
}

} // namespace

double NearestWidth(const Study& study, double wanted,
                    const std::function<bool(const CellResult&)>& isOne)
{
    double best = k_NaN;
    for (const CellResult& cell : study.cells)
    {
        if (isOne(cell) && !(std::abs(cell.id.width - wanted) >= std::abs(best - wanted)))
        {
            best = cell.id.width;
        }
    }
    return best;
}

std::vector<std::size_t> ParetoFront(std::span<const TimeAndError> points)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (std::isfinite(points[i].milliseconds) && std::isfinite(points[i].error))
        {
            order.push_back(i);
        }
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return points[i]; });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
    {
        if (front.empty() || points[i].error < points[front.back()].error ||
            points[i] == points[front.back()])
        {
            front.push_back(i);
        }
    }
    return front;
}

Comparison Compare(const Study& study, double width)
{
    Comparison comparison;
    comparison.width = width > 0.0 ? width : BestWidth(study);
    std::tie(comparison.pictureWidth, comparison.pictureHeight) = BestSize(study, comparison.width);
    comparison.floorMilliseconds = MedianFloor(study, comparison);
    comparison.flickerWidth = NearestWidth(
        study, comparison.width,
        [](const CellResult& cell)
        { return IsPlain(cell, CellKind::Temporal, cell.id.width) && HasFinite(cell, k_Flicker); });
    comparison.load = LoadOf(study, comparison);
    const auto isOfScene = [&comparison](const CellResult& cell)
    {
        return IsPlain(cell, CellKind::Geometry, comparison.width) && cell.id.subject == k_Scene &&
               HasFinite(cell, k_Error);
    };
    comparison.subject = std::ranges::any_of(study.cells, isOfScene) ? k_Scene : "";
    std::vector<TimeAndError> points;
    for (const Technique& technique : study.techniques)
    {
        const Standing& standing =
            comparison.standings.emplace_back(StandingOf(technique, study, comparison));
        points.push_back(standing.IsTimeKnown() ? standing.at : TimeAndError{k_NaN, k_NaN});
    }
    comparison.front = ParetoFront(points);
    return comparison;
}

} // namespace limn::study
