#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "console/Json.h"
#include "console/Texts.h"
#include "report/StudyPlan.h"
#include "report/extremes/Stability.h"
#include "report/figures/TimeLeft.h"
#include "report/measure/StudyBench.h"
#include "report/measure/StudyFiles.h"
#include "report/measure/StudyScene.h"
#include "report/pages/WriteReport.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <limn/base/HashContent.h>
#include <limn/base/ReadFile.h>
#include <limn/features/Version.h>
#include <sstream>
#include <thread>

namespace limn
{

namespace
{

using namespace study;

std::string Now()
{
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&time, &parts);
    std::ostringstream text;
    text << std::put_time(&parts, "%Y-%m-%dT%H:%M:%SZ");
    return text.str();
}

/// "Intel(R) Xeon(R) ..., 2 threads".
std::string MachineName()
{
    std::ifstream file("/proc/cpuinfo");
    std::string name = "unknown processor";
    for (std::string line; std::getline(file, line);)
    {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
        {
            name = line.substr(colon + 2);
            break;
        }
    }
    return name + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads";
}

double LoadAverage()
{
    double load = 0.0;
    return getloadavg(&load, 1) == 1 ? load : 0.0;
}

/// Returns the hash of all files from which the scene was read.
std::string HashOf(const AssetContext& assets)
{
    std::string contents;
    for (const std::filesystem::path& file : assets.reachedFiles())
    {
        contents += std::to_string(HashContent(TryReadFile(file, k_MaxDataBytes).bytes)) + " ";
    }
    std::ostringstream text;
    text << std::hex << HashContent(contents);
    return text.str();
}

std::vector<std::string> TechniqueNames(const std::vector<std::string>& wanted,
                                        std::span<const Technique> techniques)
{
    std::vector<std::string> names;
    for (const std::string& name : wanted)
    {
        const Technique* technique = FindTechnique(techniques, name);
        if (technique == nullptr)
        {
            throw AssetError("--technique", {},
                             "unknown technique " +
                                 UnknownName(name, NamesOf(techniques, &Technique::name)));
        }
        names.push_back(technique->name);
    }
    return names;
}

/// Everything about the study but its cells.
Study Describe(const std::string& scene, const StudyOptions& options, const AssetContext& assets,
               const VulkanDevice& device)
{
    Study study;
    study.scene = scene;
    study.sceneHash = HashOf(assets);
    study.device = device.deviceName();
    study.machine = MachineName();
    study.limnVersion = LIMN_VERSION_TEXT;
    study.options = options.Text();
    study.started = Now();
    study.techniques = assets.features().techniques();
    study.planned = PlanStudy(options, study.techniques);
    return study;
}

/// Measures what is missing of one shard.
class StudyRun
{
public:
    StudyFolder& folder;
    Study& study;
    StudyBench& bench;
    StabilityStudy& stability;
    const StudyOptions& options;

    void Run(int shard, int shards, Console& console)
    {
        const std::vector<std::vector<CellId>> units = UnitsOf(study.planned);
        std::vector<std::vector<CellId>> mine;
        double work = 0.0;
        for (std::size_t i = 0; i < units.size(); ++i)
        {
            if (static_cast<int>(i % static_cast<std::size_t>(shards)) + 1 == shard)
            {
                mine.push_back(units[i]);
                work += WorkOf(units[i]);
            }
        }
        TimeLeft left(mine.size(), work);
        for (const auto& unit : mine)
        {
            Measure(unit, left, console);
        }
        console.Progress("");
        folder.Update();
    }

private:
    /// About how long a unit takes, in pixels drawn.
    double WorkOf(const std::vector<CellId>& unit) const
    {
        const CellId& id = unit.front();
        const double pixels = static_cast<double>(id.pictureWidth) * id.pictureHeight;
        const double frames = id.kind == CellKind::Cost       ? options.RoundsOf(id) + 4.0
                              : id.kind == CellKind::Temporal ? 40.0
                                                              : 6.0;
        return (pixels + 50000.0) * frames * static_cast<double>(unit.size());
    }

