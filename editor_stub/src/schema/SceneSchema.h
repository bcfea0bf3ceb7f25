#pragma once

#include "schema/ValueSchema.h"

#include <limn/features/FeatureRegistry.h>

namespace limn
{

/// What a scene file may hold: its keys, and every feature's settings.
Json SceneSchema(const FeatureRegistry& features);

} // namespace limn
