#pragma once

#include "report/figures/Pareto.h"

namespace limn::study
{

/// One row a cell: what makes its id, all of Metrics() and their quartiles where there are any, the
/// notes. RFC 4180 with \n at line ends; figures read back as they were, "nan", "inf" and "-inf"
/// among them; empty where there is none.
std::string ResultsCsv(const Study& study);

/// All that a study holds, the metrics and the comparison with its front. Figures read back as they
/// were; those that JSON has no number for are the strings "nan", "inf" and "-inf".
std::string ResultsJson(const Study& study, const Comparison& comparison);

} // namespace limn::study
