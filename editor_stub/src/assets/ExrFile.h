#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limn/core/Image.h>
#include <string_view>

namespace limn
{

/// OpenEXR, of its first part, as R16G16B16A16_SFloat: RGB, RGBA, or grey in a channel Y.
/// @param requireSize  throws for sizes that are not read, before memory is taken for them
/// @throws AssetError  if it is broken
Image DecodeExr(const std::filesystem::path& path, std::string_view bytes,
                const std::function<void(std::uint32_t width, std::uint32_t height)>& requireSize);

/// The nearest number of 16 bits that is finite; of what is no number 0.
std::uint16_t HalfOf(float value);

} // namespace limn
