#pragma once

#include "report/figures/Pareto.h"
#include "report/measure/Study.h"

#include <filesystem>
#include <optional>

namespace limn::study
{

struct ReportOptions
{
    /// GPU time that an outline may add to a frame: the report begins with what to take then.
    std::optional<double> budgetMilliseconds;
    double width = 0.0; ///< pixels, that techniques are compared at; 0 = where most can be
    std::vector<std::string> remarks; ///< sentences that readers must know: cells there twice, ...
};

struct ReportFiles
{
    std::vector<std::filesystem::path> files; ///< what was written, report.html first
    std::string recommendation;               ///< sentences for people
    std::vector<std::string> warnings;        ///< sentences: what the times are worth
    std::vector<std::string> sceneRemarks;    ///< sentences: what the scene was measured against
    std::string noPlots;                      ///< why there are none; "" if they were drawn
};

/// Writes what was measured for people and for programs: report.html, which needs no other file,
/// report.md, results.csv, results.json and plots/*.svg and *.png, drawn by the program `gnuplot`.
/// All is computed before the first file is written, and each file appears whole.
/// @param folder  the study's, where CellResult::pictures are; it must exist
/// @throws AssetError if a file cannot be written, or gnuplot fails
ReportFiles WriteReport(const Study& study, const std::filesystem::path& folder,
                        const ReportOptions& options = {});

/// One row a cell: what makes its id, all of Metrics() and their quartiles where there are any, the
/// notes. RFC 4180 with \n at line ends; figures read back as they were, "nan", "inf" and "-inf"
/// among them; empty where there is none.
std::string ResultsCsv(const Study& study);

/// All that a study holds, the metrics and the comparison with its front. Figures read back as they
/// were; those that JSON has no number for are the strings "nan", "inf" and "-inf".
std::string ResultsJson(const Study& study, const Comparison& comparison);

} // namespace limn::study
