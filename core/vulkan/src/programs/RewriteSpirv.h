#pragma once

#include "device/Spirv.h"

#include <limn/core/GraphicsFormat.h>
#include <map>

namespace limn::vulkan
{

/// Returns SPIR-V's number of a texel format.
/// @throws ContractError if writable textures cannot have it
std::uint32_t ToImageFormat(GraphicsFormat format);
/// Returns whether only devices with shaderStorageImageExtendedFormats have the format.
bool isExtended(std::uint32_t imageFormat);

/// SPIR-V's numbers of the formats of writable textures, by binding.
using ImageFormats = std::map<std::uint32_t, std::uint32_t>;

/// Returns a kernel whose writable textures declare their format, which shaderlab leaves open.
Words WithFormats(const Words& spirv, const ImageFormats& formats);

/// Returns a vertex function that gives points a size of one texel, as in Direct3D, if the given
/// function sets no size. Vulkan leaves the size undefined.
Words WithPointSize(const Words& vertexSpirv);

} // namespace limn::vulkan
