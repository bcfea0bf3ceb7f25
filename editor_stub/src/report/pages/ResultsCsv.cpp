#include "report/figures/Numbers.h"
#include "report/pages/Results.h"

#include <set>

namespace limn::study
{

namespace
{

std::string CsvField(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
    {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text)
    {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + "\"";
}

using Keys = std::set<std::string>;

/// Of the metrics that have columns for quartiles: those that are measured, and those that have
/// some.
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
    std::string notes;
    for (const std::string& note : cell.notes)
    {
        notes += (notes.empty() ? "" : " ") + note;
    }
    return line + "," + CsvField(notes) + "\n";
}

} // namespace

std::string ResultsCsv(const Study& study)
{
    const Keys withQuartiles = WithQuartiles(study);
    std::string text = Header(withQuartiles);
    for (const CellResult& cell : study.cells)
    {
        text += Row(cell, withQuartiles);
    }
    return text;
}

} // namespace limn::study
