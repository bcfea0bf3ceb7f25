#pragma once

#include "schema/ValueSchema.h"

#include <limn/features/FeatureRegistry.h>

namespace limn
{

/// One item of a scene's `renderer.features`: any registered feature, by its `type`.
Json FeatureSchema(const FeatureRegistry& features);

} // namespace limn
