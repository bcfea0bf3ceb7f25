#pragma once

#include "report/figures/Pareto.h"

#include <filesystem>
#include <optional>

namespace limn::study
{

struct ReportOptions
{
    /// The GPU time that an outline may add to a frame. The report begins with the technique to
    /// take for it.
    std::optional<double> budgetMilliseconds;
    /// Sentences that readers must know: cells that are there twice, ...
    std::vector<std::string> remarks;
};

struct ReportFiles
{
    std::vector<std::filesystem::path> files; ///< the files written, report.html first
    std::string recommendation;               ///< sentences for people
    std::vector<std::string> warnings;        ///< sentences about the reliability of the times
    /// Sentences about the exact outline that the scene was compared with.
    std::vector<std::string> sceneRemarks;
    std::string noPlots; ///< why there are no plots; "" if they were drawn
};

/// Writes the results for people and for programs: report.html, which needs no other file,
/// report.md, results.csv, results.json and plots/*.svg and *.png, drawn by the program `gnuplot`.
/// Everything is computed before the first file is written, and each file appears as a whole.
/// @param folder  the study's folder, which has CellResult::pictures; it must exist
/// @throws AssetError if a file cannot be written, or gnuplot fails
ReportFiles WriteReport(const Study& study, const std::filesystem::path& folder,
                        const ReportOptions& options = {});

/// Returns a row for each cell: the parts of its id, all of Metrics(), their quartiles if there are
/// any, and the notes. The format is RFC 4180 with line feeds at line ends. Figures read back as
/// they were, "nan", "inf" and "-inf" among them. A field without a figure is empty.
std::string ResultsCsv(const Study& study);

/// Returns all that a study holds, the metrics and the comparison with its front. Figures read back
/// as they were; those that JSON has no number for are the strings "nan", "inf" and "-inf".
std::string ResultsJson(const Study& study, const Comparison& comparison);

} // namespace limn::study
