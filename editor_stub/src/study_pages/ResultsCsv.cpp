#include "study_pages/Numbers.h"
#include "study_pages/Results.h"

#include <algorithm>

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

bool HasQuartiles(const Study& study, const Metric& metric)
{
    return metric.isMeasured ||
           std::ranges::any_of(study.cells, [&metric](const CellResult& cell)
                               { return cell.quartiles.contains(metric.key); });
}

std::string Header(const Study& study)
{
    std::string line = "kind,technique,subject,width,pictureWidth,pictureHeight,variant";
    for (const Metric& metric : Metrics())
    {
        const std::string key = metric.key;
        line += "," + key;
        line += HasQuartiles(study, metric) ? "," + key + "Lower," + key + "Upper" : "";
    }
    return line + ",notes\n";
}

std::string Row(const Study& study, const CellResult& cell)
{
    const CellId& id = cell.id;
    std::string line = id.Name().substr(0, id.Name().find('/')) + "," + CsvField(id.technique) +
                       "," + CsvField(id.subject) + "," + Exact(id.width) + "," +
                       std::to_string(id.pictureWidth) + "," + std::to_string(id.pictureHeight) +
                       "," + CsvField(id.variant);
    for (const Metric& metric : Metrics())
    {
        line += "," + (cell.Has(metric.key) ? Exact(cell.Value(metric.key)) : "");
        if (HasQuartiles(study, metric))
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
    std::string text = Header(study);
    for (const CellResult& cell : study.cells)
    {
        text += Row(study, cell);
    }
    return text;
}

} // namespace limn::study
