#pragma once

#include <limn/core/RenderReport.h>
#include <string>
#include <vector>

namespace limn
{

/// Returns the filters that decide what is drawn, those of the renderer's own passes among them.
/// Where a feature has told its own, its DrawRenderers calls are about objects that it has already
/// chosen, and are left out.
/// @lifetime  the result points into `report`
std::vector<const DrawRenderersReport*> DecidingFilters(const RenderReport& report);

/// Returns what a feature said while it added no pass, without its name in front; "" if it said
/// nothing.
std::string WhyIdle(const RenderReport& report, const FeatureReport& feature);

/// Returns why nothing that this filter takes is drawn: its feature adds no pass. "" if it adds
/// one, and for the renderer's own filters.
std::string ObstacleOf(const RenderReport& report, const DrawRenderersReport& filter);

} // namespace limn
