#include "report/figures/Recommendation.h"
#include "report/measure/StudyJson.h"
#include "report/pages/Results.h"

namespace limn::study
{

namespace
{

Json ComparisonJson(const Comparison& comparison)
{
    Json front = Json::array();
    for (const std::size_t index : comparison.front)
    {
        const Standing& standing = comparison.standings[index];
        front.push_back({{"technique", standing.technique->name},
                         {"milliseconds", standing.at.milliseconds},
                         {"uncertainty", standing.timeUncertainty},
                         {"error", standing.at.error}});
    }
    return {{"width", comparison.width},
            {"size", {comparison.pictureWidth, comparison.pictureHeight}},
            {"errorOf", comparison.subject.empty() ? "median over shapes" : comparison.subject},
            {"loadChanged", HasLoadChanged(comparison.load.quietPart)},
            {"warnings", WarningsOf(comparison)},
            {"paretoFront", front}};
}

} // namespace

std::string ResultsJson(const Study& study, const Comparison& comparison)
{
    Json json = ToJson(study);
    json["comparison"] = ComparisonJson(comparison);
    json["metrics"] = Json::array();
    for (const Metric& metric : Metrics())
    {
        json["metrics"].push_back({{"key", metric.key},
                                   {"title", metric.title},
                                   {"unit", metric.unit},
                                   {"isMeasured", metric.isMeasured}});
    }
    json["cells"] = Json::array();
    for (const CellResult& cell : study.cells)
    {
        json["cells"].push_back(ToJson(cell));
    }
    return JsonText(json);
}

} // namespace limn::study
