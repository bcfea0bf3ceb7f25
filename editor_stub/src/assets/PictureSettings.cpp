#include "assets/PictureSettings.h"

#include "assets/ExrFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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

/// The texels of a picture as numbers, linear where it is sRGB.
class TexelAccess
{
public:
    TexelAccess(Image& image, bool isSrgb)
        : m_Image(image),
          m_IsHalf(image.format == GraphicsFormat::R16G16B16A16_SFloat),
          m_IsSrgb(isSrgb && !m_IsHalf)
    {
    }

    glm::vec4 Get(std::size_t index) const
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
    void Set(std::size_t index, const glm::vec4& value) const
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

private:
    Image& m_Image;
    bool m_IsHalf;
    bool m_IsSrgb;
};

std::size_t TexelCount(const Image& image)
{
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// Channels by what they take of the file's, in the file's own encoding.
void ChangeChannels(Image& image, const PictureSettings& settings)
{
    const TexelAccess texels(image, false);
    const bool isPlain = settings.swizzle == PictureSettings().swizzle;
    for (std::size_t i = 0; i < TexelCount(image); ++i)
    {
        glm::vec4 value = texels.Get(i);
        value.a = settings.alpha == PictureAlpha::None ? 1.0f
                  : settings.alpha == PictureAlpha::FromGrayScale
                      ? (value.r + value.g + value.b) / 3
                      : value.a;
        if (!isPlain)
        {
            const glm::vec4 file = value;
            for (int c = 0; c < 4; ++c)
            {
                const auto source = static_cast<int>(settings.swizzle[static_cast<std::size_t>(c)]);
                value[c] = source < 4   ? file[source]
                           : source < 8 ? 1.0f - file[source - 4]
                                        : static_cast<float>(source - 8);
            }
        }
        if (settings.isNormalMap)
        {
            value.g = settings.flipGreenChannel ? 1.0f - value.g : value.g;
            value.a = 1.0f;
        }
        texels.Set(i, value);
    }
}

/// Normals of the slopes of a height, by central differences; the picture repeats at its borders.
Image NormalsOfHeights(Image heights, float heightScale)
{
    Image normals = heights;
    const TexelAccess from(heights, false);
    const TexelAccess to(normals, false);
    const float strength = 100.0f * heightScale;
    const auto height = [&](int x, int y)
    {
        const int column = (x + heights.width) % heights.width;
        const int row = (y + heights.height) % heights.height;
        const glm::vec4 value =
            from.Get(static_cast<std::size_t>(row) * static_cast<std::size_t>(heights.width) +
                     static_cast<std::size_t>(column));
        return strength * (value.r + value.g + value.b) / 3.0f;
    };
    for (int y = 0; y < heights.height; ++y)
    {
        for (int x = 0; x < heights.width; ++x)
        {
            // Row 0 is the top, and green goes up.
            const glm::vec3 slope((height(x - 1, y) - height(x + 1, y)) / 2.0f,
                                  (height(x, y + 1) - height(x, y - 1)) / 2.0f, 1.0f);
            to.Set(static_cast<std::size_t>(y) * static_cast<std::size_t>(heights.width) +
                       static_cast<std::size_t>(x),
                   glm::vec4(glm::normalize(slope) * 0.5f + 0.5f, 1.0f));
        }
    }
    return normals;
}

/// The share of each old texel in a new one of a line that becomes shorter.
struct Coverage
{
    int first = 0;
    std::vector<float> weights; ///< they sum to 1
};

Coverage CoverageOf(int index, int newSize, int oldSize)
{
    const double scale = static_cast<double>(oldSize) / newSize;
    const double begin = index * scale;
    const double end = begin + scale;
    Coverage coverage;
    coverage.first = static_cast<int>(begin);
    for (int i = coverage.first; i < oldSize && i < end; ++i)
    {
        const double share = std::min(end, i + 1.0) - std::max<double>(begin, i);
        coverage.weights.push_back(static_cast<float>(share / scale));
    }
    return coverage;
}

Image Shrink(Image image, bool isSrgb, int mostTexels)
{
    const double scale = static_cast<double>(mostTexels) / std::max(image.width, image.height);
    const auto shrunk = [&](int size)
    {
        return std::max(1, static_cast<int>(std::lround(size * scale)));
    };
    Image result{shrunk(image.width), shrunk(image.height), image.format, {}};
    result.texels.resize(TexelCount(result) *
                         static_cast<std::size_t>(BytesPerTexel(image.format)));
    std::vector<Coverage> columns;
    for (int x = 0; x < result.width; ++x)
    {
        columns.push_back(CoverageOf(x, result.width, image.width));
    }
    const TexelAccess from(image, isSrgb);
    const TexelAccess to(result, isSrgb);
    std::vector<glm::vec4> row(static_cast<std::size_t>(result.width));
    for (int y = 0; y < result.height; ++y)
    {
        std::ranges::fill(row, glm::vec4(0.0f));
        const Coverage rows = CoverageOf(y, result.height, image.height);
        for (std::size_t i = 0; i < rows.weights.size(); ++i)
        {
            const std::size_t line =
                (static_cast<std::size_t>(rows.first) + i) * static_cast<std::size_t>(image.width);
            for (std::size_t x = 0; x < row.size(); ++x)
            {
                const std::size_t first = line + static_cast<std::size_t>(columns[x].first);
                for (std::size_t j = 0; j < columns[x].weights.size(); ++j)
                {
                    row[x] += rows.weights[i] * columns[x].weights[j] * from.Get(first + j);
                }
            }
        }
        for (std::size_t x = 0; x < row.size(); ++x)
        {
            to.Set(static_cast<std::size_t>(y) * row.size() + x, row[x]);
        }
    }
    return result;
}

} // namespace

Image ApplyPictureSettings(Image image, const PictureSettings& settings)
{
    const bool isHalf = image.format == GraphicsFormat::R16G16B16A16_SFloat;
    if (settings.alpha != PictureAlpha::FromInput ||
        settings.swizzle != PictureSettings().swizzle || settings.isNormalMap)
    {
        ChangeChannels(image, settings);
    }
    if (settings.isNormalMap && settings.convertToNormalMap)
    {
        image = NormalsOfHeights(std::move(image), settings.heightScale);
    }
    const bool isSrgb = settings.sRGB && !settings.isNormalMap;
    if (settings.maxTextureSize > 0 &&
        std::max(image.width, image.height) > settings.maxTextureSize)
    {
        image = Shrink(std::move(image), isSrgb, settings.maxTextureSize);
    }
    image.format = isHalf   ? image.format
                   : isSrgb ? GraphicsFormat::R8G8B8A8_SRGB
                            : GraphicsFormat::R8G8B8A8_UNorm;
    return image;
}

} // namespace limn
