#include <limn/core/FeatureFilters.h>

#include <algorithm>

namespace limn
{

std::vector<const DrawRenderersReport*> DecidingFilters(const RenderReport& report)
{
    std::vector<const DrawRenderersReport*> filters;
    for (const DrawRenderersReport& draw : report.draws)
    {
        if (draw.feature == DrawRenderersReport::k_NoFeature ||
            std::ranges::find(report.filters, draw.feature, &DrawRenderersReport::feature) ==
                report.filters.end())
        {
            filters.push_back(&draw);
        }
    }
    for (const DrawRenderersReport& filter : report.filters)
    {
        filters.push_back(&filter);
    }
    return filters;
}

std::string WhyIdle(const RenderReport& report, const FeatureReport& feature)
{
    const std::string prefix = feature.name.name() + ": ";
    std::string why;
    for (std::size_t i = 0; i < feature.noteCount; ++i)
    {
        std::string note = report.notes.at(feature.firstNote + i);
        note.erase(0, note.starts_with(prefix) ? prefix.size() : 0);
        why += (why.empty() ? "" : "; ") + note;
    }
    return why;
}

std::string ObstacleOf(const RenderReport& report, const DrawRenderersReport& filter)
{
    if (filter.feature >= report.features.size() || report.features[filter.feature].passes > 0)
    {
        return "";
    }
    const std::string why = WhyIdle(report, report.features[filter.feature]);
    return why.empty() ? "it adds no pass" : why;
}

} // namespace limn
