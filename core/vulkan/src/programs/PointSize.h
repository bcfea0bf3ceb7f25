#pragma once

#include "device/Spirv.h"

namespace limn::vulkan
{

/// Returns a vertex function that gives points a size of one texel, as in Direct3D, if the given
/// function sets no size. Vulkan leaves the size undefined.
Words WithPointSize(const Words& vertexSpirv);

} // namespace limn::vulkan
