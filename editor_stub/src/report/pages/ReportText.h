#pragma once

#include "report/pages/WriteReport.h"
#include "report/plots/Plots.h"

#include <functional>

namespace limn::study
{

struct TableColumn
{
    std::string title;
    std::string unit = {}; ///< "" for none
    bool isNumber = false;
};

/// A table of plain text without markup.
struct Table
{
    std::string id; ///< unique in a report: letters and '-'
    std::string title;
    std::vector<TableColumn> columns;
    std::vector<std::vector<std::string>> rows = {};
    std::vector<std::size_t> marked = {}; ///< the rows that stand out
};

/// A picture of one technique with its figures; tiles stand side by side.
struct Tile
{
    std::string technique;
    std::string error;   ///< the mean error, or that there is none
    std::string time;    ///< the time added, or that it is not known
    std::string picture; ///< the file
    bool isArticle = false;
    bool isRecommended = false;
};

/// Pictures of one cell side by side.
struct Strip
{
    std::string title;
    /// Pairs of a description and a file.
    std::vector<std::pair<std::string, std::string>> pictures;
};

struct Section
{
    std::string id; ///< as Table::id
    std::string title;
    std::vector<std::string> plots = {}; ///< Plot::file
    std::vector<std::string> paragraphs = {};
    std::vector<Table> tables = {};
    std::vector<Strip> strips = {};
};

/// A report for people, independent of the format of the file.
struct ReportText
{
    std::string title;
    std::string subtitle;
    std::vector<Tile> tiles; ///< the same part of the same scene, the least error first
    std::string tilesCaption;
    std::string recommendation; ///< the answer in one sentence
    std::string more;           ///< further sentences of it; "" for none
    std::vector<std::string> remarks;
    std::vector<Section> sections;
    std::vector<Plot> plots; ///< those that are not empty
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

/// @param folder  the folder that has the pictures
/// @param drawn   empty if there is no gnuplot
std::string HtmlPage(const ReportText& report, const std::filesystem::path& folder,
                     const DrawnPlots& drawn);
std::string MarkdownPage(const ReportText& report, const DrawnPlots& drawn);

// The tables of a report. All figures are the study's, as Readable returns them; "–" if there is
// none.

/// Returns all techniques at the comparison's width. Those on the front are marked.
Table TechniquesTable(const Comparison& comparison);
/// Returns which technique has the least error from which budget on.
Table BudgetsTable(const Comparison& comparison);
/// Returns cells as rows: the parts of their ids, the metrics that any of them has, and their
/// notes.
Table CellsTable(const Study& study, const std::string& id, const std::string& title,
                 const std::function<bool(const CellResult&)>& isWanted);
/// Returns the mean errors, with a row for each technique and a column for each width.
Table WidthsTable(const Study& study, const std::string& subject);
/// Returns what each technique was tested with, and the results.
Table StabilityTable(const Study& study, const Comparison& comparison);
/// Returns the inputs for which a formula of an article fails, the results of it and of ours, and
/// the reason.
Table FormulasTable(const Study& study);
/// Returns the techniques that have no width.
Table NoWidthTable(const Study& study);
/// Returns a picture of each technique, of the width nearest to that of the comparison; {} if the
/// study has no pictures.
/// @param recommended  the technique that stands out; may be null
/// @param caption      becomes what the pictures show
std::vector<Tile> TilesOf(const Study& study, const Comparison& comparison,
                          const Standing* recommended, std::string& caption);
/// Returns where, when and by what the study was measured.
Table ProvenanceTable(const Study& study);

} // namespace limn::study
