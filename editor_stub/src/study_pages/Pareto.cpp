#include "study_pages/Pareto.h"

#include "study_pages/Numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace limn::study
{

namespace
{

constexpr double k_NaN = std::numeric_limits<double>::quiet_NaN();
constexpr const char* k_Error = "meanAbsoluteError";
constexpr const char* k_Time = "gpuAddedMilliseconds";
constexpr const char* k_TimeUncertainty = "gpuAddedUncertainty";
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

std::pair<double, double> QuartilesOf(const CellResult& cell, const char* metric)
{
    const auto found = cell.quartiles.find(metric);
    return found == cell.quartiles.end() ? std::pair(k_NaN, k_NaN) : found->second;
}

std::set<std::string> TechniquesWith(const Study& study, CellKind kind, double width,
                                     const char* metric)
{
    std::set<std::string> names;
    for (const CellResult& cell : study.cells)
    {
        if (IsPlain(cell, kind, width) && HasFinite(cell, metric))
        {
            names.insert(cell.id.technique);
        }
    }
    return names;
}

/// Of what was counted, those with the highest count, in their order.
template <typename Thing>
std::vector<Thing> MostFrequent(const std::map<Thing, std::size_t>& counts)
{
    std::vector<Thing> best;
    std::size_t most = 0;
    for (const auto& [thing, count] : counts)
    {
        if (count > most)
        {
            best.clear();
        }
        if (count >= most)
        {
            best.push_back(thing);
            most = count;
        }
    }
    return best;
}

double BestWidth(const Study& study)
{
    std::map<double, std::size_t> counts; // techniques with both figures
    for (const CellResult& cell : study.cells)
    {
        const double width = cell.id.width;
        if (std::isfinite(width) && IsPlain(cell, CellKind::Geometry, width) &&
            !counts.contains(width))
        {
            const auto errors = TechniquesWith(study, CellKind::Geometry, width, k_Error);
            const auto times = TechniquesWith(study, CellKind::Cost, width, k_Time);
            counts[width] = static_cast<std::size_t>(std::ranges::count_if(
                errors, [&times](const auto& name) { return times.contains(name); }));
        }
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

void AddError(Standing& standing, const Study& study, const Comparison& comparison)
{
    std::vector<double> errors;
    for (const CellResult& cell : study.cells)
    {
        if (IsPlain(cell, CellKind::Geometry, comparison.width) &&
            cell.id.technique == standing.technique->name && cell.Has(k_Error) &&
            (comparison.subject.empty() || cell.id.subject == comparison.subject))
        {
            errors.push_back(cell.Value(k_Error));
            standing.errorQuartiles = QuartilesOf(cell, k_Error);
        }
    }
    const Spread spread = SpreadOf(errors);
    standing.at.error = errors.size() == 1 ? errors.front() : spread.median;
    if (errors.size() > 1)
    {
        standing.errorQuartiles = {spread.lower, spread.upper};
    }
}

bool IsCompared(const CellResult& cell, const Comparison& comparison)
{
    return IsPlain(cell, CellKind::Cost, comparison.width) &&
           cell.id.pictureWidth == comparison.pictureWidth &&
           cell.id.pictureHeight == comparison.pictureHeight && HasFinite(cell, k_Time);
}

void AddTime(Standing& standing, const Study& study, const Comparison& comparison)
{
    for (const CellResult& cell : study.cells)
    {
        if (IsCompared(cell, comparison) && cell.id.technique == standing.technique->name)
        {
            standing.at.milliseconds = cell.Value(k_Time);
            standing.timeQuartiles = QuartilesOf(cell, k_Time);
            standing.timeUncertainty =
                cell.Has(k_TimeUncertainty) ? cell.Value(k_TimeUncertainty) : 0.0;
        }
    }
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

void AddStability(Standing& standing, const Study& study)
{
    for (const CellResult& cell : study.cells)
    {
        if (cell.id.kind == CellKind::Stability && cell.id.technique == standing.technique->name)
        {
            ++standing.stabilityCells;
            standing.failures += cell.Value("failures") > 0.0 ? 1 : 0;
        }
    }
}

std::string Place(const Comparison& comparison)
{
    return Readable(comparison.width) + " px wide, in a picture of " +
           std::to_string(comparison.pictureWidth) + "x" + std::to_string(comparison.pictureHeight);
}

std::string Figures(const Standing& standing)
{
    const std::string time = Readable(standing.at.milliseconds) + " ms";
    const bool isLost = standing.at.milliseconds <= standing.timeUncertainty;
    return "mean error " + Readable(standing.at.error) + " for " +
           (isLost ? "a time that this run cannot tell from 0 (" + time + ")" : time);
}

/// What is better, were there more time.
std::string MoreTimeBuys(const Comparison& comparison, const Standing* chosen)
{
    for (const std::size_t index : comparison.front)
    {
        const Standing& other = comparison.standings[index];
        if (chosen != nullptr && other.at.error < chosen->at.error)
        {
            return " More time buys less error: " + other.technique->name + " has " +
                   Figures(other) + ".";
        }
    }
    return "";
}

/// Those whose error is the chosen one's to a hundredth and whose time may be as short, as well as
/// the two medians are known.
std::string AsGood(const Comparison& comparison, const Standing& chosen, double budget)
{
    std::string names;
    for (const Standing& other : comparison.standings)
    {
        const bool isNear = other.at.error <= chosen.at.error * 1.01 &&
                            other.at.milliseconds <= budget &&
                            other.at.milliseconds - other.timeUncertainty <=
                                chosen.at.milliseconds + chosen.timeUncertainty;
        if (isNear && &other != &chosen)
        {
            names += (names.empty() ? "" : ", ") + other.technique->name;
        }
    }
    return names.empty() ? "" : " As good, as far as the times tell: " + names + ".";
}

} // namespace

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
    std::ranges::stable_sort(order, {},
                             [&](std::size_t i)
                             { return std::pair(points[i].milliseconds, points[i].error); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
    {
        const bool isEqual = !front.empty() &&
                             points[i].milliseconds == points[front.back()].milliseconds &&
                             points[i].error == points[front.back()].error;
        if (front.empty() || points[i].error < points[front.back()].error || isEqual)
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
    const bool hasScene =
        std::ranges::any_of(study.cells,
                            [&](const CellResult& cell)
                            {
                                return IsPlain(cell, CellKind::Geometry, comparison.width) &&
                                       cell.id.subject == k_Scene && HasFinite(cell, k_Error);
                            });
    comparison.subject = hasScene ? k_Scene : "";
    std::vector<TimeAndError> points;
    for (const TechniqueInfo& technique : study.techniques)
    {
        Standing standing{&technique, {k_NaN, k_NaN}, {k_NaN, k_NaN}, {k_NaN, k_NaN}};
        AddError(standing, study, comparison);
        AddTime(standing, study, comparison);
        AddStability(standing, study);
        points.push_back(standing.at);
        comparison.standings.push_back(standing);
    }
    comparison.front = ParetoFront(points);
    return comparison;
}

Recommendation Recommend(const Comparison& comparison, double budgetMilliseconds)
{
    Recommendation result;
    for (const std::size_t index : comparison.front)
    {
        const Standing& standing = comparison.standings[index];
        // Along the front the error falls, but for equal points, of which the first is taken.
        if (standing.at.milliseconds <= budgetMilliseconds &&
            (result.standing == nullptr || standing.at.error < result.standing->at.error))
        {
            result.standing = &standing;
        }
    }
    const std::string budget = std::isinf(budgetMilliseconds)
                                   ? "With all the time there is"
                                   : "Within " + Readable(budgetMilliseconds) + " ms";
    if (result.standing != nullptr)
    {
        const Standing& chosen = *result.standing;
        result.sentence = budget + " take " + chosen.technique->name + ": " + Figures(chosen) +
                          " (" + Place(comparison) + ").";
        if (chosen.failures > 0)
        {
            result.sentence += " It failed " + std::to_string(chosen.failures) + " of " +
                               Count(chosen.stabilityCells, "stability check") + ".";
        }
        result.sentence += AsGood(comparison, chosen, budgetMilliseconds);
        result.sentence += MoreTimeBuys(comparison, result.standing);
    }
    else if (comparison.front.empty())
    {
        result.sentence = "No technique has both an error and a time to choose by.";
    }
    else
    {
        const Standing& quickest = comparison.standings[comparison.front.front()];
        result.sentence = "Nothing fits " + Readable(budgetMilliseconds) +
                          " ms: the quickest outline is " + quickest.technique->name + " with " +
                          Figures(quickest) + " (" + Place(comparison) + ").";
    }
    return result;
}

} // namespace limn::study
