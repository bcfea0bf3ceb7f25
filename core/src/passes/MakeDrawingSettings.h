#pragma once

#include <limn/core/DrawingSettings.h>
#include <span>

namespace limn
{

struct Camera;

/// Returns the settings that all of Unity's CreateDrawingSettings return.
/// @throws ContractError if `tags` is empty or longer than 16
DrawingSettings MakeDrawingSettings(std::span<const ShaderTagId> tags, const Camera& camera,
                                    SortingCriteria sortingCriteria);

} // namespace limn
