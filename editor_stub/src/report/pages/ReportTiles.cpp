#include "report/figures/Numbers.h"
#include "report/measure/StudyScene.h"
#include "report/pages/ReportText.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

namespace
{

std::string TimeText(const Standing& standing)
{
    if (!standing.HasTime())
    {
        return "time not measured";
    }
    if (!std::isfinite(standing.LongestTime()) || standing.LongestTime() <= 0.0)
    {
        return "time not known";
    }
    return standing.IsTimeKnown() ? Readable(standing.at.milliseconds) + " ± " +
                                        Readable(standing.timeUncertainty) + " ms"
                                  : "at most " + Readable(standing.LongestTime()) + " ms";
}

/// The subject and the kind of the pictures, and their width.
struct Shown
{
    std::string subject;
    std::string kind;
    double width = 0.0;

    bool Has(const CellResult& cell) const
    {
        return cell.id.kind == CellKind::Geometry && cell.id.variant.empty() &&
               cell.id.subject == subject && cell.id.width == width && cell.pictures.contains(kind);
    }
};

/// The scene, or what stands first of a study without one.
Shown ShownOf(const Study& study, double width)
{
    Shown shown{k_SceneSubject, "closeUp", 0.0};
    const auto isShown = [&shown](const CellResult& cell)
    {
        return cell.id.kind == CellKind::Geometry && cell.id.subject == shown.subject &&
               cell.pictures.contains(shown.kind);
    };
    if (std::ranges::none_of(study.cells, isShown))
    {
        shown.kind = "picture";
        const auto first = std::ranges::find_if(
            study.cells, [](const CellResult& cell)
            { return cell.id.kind == CellKind::Geometry && cell.pictures.contains("picture"); });
        shown.subject = first == study.cells.end() ? "" : first->id.subject;
    }
    shown.width = NearestWidth(study, width, isShown);
    return shown;
}

} // namespace

std::vector<Tile> TilesOf(const Study& study, const Comparison& comparison,
                          const Standing* recommended, std::string& caption)
{
    const Shown shown = ShownOf(study, comparison.width);
    caption = "The same part of " +
              (shown.subject == k_SceneSubject ? "the scene" : "'" + shown.subject + "'") +
              " with each technique, enlarged, its outline " + Readable(shown.width) +
              " px wide. Below it stand the mean error of the outline's coverage, 0 to 1, and the "
              "GPU time added to a frame. An article's own formula is marked 'article'.";
    std::vector<const Standing*> order;
    for (const Standing& standing : comparison.standings)
    {
        order.push_back(&standing);
    }
    std::ranges::stable_sort(order, {},
                             [](const Standing* standing)
                             {
                                 const double error = standing->at.error;
                                 return std::pair(std::isnan(error), std::isnan(error) ? 0 : error);
                             });
    std::vector<Tile> tiles;
    for (const Standing* standing : order)
    {
        const Technique& technique = *standing->technique;
        const auto found = std::ranges::find_if(
            study.cells, [&](const CellResult& cell)
            { return cell.id.technique == technique.name && shown.Has(cell); });
        if (found != study.cells.end())
        {
            tiles.push_back({technique.name,
                             std::isnan(standing->at.error)
                                 ? "error not compared"
                                 : "error " + Readable(standing->at.error),
                             TimeText(*standing), found->pictures.at(shown.kind),
                             technique.isArticle, standing == recommended});
        }
    }
    return tiles;
}

} // namespace limn::study
