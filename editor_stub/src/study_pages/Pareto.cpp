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
            standing.timeUncertainty = cell.Value(k_TimeUncertainty);
        }
    }
}

/// The width of temporal cells that is nearest to the wanted one.
double FlickerWidth(const Study& study, double wanted)
{
    double best = k_NaN;
    for (const CellResult& cell : study.cells)
    {
        if (IsPlain(cell, CellKind::Temporal, cell.id.width) && HasFinite(cell, k_Flicker) &&
            !(std::abs(cell.id.width - wanted) >= std::abs(best - wanted)))
        {
            best = cell.id.width;
        }
    }
    return best;
}

void AddFlicker(Standing& standing, const Study& study, const Comparison& comparison)
{
    std::vector<double> flicker;
    for (const CellResult& cell : study.cells)
    {
        if (IsPlain(cell, CellKind::Temporal, comparison.flickerWidth) &&
            cell.id.technique == standing.technique->name)
        {
            flicker.push_back(cell.Value(k_Flicker));
        }
    }
    standing.flicker = SpreadOf(flicker);
}

/// Tells the measurements of times apart that were made at once.
std::string MeasurementOf(const CellResult& cell)
{
    CellId id = cell.id;
    id.technique.clear();
    return id.Name() + Exact(cell.Value("quietMilliseconds"));
}

