#include "assets/TexelAccess.h"

#include "assets/HdrFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace limn
{

namespace
{

double LinearOf(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// sRGB by tables: exact both ways.
struct SrgbTables
{
    std::array<float, 256> linear{};
    std::array<float, 255> borders{}; ///< between a byte and the next one

    SrgbTables()
    {
        for (std::size_t i = 0; i < linear.size(); ++i)
        {
            linear[i] = static_cast<float>(LinearOf(static_cast<double>(i) / 255.0));
        }
        for (std::size_t i = 0; i < borders.size(); ++i)
        {
            borders[i] = static_cast<float>(LinearOf((static_cast<double>(i) + 0.5) / 255.0));
        }
    }
    std::byte Encode(float value) const
    {
        return static_cast<std::byte>(std::ranges::upper_bound(borders, value) - borders.begin());
    }
};

const SrgbTables& Srgb()
{
    static const SrgbTables tables;
    return tables;
}

} // namespace

TexelAccess::TexelAccess(Image& image, bool isSrgb)
    : m_Image(image),
      m_IsHalf(image.format == GraphicsFormat::R16G16B16A16_SFloat),
      m_IsSrgb(isSrgb && !m_IsHalf)
{
}

glm::vec4 TexelAccess::Get(std::size_t index) const
{
    if (m_IsHalf)
    {
        std::uint64_t packed = 0;
        std::memcpy(&packed, m_Image.texels.data() + 8 * index, sizeof(packed));
        return glm::unpackHalf4x16(packed);
    }
    const std::byte* texel = m_Image.texels.data() + 4 * index;
    glm::vec4 value;
    for (int c = 0; c < 4; ++c)
    {
        const auto byte = std::to_integer<std::size_t>(texel[c]);
        value[c] = m_IsSrgb && c < 3 ? Srgb().linear[byte] : static_cast<float>(byte) / 255.0f;
    }
    return value;
}

void TexelAccess::Set(std::size_t index, const glm::vec4& value) const
{
    for (int c = 0; c < 4; ++c)
    {
        if (m_IsHalf)
        {
            const std::uint16_t half = HalfOf(value[c]);
            std::memcpy(m_Image.texels.data() + 8 * index + 2 * c, &half, sizeof(half));
            continue;
        }
        const float inside = std::clamp(value[c], 0.0f, 1.0f);
        m_Image.texels[4 * index + static_cast<std::size_t>(c)] =
            m_IsSrgb && c < 3 ? Srgb().Encode(inside)
                              : static_cast<std::byte>(std::lround(inside * 255.0f));
    }
}

} // namespace limn
