#pragma once

#include "schema/ValueSchema.h"

namespace limn
{

/// One item of a scene's `renderer.features`: any feature that comes with limn, by its `type`.
Json FeatureSchema();

} // namespace limn
