#include "report/pages/WriteReport.h"
#include "Mentions.h"
#include "TemporaryFolder.h"
#include "report/pages/ReportText.h"
#include "report/pages/SampleStudy.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <limn/base/Diagnostic.h>
#include <limn/core/Image.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace limn::test
{

namespace
{

using study::Table;
using study::WriteReport;
using testing::HasSubstr;
using testing::Not;

constexpr const char* k_Plots[] = {"error_time", "error_width", "time_resolution", "time_objects",
                                   "flicker_time"};

std::string BytesOf(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The environment without any program, while it lives.
class NoPrograms
{
public:
    NoPrograms() { setenv("PATH", "/nonexistent", 1); }
    ~NoPrograms() { setenv("PATH", m_Path.c_str(), 1); }

private:
    std::string m_Path = std::getenv("PATH");
};

/// Written once, for all who read it.
class WrittenReport : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        s_Folder = std::make_unique<TemporaryFolder>();
        study::ReportOptions options;
        options.remarks = {"<b>remark</b>"};
        s_Files = WriteReport(FullSample(), s_Folder->path(), options);
    }
    static void TearDownTestSuite() { s_Folder.reset(); }

    static const TemporaryFolder& folder() { return *s_Folder; }
    static const study::ReportFiles& files() { return s_Files; }

private:
    inline static std::unique_ptr<TemporaryFolder> s_Folder;
    inline static study::ReportFiles s_Files;
};

TEST_F(WrittenReport, IsAPageATextTablesAndPlots)
{
    EXPECT_EQ("", files().noPlots);
    std::set<std::string> expected = {"report.html", "report.md", "results.csv", "results.json"};
    for (const std::string plot : k_Plots)
    {
        expected.insert(
            {"plots/" + plot + ".svg", "plots/" + plot + ".png", "plots/" + plot + ".gnuplot"});
    }
    std::set<std::string> written;
    for (const auto& file : files().files)
    {
        written.insert(std::filesystem::relative(file, folder().path()).string());
    }
    EXPECT_EQ(expected, written);
    std::set<std::string> there;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder().path()))
    {
        if (entry.is_regular_file())
        {
            there.insert(std::filesystem::relative(entry.path(), folder().path()).string());
            EXPECT_GT(entry.file_size(), 100u) << entry.path();
        }
    }
    EXPECT_EQ(expected, there) << "and nothing is left beside them";
    EXPECT_EQ("report.html", files().files.front().filename());
    EXPECT_EQ(1720, ReadPng(folder() / "plots/error_time.png").width);
}

TEST(Report, WithoutGnuplotSaysSoAndHasAllElse)
{
    const TemporaryFolder folder;
    folder.Write("plots/error_time.svg", "an earlier study's");
    folder.Write("plots/time_objects.png", "an earlier study's");
    const NoPrograms none;
    const study::ReportFiles files = WriteReport(FullSample(), folder.path());
    EXPECT_THAT(files.noPlots, Mentions("'gnuplot'", "cannot be started", "gnuplot-nox"));
    EXPECT_THAT(BytesOf(folder / "report.html"), HasSubstr("There are no plots: the program"));
    EXPECT_THAT(BytesOf(folder / "report.md"), Not(HasSubstr("](plots/")));
    for (const std::string plot : k_Plots)
    {
        EXPECT_TRUE(std::filesystem::exists(folder / ("plots/" + plot + ".gnuplot")));
        EXPECT_FALSE(std::filesystem::exists(folder / ("plots/" + plot + ".svg")))
            << "what an earlier study drew";
        EXPECT_FALSE(std::filesystem::exists(folder / ("plots/" + plot + ".png")));
    }
}

TEST(Report, ThatCannotBeWrittenIsAnError)
{
    const TemporaryFolder folder;
    EXPECT_THROW(WriteReport(EmptySample(), folder / "missing"), AssetError);
    EXPECT_EQ(0, folder.fileCount());
    folder.Write("plots", "a file where a folder is to be");
    EXPECT_THROW(WriteReport(EmptySample(), folder.path()), AssetError);
    EXPECT_EQ(1, folder.fileCount());
}

TEST(Report, OfNothingIsOneToo)
{
    const TemporaryFolder folder;
    const study::ReportFiles files = WriteReport(EmptySample(), folder.path());
    EXPECT_THAT(files.recommendation, Mentions("No technique", "error", "time"));
    EXPECT_THAT(BytesOf(folder / "report.html"), HasSubstr(files.recommendation));
}

