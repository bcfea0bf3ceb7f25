#pragma once

#include <limn/core/RenderReport.h>
#include <string>
#include <vector>

namespace limn
{

/// Returns the filters that decide what is drawn, those of the renderer's own passes among them. If
/// a feature has reported filters of its own, its DrawRenderers calls are left out, because they
/// get only objects that the feature has already chosen.
/// @lifetime  the result points into `report`
std::vector<const DrawRenderersReport*> DecidingFilters(const RenderReport& report);

/// Returns what a feature reported while it added no pass, without its name in front; "" if it
/// reported nothing.
std::string WhyIdle(const RenderReport& report, const FeatureReport& feature);

/// Returns why nothing that this filter takes is drawn, which is that its feature adds no pass.
/// Returns "" if the feature adds one, and for the renderer's own filters.
std::string ObstacleOf(const RenderReport& report, const DrawRenderersReport& filter);

} // namespace limn
