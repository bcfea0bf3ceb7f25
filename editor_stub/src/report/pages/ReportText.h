#pragma once

#include "report/pages/WriteReport.h"
#include "report/plots/Plots.h"

#include <functional>

namespace limn::study
{

struct TableColumn
{
    std::string title;
    std::string unit; ///< "" for none
    bool isNumber = false;
};

/// Text as it is, no markup in it.
struct Table
{
    std::string id; ///< unique in a report: letters and '-'
    std::string title;
    std::vector<TableColumn> columns;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::size_t> marked; ///< rows that stand out
};

/// Pictures of one cell side by side.
struct Strip
{
    std::string title;
    std::vector<std::pair<std::string, std::string>> pictures; ///< what it is, file
};

struct Section
{
    std::string id; ///< as a table's
    std::string title;
    std::vector<std::string> paragraphs;
    std::vector<std::string> plots; ///< Plot::file
    std::vector<Table> tables;
    std::vector<Strip> strips;
};

/// A report as people read it, whatever it is written in.
struct ReportText
{
    std::string title;
    std::string subtitle;
    std::string recommendation;
    std::vector<std::string> remarks;
    std::vector<Section> sections;
    std::vector<Plot> plots; ///< that are not empty
};

/// Returns the notes of the scene's compared outlines as sentences, each with the techniques that
/// it is about.
std::vector<std::string> SceneRemarks(const Study& study);

ReportText ReportOf(const Study& study, const Comparison& comparison, const ReportOptions& options);

/// A plot as gnuplot drew it.
struct DrawnPlot
{
    std::string svg;
    std::string narrowSvg; ///< for a phone
    std::string png;
};
using DrawnPlots = std::map<std::string, DrawnPlot>; ///< by Plot::file

/// @param folder  where the pictures are
/// @param drawn   empty if there is no gnuplot
std::string HtmlPage(const ReportText& report, const std::filesystem::path& folder,
                     const DrawnPlots& drawn);
std::string MarkdownPage(const ReportText& report, const DrawnPlots& drawn);

// The tables of a report. All figures are the study's, as Readable; "–" where there is none.

/// All techniques at the comparison's width, the front's marked.
Table TechniquesTable(const Comparison& comparison);
/// From which budget on which technique has the least error.
Table BudgetsTable(const Comparison& comparison);
/// Cells as rows: what makes their ids, those of the metrics that any of them has, their notes.
Table CellsTable(const Study& study, const std::string& id, const std::string& title,
                 const std::function<bool(const CellResult&)>& isWanted);
/// Mean error, a technique a row, a width a column.
Table WidthsTable(const Study& study, const std::string& subject);
/// What each technique was put through, and what came out.
Table StabilityTable(const Study& study, const Comparison& comparison);
/// Inputs for which a formula of an article fails, what comes out of it and of ours, and why.
Table FormulasTable(const Study& study);
/// Techniques that no width can be asked of.
Table NoWidthTable(const Study& study);
/// Where, when and by what it was measured.
Table ProvenanceTable(const Study& study);

} // namespace limn::study
