#pragma once

#include <cstdint>
#include <limn/core/GraphicsFormat.h>
#include <map>
#include <vector>

namespace limn::vulkan
{

/// Returns SPIR-V's number of a texel format.
/// @throws ContractError if writable textures cannot have it
std::uint32_t ToImageFormat(GraphicsFormat format);
/// Returns whether only devices with shaderStorageImageExtendedFormats have the format.
bool isExtended(std::uint32_t imageFormat);

/// Returns a kernel whose writable textures declare their format, which shaderlab leaves open.
/// @param formats  the formats by binding
std::vector<std::uint32_t> WithFormats(const std::vector<std::uint32_t>& spirv,
                                       const std::map<std::uint32_t, std::uint32_t>& formats);

} // namespace limn::vulkan
