#include "study_pages/WriteReport.h"

#include "study_pages/Pareto.h"
#include "study_pages/Results.h"

#include <limits>
#include <limn/shaderlab/WriteFile.h>

namespace limn::study
{

ReportFiles WriteReport(const Study& study, const std::filesystem::path& folder,
                        const ReportOptions& options)
{
    const Comparison comparison = Compare(study, options.width);
    ReportFiles result;
    result.recommendation =
        Recommend(comparison,
                  options.budgetMilliseconds.value_or(std::numeric_limits<double>::infinity()))
            .sentence;
    const std::pair<const char*, std::string> texts[] = {{"results.csv", ResultsCsv(study)}};
    for (const auto& [name, text] : texts)
    {
        WriteFile(folder / name, text);
        result.files.push_back(folder / name);
    }
    return result;
}

} // namespace limn::study