LoadOfStudy LoadOf(const Study& study, const Comparison& comparison)
{
    LoadOfStudy load;
    std::set<std::string> measurements;
    for (const CellResult& cell : study.cells)
    {
        if (!cell.Has(k_QuietPart) || !measurements.insert(MeasurementOf(cell)).second)
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

/// "1.2 ± 0.3 ms", "0.2 ± 0.5 ms, so at most 0.7 ms".
std::string TimeOf(const Standing& standing)
{
    const std::string time = Readable(standing.at.milliseconds);
    if (std::isnan(standing.timeUncertainty))
    {
        return time + " ms";
    }
    const std::string bounded = time + " ± " + Readable(standing.timeUncertainty) + " ms";
    return standing.IsTimeKnown()
               ? bounded
               : bounded + ", so at most " + Readable(standing.LongestTime()) + " ms";
}

std::string Figures(const Standing& standing)
{
    return "mean error " + Readable(standing.at.error) +
           (std::isnan(standing.flicker.median)
                ? ""
                : " and flicker " + Readable(standing.flicker.median)) +
           " for " + TimeOf(standing);
}

std::string Place(const Comparison& comparison)
{
    return Readable(comparison.width) + " px wide, in a picture of " +
           std::to_string(comparison.pictureWidth) + "x" +
           std::to_string(comparison.pictureHeight) +
           (std::isnan(comparison.flickerWidth)
                ? ""
                : "; flicker of shapes, " + Readable(comparison.flickerWidth) + " px wide");
}

/// The time is within the budget however long it is, or known where there is no budget.
bool Fits(const Standing& standing, double budget)
{
    return std::isinf(budget) ? standing.IsTimeKnown()
                              : standing.LongestTime() > 0.0 && standing.LongestTime() <= budget;
}

/// The time may be within the budget or beyond it.
bool MayFit(const Standing& standing, double budget)
{
    return standing.ShortestTime() <= budget && standing.LongestTime() > budget;
}

/// There is a time, but not even how long it is at most.
bool IsUnknown(const Standing& standing, double budget)
{
    return standing.HasTime() && !Fits(standing, budget) && !MayFit(standing, budget) &&
           !(standing.ShortestTime() > budget);
}

/// A standing with less error than the chosen one; every standing with an error if none is chosen.
bool IsNearer(const Standing& standing, const Standing* chosen)
{
    return std::isfinite(standing.at.error) &&
           (chosen == nullptr || standing.at.error < chosen->at.error);
}

/// The least error that fits; of equal errors the quickest. Null if nothing fits.
const Standing* LeastError(const Comparison& comparison, double budget)
{
    const Standing* least = nullptr;
    for (const Standing& standing : comparison.standings)
    {
        const bool isBetter = IsNearer(standing, least) ||
                              (least != nullptr && standing.at.error == least->at.error &&
                               standing.at.milliseconds < least->at.milliseconds);
        if (Fits(standing, budget) && isBetter)
        {
            least = &standing;
        }
    }
    return least;
}

/// Whether a standing has the least error to a hundredth, and a time that may be as short as well
/// as the two are known.
bool IsAsGood(const Standing& standing, const Standing& least, double budget)
{
    return Fits(standing, budget) && standing.at.error <= least.at.error * 1.01 &&
           standing.ShortestTime() <= least.LongestTime();
}

/// Names joined by commas, those with their figures that are wanted.
std::string NamesOf(const Comparison& comparison, const auto& isWanted, const auto& figures)
{
    std::string names;
    for (const Standing& standing : comparison.standings)
    {
        if (isWanted(standing))
        {
            const std::string those = figures(standing);
            names += (names.empty() ? "" : ", ") + standing.technique->name +
                     (those.empty() ? "" : " (" + those + ")");
        }
    }
    return names;
}

/// What has less error and may be better, if more were known.
std::string CannotTell(const Comparison& comparison, const Standing* chosen, double budget)
{
    const std::string undecided = NamesOf(
        comparison,
        [&](const Standing& standing)
        { return IsNearer(standing, chosen) && MayFit(standing, budget); },
        Figures);
    const std::string unknown = NamesOf(
        comparison,
        [&](const Standing& standing)
        { return IsNearer(standing, chosen) && IsUnknown(standing, budget); },
        [](const Standing& standing) { return "mean error " + Readable(standing.at.error); });
    return (undecided.empty() ? ""
                              : " This run cannot tell whether these fit: " + undecided + ".") +
           (unknown.empty() ? "" : " This run does not know the time of " + unknown + ".");
}

/// "Within 2 ms take ".
std::string Opening(const Comparison& comparison, const Standing& chosen, double budget)
{
    if (!std::isinf(budget))
    {
        return "Within " + Readable(budget) + " ms take ";
    }
    const bool isLeast = std::ranges::none_of(
        comparison.standings, [&](const Standing& standing)
        { return IsNearer(standing, &chosen) && IsUnknown(standing, budget); });
    return isLeast ? "With all the time there is take "
                   : "Of those whose time this run knows take ";
}

/// What is better, were there more time.
std::string MoreTimeBuys(const Comparison& comparison, const Standing& chosen, double budget)
{
    for (const std::size_t index : comparison.front)
    {
        const Standing& other = comparison.standings[index];
        if (IsNearer(other, &chosen) && other.ShortestTime() > budget)
        {
            return " More time buys less error: " + other.technique->name + " has " +
                   Figures(other) + ".";
        }
    }
    return "";
}

/// What to take, and in a sentence the others that are as good.
struct Chosen
{
    const Standing* standing = nullptr;
    std::string others;
};

/// Of those that are as good as the least error the one that flickers least.
Chosen Choose(const Comparison& comparison, double budget)
{
    const Standing* const least = LeastError(comparison, budget);
    if (least == nullptr)
    {
        return {};
    }
    const Standing* chosen = least;
    for (const Standing& standing : comparison.standings)
    {
        if (IsAsGood(standing, *least, budget) && standing.flicker.median < chosen->flicker.median)
        {
            chosen = &standing;
        }
    }
    const std::string others = NamesOf(
        comparison,
        [&](const Standing& standing)
        { return &standing != chosen && IsAsGood(standing, *least, budget); },
        [](const Standing& standing)
        {
            const double flicker = standing.flicker.median;
            return std::isnan(flicker) ? std::string() : "flicker " + Readable(flicker);
        });
    return {chosen, others.empty() ? "" : " As good, as far as the times tell: " + others + "."};
}

/// Why there is nothing to recommend.
std::string NothingFits(const Comparison& comparison, double budget)
{
    const auto hasBoth = [](const Standing& standing)
    {
        return standing.HasTime() && std::isfinite(standing.at.error);
    };
    if (std::ranges::none_of(comparison.standings, hasBoth))
    {
        return "No technique has both an error and a time to choose by.";
    }
    if (comparison.front.empty())
    {
        return "There is no recommendation: this run does not know the time of any technique. "
               "Measure again on a quieter machine.";
    }
    const Standing& quickest = comparison.standings[comparison.front.front()];
    return "Nothing fits " + Readable(budget) + " ms for certain: the quickest outline is " +
           quickest.technique->name + " with " + Figures(quickest) + " (" + Place(comparison) +
           ").";
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
    comparison.flickerWidth = FlickerWidth(study, comparison.width);
    comparison.load = LoadOf(study, comparison);
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
        AddFlicker(standing, study, comparison);
        AddStability(standing, study);
        points.push_back(standing.IsTimeKnown() ? standing.at : TimeAndError{k_NaN, k_NaN});
        comparison.standings.push_back(standing);
    }
    comparison.front = ParetoFront(points);
    return comparison;
}

Recommendation Recommend(const Comparison& comparison, double budgetMilliseconds)
{
    const Chosen choice = Choose(comparison, budgetMilliseconds);
    Recommendation result{choice.standing, ""};
    if (result.standing == nullptr)
    {
        const std::string nothing = NothingFits(comparison, budgetMilliseconds);
        result.sentence =
            nothing +
            (comparison.front.empty() ? "" : CannotTell(comparison, nullptr, budgetMilliseconds));
        return result;
    }
    const Standing& chosen = *result.standing;
    result.sentence = Opening(comparison, chosen, budgetMilliseconds) + chosen.technique->name +
                      ": " + Figures(chosen) + " (" + Place(comparison) + ").";
    if (chosen.failures > 0)
    {
        result.sentence += " It failed " + std::to_string(chosen.failures) + " of " +
                           Count(chosen.stabilityCells, "stability check") + ".";
    }
    result.sentence += choice.others + CannotTell(comparison, &chosen, budgetMilliseconds) +
                       MoreTimeBuys(comparison, chosen, budgetMilliseconds);
    return result;
}

std::vector<std::string> WarningsOf(const Comparison& comparison)
{
    std::vector<std::string> warnings;
    const LoadOfStudy& load = comparison.load;
    if (HasLoadChanged(load.quietPart))
    {
        warnings.push_back("The load changed during this run: the frame without an outline took " +
                           Readable(load.quietMilliseconds) + " ms in " +
                           Readable(std::round(load.quietPart * 100.0)) + " % of it and up to " +
                           Readable(load.busyMilliseconds) +
                           " ms in the rest, which counts for nothing.");
    }
    else if (load.changed > 0)
    {
        warnings.push_back("The load changed during " + std::to_string(load.changed) + " of " +
                           Count(load.measurements, "measurement") +
                           " of time; not where techniques are compared.");
    }
    constexpr double k_ManyProcessors = 0.2;
    if (load.otherPrograms > k_ManyProcessors)
    {
        warnings.push_back("Other programs kept busy " + Readable(load.otherPrograms) +
                           " of the machine's processors during this run: all of its times may be "
                           "too long, which their ± does not hold.");
    }
    const std::string unknown = NamesOf(
        comparison,
        [](const Standing& standing) { return standing.HasTime() && !standing.IsTimeKnown(); },
        TimeOf);
    if (!unknown.empty())
    {
        warnings.push_back("This run does not know these times, of which 0 is within the bound or "
                           "for which too little of it was quiet: " +
                           unknown +
                           ". Measure again on a quieter machine before choosing by them.");
    }
    return warnings;
}

bool Standing::HasTime() const
{
    return std::isfinite(at.milliseconds);
}

bool Standing::IsTimeKnown() const
{
    return ShortestTime() > 0.0 && std::isfinite(LongestTime());
}

} // namespace limn::study