TEST(ReportPage, NeedsNoOtherFileAndNoScript)
{
    const TemporaryFolder folder;
    study::Study sample = FullSample();
    const Image image{2, 2, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(16)};
    WritePng(folder / "a.png", image);
    for (study::CellResult& cell : sample.cells)
    {
        if (cell.id.kind == study::CellKind::Geometry && cell.id.technique == "Strokes")
        {
            cell.pictures = {{"picture", "a.png"}, {"difference", "missing.png"}};
        }
    }
    const NoPrograms none;
    WriteReport(sample, folder.path());
    const std::string page = BytesOf(folder / "report.html");
    EXPECT_THAT(page, HasSubstr("<meta name=\"viewport\" content=\"width=device-width"));
    EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
    EXPECT_THAT(page, HasSubstr("src=\"data:image/png;base64,iVBORw0KGgo"));
    EXPECT_THAT(page, HasSubstr("missing.png: there is no such file"));
    for (const char* outside : {"<script", "<link", "src=\"http", "url(", "@import", "src=\"a.png"})
    {
        EXPECT_THAT(page, Not(HasSubstr(outside)));
    }
}

TEST_F(WrittenReport, ShowsNamesAsTheyAreOnThePage)
{
    const std::string page = BytesOf(folder() / "report.html");
    EXPECT_THAT(page, HasSubstr("&lt;i&gt;A&lt;/i&gt; &amp; &quot;|&quot; `x` = 1, 2"));
    EXPECT_THAT(page, HasSubstr("&lt;b&gt;remark&lt;/b&gt;"));
    for (const char* raw : {"<i>", "<b>"})
    {
        EXPECT_THAT(page, Not(HasSubstr(raw)));
    }
}

/// Cells of a row of a Markdown table: what is between bars that are not escaped.
std::size_t MarkdownCells(const std::string& line)
{
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
        i += line[i] == '\\' ? 1 : 0;
        bars += i < line.size() && line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    }
    return bars - 1;
}

TEST_F(WrittenReport, KeepsTablesAndNamesWholeInMarkdown)
{
    std::istringstream lines(BytesOf(folder() / "report.md"));
    std::size_t columns = 0;
    std::size_t rows = 0;
    for (std::string line; std::getline(lines, line);)
    {
        if (!line.starts_with('|'))
        {
            columns = 0;
            continue;
        }
        columns = columns == 0 ? MarkdownCells(line) : columns;
        EXPECT_EQ(columns, MarkdownCells(line)) << line;
        EXPECT_THAT(line, Not(HasSubstr("<")));
        ++rows;
    }
    EXPECT_GT(rows, 100u);
    EXPECT_THAT(BytesOf(folder() / "report.md"),
                HasSubstr("&lt;i>A&lt;/i> &amp; \"\\|\" \\`x\\` = 1, 2"));
}

TEST(ResultsJsonFile, HoldsTheWholeStudy)
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "Best");
    AddPoint(sample, "Best", 8.0, 2.0, 1.0 / 3.0);
    sample.cells[0].values["hausdorff"] = std::numeric_limits<double>::quiet_NaN();
    sample.cells[0].values["largest"] = std::numeric_limits<double>::infinity();
    const auto json = nlohmann::json::parse(study::ResultsJson(sample, Compare(sample)));
    EXPECT_EQ(sample.scene, json["scene"]);
    EXPECT_EQ(sample.device, json["device"]);
    ASSERT_EQ(sample.cells.size(), json["cells"].size());
    const auto& cell = json["cells"][0];
    EXPECT_EQ(sample.cells[0].Value("meanAbsoluteError"), cell["values"]["meanAbsoluteError"]);
    EXPECT_EQ("nan", cell["values"]["hausdorff"]);
    EXPECT_EQ("inf", cell["values"]["largest"]);
    EXPECT_EQ("Best", json["comparison"]["paretoFront"][0]["technique"]);
    EXPECT_EQ(study::Metrics().size(), json["metrics"].size());
}

/// The figure of a row that begins with a name, in the column of a title.
std::string At(const Table& table, const std::string& row, const std::string& column)
{
    const auto title = std::ranges::find_if(table.columns, [&column](const study::TableColumn& one)
                                            { return one.title == column; });
    const auto found = std::ranges::find_if(table.rows, [&row](const std::vector<std::string>& one)
                                            { return one[0] == row; });
    return title == table.columns.end() || found == table.rows.end()
               ? "nowhere"
               : (*found)[std::size_t(title - table.columns.begin())];
}

