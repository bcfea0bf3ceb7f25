#pragma once

#include <cstdint>
#include <limn/core/GraphicsFormat.h>
#include <map>
#include <vector>

namespace limn::vulkan
{

/// SPIR-V's number of a texel format.
/// @throws ContractError if writable textures cannot have it
std::uint32_t ToImageFormat(GraphicsFormat format);
/// Whether only devices with shaderStorageImageExtendedFormats have it.
bool isExtended(std::uint32_t imageFormat);

/// A kernel whose writable textures say which format they have, where shaderlab leaves it open.
/// @param formats  by binding
std::vector<std::uint32_t> WithFormats(const std::vector<std::uint32_t>& spirv,
                                       const std::map<std::uint32_t, std::uint32_t>& formats);

} // namespace limn::vulkan