    void Measure(const std::vector<CellId>& unit, TimeLeft& left, Console& console)
    {
        std::vector<CellId> missing;
        std::ranges::copy_if(unit, std::back_inserter(missing),
                             [this](const CellId& id) { return !folder.Has(id); });
        if (missing.empty())
        {
            left.Skip(WorkOf(unit));
            return;
        }
        console.Progress(left.Line(UnitText(missing)));
        if (missing.front().kind == CellKind::Cost)
        {
            study.copyBandwidth = bench.copyBandwidth();
            for (CellResult& cell : bench.MeasureCosts(missing, options.RoundsOf(missing.front())))
            {
                folder.Add(std::move(cell));
            }
            study.loadAverage = std::max(study.loadAverage, LoadAverage());
        }
        else
        {
            const CellId& id = missing.front();
            folder.Add(id.kind == CellKind::Stability ? stability.Measure(id) : bench.Measure(id));
        }
        left.Add(WorkOf(unit));
    }
};

Json ReportJson(const ReportFiles& report)
{
    return {
        {"files", JsonList(report.files, [](const auto& file) { return file.generic_string(); })},
        {"recommendation", report.recommendation},
        {"remarks", report.sceneRemarks},
        {"warnings", report.warnings},
        {"noPlots", TextOrNull(report.noPlots)}};
}

void PrintReport(const ReportFiles& report, Console& console)
{
    if (!report.noPlots.empty())
    {
        console.Note("no plots: " + report.noPlots);
    }
    console.Result(report.files.front().string()); // the page
    for (const std::filesystem::path& file : std::span(report.files).subspan(1))
    {
        console.Verbose("wrote " + file.string());
    }
    std::ranges::for_each(report.warnings, [&](const auto& each) { console.Warning(each); });
    std::ranges::for_each(report.sceneRemarks, [&](const auto& each) { console.Line(each); });
    console.Line(report.recommendation);
}

ExitCode Merge(const ReportCommandOptions& options, Console& console)
{
    std::vector<Study> parts;
    for (const std::string& folder : options.paths)
    {
        parts.push_back(ReadStudy(folder));
    }
    const std::vector<MergedStudy> merged = MergeStudies(parts);
    bool isWhole = true;
    Json json = Json::array();
    for (std::size_t i = 0; i < merged.size(); ++i)
    {
        const MergedStudy& part = merged[i];
        const std::filesystem::path folder =
            merged.size() == 1 ? std::filesystem::path(options.output)
                               : std::filesystem::path(options.output) / std::to_string(i + 1);
        ReportOptions pages{options.budget, {}};
        for (const std::string& name : part.missing)
        {
            console.Warning(folder.string() + ": missing: " + name); // pages say it by themselves
        }
        for (const std::string& name : part.doubled)
        {
            pages.remarks.push_back("a cell is there twice, and the first one counts: " + name);
            console.Warning(folder.string() + ": " + pages.remarks.back());
        }
        isWhole = isWhole && part.missing.empty();
        Study study = part.study;
        WriteMerged(folder, study, options.paths);
        console.Note(folder.string() + ": " + study.scene + " on " + study.device + ", " +
                     std::to_string(study.cells.size()) + " of " +
                     std::to_string(study.planned.size()) + " cells");
        const ReportFiles report = WriteReport(study, folder, pages);
        if (!options.json)
        {
            PrintReport(report, console);
            continue;
        }
        json.push_back(ReportJson(report));
        json.back()["missing"] = part.missing;
        json.back()["doubled"] = part.doubled;
    }
    if (options.json)
    {
        console.Data(JsonText({{"reports", json}}));
    }
    return isWhole ? ExitCode::Done : ExitCode::BadInput;
}

ExitCode Compare(const ReportCommandOptions& options, Console& console)
{
    const Study first = ReadStudy(options.paths[0]);
    const Study second = ReadStudy(options.paths[1]);
    const std::vector<std::string> differences = CompareStudies(first, second);
    if (options.json)
    {
        console.Data(JsonText(
            {{"cells", {first.cells.size(), second.cells.size()}}, {"differences", differences}}));
    }
    else
    {
        std::ranges::for_each(differences, [&](const auto& each) { console.Result(each); });
        console.Note(std::to_string(first.cells.size()) + " and " +
                     std::to_string(second.cells.size()) + " cells, " +
                     std::to_string(differences.size()) + " differ, times apart");
    }
    return differences.empty() ? ExitCode::Done : ExitCode::BadInput;
}

} // namespace

ExitCode RunReport(RenderOptions render, const ReportCommandOptions& options, Console& console)
{
    if (options.isMerge)
    {
        return Merge(options, console);
    }
    const std::size_t expected = options.isCompare ? 2 : 1;
    if (options.paths.size() != expected)
    {
        console.Error(options.isCompare ? "report --compare: two folders of reports are expected"
                                        : "report: one scene is expected");
        return ExitCode::WrongUsage;
    }
    if (options.isCompare)
    {
        return Compare(options, console);
    }
    render.scene = options.paths.front();
    RequireKind(render.scene, {FileKind::Scene, FileKind::UnityScene}, "report");
    ShaderCompilerOptions compilerOptions = ChooseCompilerOptions(render, console);
    VulkanDevice device({render.device, options.hasStability, compilerOptions.cacheFolder});
    compilerOptions.missingFeatures = device.missingShaderFeatures();
    AssetContext assets(compilerOptions);
    SceneAsset scene = LoadForRendering(render, assets);
    console.Print(scene.notes);
    MarkOutlined(scene); // so that a scene without an outline is refused at once
    RequireOutlineInPicture(scene);
    console.Verbose(device.ChoiceSentence());

    StudyOptions studyOptions;
    studyOptions.isQuick = options.isQuick;
    studyOptions.isFull = options.isFull;
    studyOptions.hasStability = options.hasStability;
    studyOptions.techniques = TechniqueNames(options.techniques, assets.features().techniques());
    studyOptions.sceneSize = {scene.width, scene.height};
    studyOptions.isPartlyHidden = IsPartlyHidden(scene);
    Study study = Describe(render.scene, studyOptions, assets, device);
    StudyFolder folder(options.output, study);
    StudyBench bench(render.scene, options.output, assets, device);
    StabilityStudy stability(assets, device);
    StudyRun{folder, study, bench, stability, studyOptions}.Run(options.shard, options.shards,
                                                                console);
    if (options.shards > 1)
    {
        options.json ? console.Data(JsonText({{"folder", options.output},
                                              {"shard", {options.shard, options.shards}}}))
                     : console.Result(options.output);
        return ExitCode::Done;
    }
    const ReportFiles report = WriteReport(study, options.output, {options.budget, {}});
    options.json ? console.Data(JsonText(ReportJson(report))) : PrintReport(report, console);
    return ExitCode::Done;
}

} // namespace limn
