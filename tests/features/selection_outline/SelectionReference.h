#pragma once

#include "features/OutlineGpuReference.h"
#include "report/truth/twins/SelectionTwin.h"

namespace limn::test
{

using study::BlurredReference;
using study::BlurReference;
using study::CompareBetween;
using study::Outside;
using study::StencilColorReference;

} // namespace limn::test
