#include "reports/Json.h"
#include "study_pages/Numbers.h"
#include "study_pages/Results.h"

#include <cmath>

namespace limn::study
{

namespace
{

Json FigureJson(double value)
{
    return std::isfinite(value) ? Json(value) : Json(Exact(value));
}

Json IdJson(const CellId& id)
{
    return {{"kind", id.Name().substr(0, id.Name().find('/'))},
            {"technique", id.technique},
            {"subject", id.subject},
            {"width", FigureJson(id.width)},
            {"pictureWidth", id.pictureWidth},
            {"pictureHeight", id.pictureHeight},
            {"variant", id.variant}};
}

Json CellJson(const CellResult& cell)
{
    Json values = Json::object();
    for (const auto& [key, value] : cell.values)
    {
        values[key] = FigureJson(value);
    }
    Json quartiles = Json::object();
    for (const auto& [key, ends] : cell.quartiles)
    {
        quartiles[key] = {FigureJson(ends.first), FigureJson(ends.second)};
    }
    Json result = IdJson(cell.id);
    result["name"] = cell.id.Name();
    result["values"] = values;
    result["quartiles"] = quartiles;
    result["notes"] = cell.notes;
    result["pictures"] = cell.pictures;
    return result;
}

Json ComparisonJson(const Comparison& comparison)
{
    Json front = Json::array();
    for (const std::size_t index : comparison.front)
    {
        const Standing& standing = comparison.standings[index];
        front.push_back({{"technique", standing.technique->name},
                         {"milliseconds", FigureJson(standing.at.milliseconds)},
                         {"error", FigureJson(standing.at.error)}});
    }
    return {{"width", FigureJson(comparison.width)},
            {"pictureWidth", comparison.pictureWidth},
            {"pictureHeight", comparison.pictureHeight},
            {"errorOf", comparison.subject.empty() ? "median over shapes" : comparison.subject},
            {"paretoFront", front}};
}

} // namespace

std::string ResultsJson(const Study& study, const Comparison& comparison)
{
    Json metrics = Json::array();
    for (const Metric& metric : Metrics())
    {
        metrics.push_back({{"key", metric.key},
                           {"title", metric.title},
                           {"unit", metric.unit},
                           {"isMeasured", metric.isMeasured}});
    }
    Json techniques = Json::array();
    for (const TechniqueInfo& technique : study.techniques)
    {
        techniques.push_back({{"name", technique.name},
                              {"feature", technique.feature},
                              {"summary", technique.summary},
                              {"isArticle", technique.isArticle},
                              {"noWidth", technique.noWidth}});
    }
    Json cells = Json::array();
    for (const CellResult& cell : study.cells)
    {
        cells.push_back(CellJson(cell));
    }
    return JsonText({{"scene", study.scene},
                     {"sceneHash", study.sceneHash},
                     {"device", study.device},
                     {"machine", study.machine},
                     {"limnVersion", study.limnVersion},
                     {"options", study.options},
                     {"started", study.started},
                     {"loadAverage", FigureJson(study.loadAverage)},
                     {"copyBandwidth", FigureJson(study.copyBandwidth)},
                     {"plannedCells", study.planned.size()},
                     {"comparison", ComparisonJson(comparison)},
                     {"techniques", techniques},
                     {"metrics", metrics},
                     {"cells", cells}});
}

} // namespace limn::study
