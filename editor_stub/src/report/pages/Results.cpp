#include "report/pages/WriteReport.h"

#include "console/Texts.h"
#include "report/figures/Numbers.h"
#include "report/figures/Pareto.h"
#include "report/measure/StudyFiles.h"

#include <set>

namespace limn::study
{

namespace
{

std::string CsvField(const std::string& text)
{
    const bool isPlain = text.find_first_of(",\"\r\n") == std::string::npos;
    return isPlain ? text : "\"" + Replaced(text, "\"", "\"\"") + "\"";
}

using Keys = std::set<std::string>;

/// Returns the measured metrics of those with columns for quartiles, and those that have quartiles.
Keys WithQuartiles(const Study& study)
{
    Keys keys;
    for (const Metric& metric : Metrics())
    {
        if (metric.isMeasured)
        {
            keys.insert(metric.key);
        }
    }
    for (const CellResult& cell : study.cells)
    {
        for (const auto& [key, ends] : cell.quartiles)
        {
            keys.insert(key);
        }
    }
    return keys;
}

std::string Header(const Keys& withQuartiles)
{
    std::string line = "kind,technique,subject,width,pictureWidth,pictureHeight,variant";
    for (const Metric& metric : Metrics())
    {
        const std::string key = metric.key;
        line += "," + key;
        line += withQuartiles.contains(key) ? "," + key + "Lower," + key + "Upper" : "";
    }
    return line + ",notes\n";
}

std::string Row(const CellResult& cell, const Keys& withQuartiles)
{
    const CellId& id = cell.id;
    std::string line = std::string(ToString(id.kind)) + "," + CsvField(id.technique) + "," +
                       CsvField(id.subject) + "," + Exact(id.width) + "," +
                       std::to_string(id.pictureWidth) + "," + std::to_string(id.pictureHeight) +
                       "," + CsvField(id.variant);
    for (const Metric& metric : Metrics())
    {
        line += "," + (cell.Has(metric.key) ? Exact(cell.Value(metric.key)) : "");
        if (withQuartiles.contains(metric.key))
        {
            const auto found = cell.quartiles.find(metric.key);
            line += found == cell.quartiles.end()
                        ? ",,"
                        : "," + Exact(found->second.first) + "," + Exact(found->second.second);
        }
    }
    return line + "," + CsvField(Joined(cell.notes, " ")) + "\n";
}

Json ComparisonJson(const Comparison& comparison)
{
    const auto pointJson = [&](std::size_t index) -> Json
    {
        const Standing& standing = comparison.standings[index];
        return {{"technique", standing.technique->name},
                {"milliseconds", standing.at.milliseconds},
                {"uncertainty", standing.timeUncertainty},
                {"error", standing.at.error}};
    };
    return {{"width", comparison.width},
            {"size", {comparison.pictureWidth, comparison.pictureHeight}},
            {"errorOf", comparison.subject.empty() ? "median over shapes" : comparison.subject},
            {"loadChanged", HasLoadChanged(comparison.load.quietPart)},
            {"warnings", WarningsOf(comparison)},
            {"paretoFront", JsonList(comparison.front, pointJson)}};
}

} // namespace

std::string ResultsCsv(const Study& study)
{
    const Keys withQuartiles = WithQuartiles(study);
    return Header(withQuartiles) + Joined(study.cells, "",
                                          [&](const CellResult& cell)
                                          { return Row(cell, withQuartiles); });
}

std::string ResultsJson(const Study& study, const Comparison& comparison)
{
    Json json = ToJson(study);
    json["comparison"] = ComparisonJson(comparison);
    json["metrics"] = JsonList(Metrics(),
                               [](const Metric& metric) -> Json
                               {
                                   return {{"key", metric.key},
                                           {"title", metric.title},
                                           {"unit", metric.unit},
                                           {"isMeasured", metric.isMeasured}};
                               });
    json["cells"] = JsonList(study.cells, [](const CellResult& cell) { return ToJson(cell); });
    return JsonText(json);
}

} // namespace limn::study
