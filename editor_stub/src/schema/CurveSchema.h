#pragma once

#include "schema/ValueSchema.h"

namespace limn
{

/// A list of keys, the same with wrap modes around it, or Unity's form.
Json AnimationCurveSchema();

/// Keys with the value where there are none, a loop and its range; or Unity's form.
Json TextureCurveSchema();

} // namespace limn
