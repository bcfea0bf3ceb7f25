#include "report/pages/WriteReport.h"

#include "console/Texts.h"
#include "report/figures/Numbers.h"
#include "report/measure/StudyFiles.h"
#include "report/pages/ReportText.h"

#include <limn/base/Diagnostic.h>
#include <limn/base/RunProgram.h>
#include <set>
#include <stdexcept>
#include <system_error>

namespace limn::study
{

namespace
{

constexpr const char* k_NeedsGnuplot =
    "the program 'gnuplot' draws plots, and cannot be started (Debian: apt install gnuplot-nox); "
    "what it would draw is in plots/*.gnuplot";

std::string RunGnuplot(const Plot& plot, PlotFormat format)
{
    return RunProgram({"gnuplot", "-d", "-"}, PlotScript(plot, format), k_NeedsGnuplot);
}

/// @param problem  becomes why nothing is drawn, if there is no gnuplot
DrawnPlots DrawPlots(const std::vector<Plot>& plots, const std::filesystem::path& folder,
                     std::string& problem)
{
    DrawnPlots drawn;
    try
    {
        for (const Plot& plot : plots)
        {
            drawn[plot.file] = {RunGnuplot(plot, PlotFormat::Svg),
                                RunGnuplot(plot, PlotFormat::NarrowSvg),
                                RunGnuplot(plot, PlotFormat::Png)};
        }
    }
    catch (const std::system_error& error)
    {
        problem = error.what();
        drawn.clear();
    }
    catch (const std::runtime_error& error)
    {
        throw AssetError((folder / "plots").string(), {}, error.what());
    }
    return drawn;
}

void RemoveOldPlots(const std::filesystem::path& folder)
{
    for (const char* name :
         {"error_time", "error_width", "time_resolution", "time_objects", "flicker_time"})
    {
        for (const char* ending : {".svg", ".png", ".gnuplot"})
        {
            std::error_code ignored;
            std::filesystem::remove(folder / (std::string(name) + ending), ignored);
        }
    }
}

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

ReportFiles WriteReport(const Study& study, const std::filesystem::path& folder,
                        const ReportOptions& options)
{
    const Comparison comparison = Compare(study);
    ReportText report = ReportOf(study, comparison, options);
    ReportFiles result;
    result.recommendation = report.recommendation + (report.more.empty() ? "" : " " + report.more);
    result.warnings = WarningsOf(comparison);
    result.sceneRemarks = SceneRemarks(study);
    const DrawnPlots drawn = DrawPlots(report.plots, folder, result.noPlots);
    if (!result.noPlots.empty())
    {
        report.remarks.push_back("There are no plots: " + result.noPlots + ".");
    }
    // The names of files below the folder, and what is in them.
    std::vector<std::pair<std::string, std::string>> texts = {
        {"report.html", HtmlPage(report, folder, drawn)},
        {"report.md", MarkdownPage(report, drawn)},
        {"results.csv", ResultsCsv(study)},
        {"results.json", ResultsJson(study, comparison)}};
    for (const Plot& plot : report.plots)
    {
        texts.emplace_back("plots/" + plot.file + ".gnuplot", PlotScript(plot, PlotFormat::Svg));
    }
    for (const auto& [name, plot] : drawn)
    {
        texts.emplace_back("plots/" + name + ".svg", plot.svg);
        texts.emplace_back("plots/" + name + ".png", plot.png);
    }
    for (const auto& [name, text] : texts)
    {
        result.files.push_back(FileOfStudy(folder, name));
    }
    const std::filesystem::path plots = FileOfStudy(folder, "plots");
    std::error_code error;
    std::filesystem::create_directory(plots, error);
    if (error)
    {
        throw AssetError(plots.string(), {}, error.message());
    }
    RemoveOldPlots(plots);
    for (const auto& [name, text] : texts)
    {
        WriteFile(folder / name, text);
    }
    return result;
}

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
