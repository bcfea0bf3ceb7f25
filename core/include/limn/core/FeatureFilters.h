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

} // namespace limn
