#include "report/pages/WriteReport.h"

#include "report/figures/Pareto.h"
#include "report/measure/StudyFiles.h"
#include "report/pages/ReportText.h"
#include <limn/base/RunProgram.h>

#include <limn/base/Diagnostic.h>
#include <limn/base/WriteFile.h>
#include <stdexcept>
#include <system_error>

namespace limn::study
{

namespace
{

constexpr const char* k_NeedsGnuplot =
    "the program 'gnuplot' draws plots, and cannot be started (Debian: apt install gnuplot-nox); "
    "what it would draw is in plots/*.gnuplot";

/// A file's name below the folder, and what is in it.
using Texts = std::vector<std::pair<std::string, std::string>>;

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
    Texts texts = {{"report.html", HtmlPage(report, folder, drawn)},
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

} // namespace limn::study
