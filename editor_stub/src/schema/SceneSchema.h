#pragma once

#include "schema/ValueSchema.h"

namespace limn
{

/// What a scene file may hold: its keys, and every feature's settings.
Json SceneSchema();

} // namespace limn
