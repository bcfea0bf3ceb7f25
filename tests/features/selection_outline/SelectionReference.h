#pragma once

#include "features/OutlineGpuReference.h"
#include "reference/twins/SelectionTwin.h"

namespace limn::test
{

using study::BlurredReference;
using study::BlurReference;
using study::CompareBetween;
using study::Outside;
using study::StencilColorReference;

} // namespace limn::test