TEST(ReportTables, HaveTheStudysFigures)
{
    const study::Study sample = FullSample();
    const study::Comparison comparison = Compare(sample);
    const Table techniques = TechniquesTable(comparison);
    EXPECT_EQ("14.7", At(techniques, "Separable", "GPU time added"));
    EXPECT_EQ("0.012", At(techniques, "Separable", "mean error"));
    EXPECT_EQ("1.47", At(techniques, "Separable", "known to ±"));
    EXPECT_EQ("2.09", At(BudgetsTable(comparison), "Auto", "from a budget of")) << "1.9 ± 0.19 ms";
    EXPECT_EQ("0.005", At(techniques, "Separable", "flicker")) << "a third and half of 0.012";
    EXPECT_EQ("13.7 … 16.9", At(techniques, "Separable", "its quartiles"));
    EXPECT_EQ("infinite", At(techniques, "Fails", "mean error"));
    EXPECT_EQ("–", At(techniques, "Rim", "mean error"));
    EXPECT_EQ("3 of 20", At(techniques, "Screen space", "stability checks failed"));
    EXPECT_EQ("nowhere", At(techniques, "Separable", "error quartiles")) << "it is of one outline";
    const Table widths = WidthsTable(sample, "scene");
    EXPECT_EQ("0.006", At(widths, "Separable", "32"));
    const Table stability = StabilityTable(sample, comparison);
    EXPECT_EQ("63", At(stability, "Selection", "NaN or infinite texels"));
    EXPECT_THAT(At(stability, "Selection", "what it was put through"),
                HasSubstr("width 8, inf px; picture 3x7; fov 170; ratio 1e+0, 1e+1, 1e+2,"));
    EXPECT_EQ("it is as wide as the object is curved", At(NoWidthTable(sample), "Rim", "why"));
    const Table costs = CellsTable(sample, "costs", "",
                                   [](const study::CellResult& cell)
                                   { return cell.id.kind == study::CellKind::Cost; });
    EXPECT_EQ("7.91", At(costs, "Strokes", "targets added")) << "MiB of 8294400 bytes";
    EXPECT_EQ("nowhere", At(costs, "Strokes", "flicker")) << "no column without a figure";
    for (const Table& table : {techniques, widths, stability, costs, BudgetsTable(comparison)})
    {
        for (const auto& row : table.rows)
        {
            EXPECT_EQ(table.columns.size(), row.size()) << table.id;
        }
    }
}

TEST(ReportSections, SayWhyCellsHaveNoFigures)
{
    const study::Study sample = FullSample();
    const study::ReportText report = ReportOf(sample, Compare(sample), {});
    const auto error = std::ranges::find(report.sections, "error", &study::Section::id);
    ASSERT_NE(report.sections.end(), error);
    EXPECT_THAT(error->paragraphs,
                testing::Contains("Rim: not compared: it is as wide as the object is curved."));
    for (const Table& table : error->tables)
    {
        EXPECT_EQ("nowhere", At(table, "Rim", "technique")) << table.id;
    }
}

TEST(ReportOfStability, BeginsWithWhoPassed)
{
    study::Study sample = FullSample();
    std::erase_if(sample.cells, [](const study::CellResult& cell)
                  { return cell.id.kind != study::CellKind::Stability; });
    const study::ReportText report = ReportOf(sample, Compare(sample), {});
    EXPECT_THAT(report.recommendation,
                testing::StartsWith("Strokes, Separable, Jump flood, Auto, Inflated, Rim, "));
    EXPECT_THAT(report.recommendation,
                Mentions("passed all checks", "failed", "Screen space 3 of 20", "Selection 3 of"));
    EXPECT_EQ("extremes", report.sections.front().id);
    EXPECT_THAT(report.plots, testing::IsEmpty());
}

/// 2 ms and 4 ms, each known to a tenth.
study::Study TwoTechniques()
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "A");
    AddTechnique(sample, "B");
    AddPoint(sample, "A", 8.0, 2.0, 0.1);
    AddPoint(sample, "B", 8.0, 4.0, 0.01);
    return sample;
}

TEST(ReportRemarks, AreTheWarningsOfTheTerminalAndThoseOfTheCaller)
{
    study::Study sample = TwoTechniques();
    EXPECT_THAT(ReportOf(sample, Compare(sample), {}).remarks, testing::IsEmpty());
    sample.cells[1].values["gpuAddedUncertainty"] = 2.5; // of 2 ms
    sample.cells[1].values["quietPart"] = 0.5;
    study::ReportOptions options;
    options.remarks = {"a remark"};
    const TemporaryFolder folder;
    const study::ReportFiles files = WriteReport(sample, folder.path(), options);
    ASSERT_EQ(files.warnings.size(), 2u);
    EXPECT_THAT(files.warnings[0], testing::StartsWith("The load changed during this run: "));
    EXPECT_THAT(files.warnings[1], HasSubstr("A (2 ± 2.5 ms, so at most 4.5 ms)"));
    for (const char* page : {"report.html", "report.md"})
    {
        const std::string text = BytesOf(folder / page);
        for (const std::string& sentence :
             {files.warnings[0], files.warnings[1], options.remarks[0], files.recommendation})
        {
            EXPECT_THAT(text, HasSubstr(sentence)) << page;
        }
    }
    const auto json = nlohmann::json::parse(BytesOf(folder / "results.json"));
    EXPECT_EQ(json["comparison"]["loadChanged"], true);
    EXPECT_EQ(json["comparison"]["warnings"], files.warnings);
    EXPECT_THAT(BytesOf(folder / "results.csv"), HasSubstr(",quietPart,"));
}

TEST(ReportRemarks, NamePlannedCellsThatAreMissing)
{
    study::Study sample = TwoTechniques();
    const std::string name = sample.cells.back().id.Name();
    sample.cells.pop_back();
    const study::ReportText report = ReportOf(sample, Compare(sample), {});
    EXPECT_THAT(report.remarks, testing::ElementsAre("1 planned cell not measured: " + name + "."));
}

} // namespace

} // namespace limn::test
