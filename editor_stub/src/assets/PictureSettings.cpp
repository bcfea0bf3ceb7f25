#include "assets/PictureSettings.h"

#include "assets/TexelAccess.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace limn
{

namespace
{

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
