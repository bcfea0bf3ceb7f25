#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace limn::test
{

// Picture files byte by byte, as their formats are described; no library of limn's has a part in
// them. All numbers are little-endian, as this machine's.

template <typename T>
void AppendNumber(std::string& bytes, T value)
{
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// A TIFF file of one uncompressed strip. The samples after the first three, or after the first of
/// a grey one, are unspecified ones, as Photoshop and Maya write alpha.
template <typename Sample>
std::string TiffBytesOf(std::uint32_t width, std::uint32_t height, std::uint16_t samples,
                        const std::vector<Sample>& texels)
{
    std::string bytes = "II*";
    bytes += '\0';
    const auto dataSize = static_cast<std::uint32_t>(texels.size() * sizeof(Sample));
    const std::uint32_t bitsAt = 8 + dataSize;
    AppendNumber(bytes, bitsAt + 2u * samples);
    bytes.append(reinterpret_cast<const char*>(texels.data()), dataSize);
    for (std::uint16_t i = 0; i < samples; ++i)
    {
        AppendNumber(bytes, static_cast<std::uint16_t>(8 * sizeof(Sample)));
    }
    const std::uint16_t colors = samples >= 3 ? 3 : 1;
    const bool hasExtra = samples > colors;
    AppendNumber(bytes, static_cast<std::uint16_t>(hasExtra ? 10 : 9));
    const auto entry =
        [&](std::uint16_t tag, std::uint16_t type, std::uint32_t count, std::uint32_t value)
    {
        AppendNumber(bytes, tag);
        AppendNumber(bytes, type);
        AppendNumber(bytes, count);
        AppendNumber(bytes, value);
    };
    constexpr std::uint16_t k_Short = 3;
    constexpr std::uint16_t k_Long = 4;
    const auto bits = static_cast<std::uint32_t>(8 * sizeof(Sample));
    entry(256, k_Long, 1, width);
    entry(257, k_Long, 1, height);
    entry(258, k_Short, samples, samples == 1 ? bits : samples == 2 ? bits << 16 | bits : bitsAt);
    entry(259, k_Short, 1, 1);
    entry(262, k_Short, 1, colors == 3 ? 2 : 1);
    entry(273, k_Long, 1, 8);
    entry(277, k_Short, 1, samples);
    entry(278, k_Long, 1, height);
    entry(279, k_Long, 1, dataSize);
    if (hasExtra)
    {
        entry(338, k_Short, 1, 0);
    }
    AppendNumber(bytes, std::uint32_t{0});
    return bytes;
}

/// An uncompressed OpenEXR file of channels of 16 bits.
/// @param channels  names in their alphabetical order: "ABGR", "Y"
/// @param halves    row by row, in each the channels after each other
inline std::string ExrBytesOf(std::int32_t width, std::int32_t height, const std::string& channels,
                              const std::vector<std::uint16_t>& halves)
{
    std::string bytes;
    AppendNumber(bytes, std::uint32_t{0x01312f76});
    AppendNumber(bytes, std::uint32_t{2});
    const auto attribute = [&](const char* name, const char* type, const std::string& value)
    {
        bytes.append(name, std::strlen(name) + 1);
        bytes.append(type, std::strlen(type) + 1);
        AppendNumber(bytes, static_cast<std::int32_t>(value.size()));
        bytes += value;
    };
    const auto numbers = [](const auto&... values)
    {
        std::string result;
        (AppendNumber(result, values), ...);
        return result;
    };
    std::string list;
    for (const char name : channels)
    {
        list += name;
        list += '\0';
        // Half; nothing special about it; every texel either way.
        list += numbers(std::int32_t{1}, std::int32_t{0}, std::int32_t{1}, std::int32_t{1});
    }
    list += '\0';
    attribute("channels", "chlist", list);
    attribute("compression", "compression", std::string(1, '\0'));
    const std::string window = numbers(std::int32_t{0}, std::int32_t{0}, width - 1, height - 1);
    attribute("dataWindow", "box2i", window);
    attribute("displayWindow", "box2i", window);
    attribute("lineOrder", "lineOrder", std::string(1, '\0'));
    attribute("pixelAspectRatio", "float", numbers(1.0f));
    attribute("screenWindowCenter", "v2f", numbers(0.0f, 0.0f));
    attribute("screenWindowWidth", "float", numbers(1.0f));
    bytes += '\0';
    const std::size_t rowBytes = 2 * channels.size() * static_cast<std::size_t>(width);
    const std::size_t rows = halves.size() * 2 / rowBytes;
    const std::size_t first = bytes.size() + 8 * rows;
    for (std::size_t y = 0; y < rows; ++y)
    {
        AppendNumber(bytes, static_cast<std::uint64_t>(first + y * (rowBytes + 8)));
    }
    for (std::size_t y = 0; y < rows; ++y)
    {
        AppendNumber(bytes, static_cast<std::int32_t>(y));
        AppendNumber(bytes, static_cast<std::int32_t>(rowBytes));
        bytes.append(reinterpret_cast<const char*>(halves.data()) + y * rowBytes, rowBytes);
    }
    return bytes;
}

/// A Radiance HDR file without packing. @param rgbe  four bytes a texel
inline std::string HdrBytesOf(int width, int height, const std::vector<std::uint8_t>& rgbe)
{
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
           std::to_string(width) + "\n" + std::string(rgbe.begin(), rgbe.end());
}

/// An unpacked TGA file, the bottom row first. @param bgra  four bytes a texel
inline std::string TgaBytesOf(std::uint16_t width, std::uint16_t height,
                              const std::vector<std::uint8_t>& bgra)
{
    std::string bytes(18, '\0');
    bytes[2] = 2;
    std::memcpy(bytes.data() + 12, &width, 2);
    std::memcpy(bytes.data() + 14, &height, 2);
    bytes[16] = 32;
    bytes[17] = 8;
    return bytes + std::string(bgra.begin(), bgra.end());
}

} // namespace limn::test
