#pragma once

#include "device/Spirv.h"

namespace limn::vulkan
{

/// A vertex function that gives points a size of one texel, as Direct3D's are, where it gives them
/// none: Vulkan leaves that size undefined.
Words WithPointSize(const Words& vertexSpirv);

} // namespace limn::vulkan
