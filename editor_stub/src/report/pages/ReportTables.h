#pragma once

#include "report/pages/ReportText.h"

#include <functional>

namespace limn::study
{

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
