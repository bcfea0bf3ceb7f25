#pragma once

#include "schema/ValueSchema.h"

#include <limn/volume/VolumeComponentRegistry.h>

namespace limn
{

/// What a profile of limn's own form may hold: every registered component and parameter.
Json ProfileSchema(const VolumeComponentRegistry& registry);

} // namespace limn
