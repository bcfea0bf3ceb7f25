#include "assets/CubePicture.h"

#include "assets/TexelAccess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

namespace limn
{

namespace
{

constexpr int k_Faces = 6;

/// The square of a face in a picture of squares.
struct Square
{
    int column = 0;
    int row = 0;
    bool isUpsideDown = false;
};

/// A way to lay out the faces +X -X +Y -Y +Z -Z. Each neighbour in a cross is one in the cube.
struct Layout
{
    CubeMapping mapping = CubeMapping::FullCubemap;
    int columns = 1; ///< of faces
    int rows = 1;
    std::array<Square, k_Faces> squares{};
};

constexpr std::array<Layout, 6> k_Layouts = {{
    {CubeMapping::FullCubemap, 4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}},
    {CubeMapping::FullCubemap, 3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}}},
    {CubeMapping::FullCubemap, 6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}},
    {CubeMapping::FullCubemap, 1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}},
    {CubeMapping::Cylindrical, 4, 2, {}},
    {CubeMapping::Spheremap, 1, 1, {}},
}};

const Layout& LayoutOf(const Image& picture, CubeMapping mapping)
{
    const double shape = std::log(static_cast<double>(picture.width) / picture.height);
    const auto distance = [&](const Layout& layout)
    {
        const bool isMeant = mapping == CubeMapping::AutoCubemap || mapping == layout.mapping;
        return isMeant
                   ? std::abs(shape - std::log(static_cast<double>(layout.columns) / layout.rows))
                   : std::numeric_limits<double>::infinity();
    };
    return *std::ranges::min_element(k_Layouts, {}, distance);
}

/// Turns texels of a square by half a turn.
void TurnOver(std::span<std::byte> texels, std::size_t bytesPerTexel)
{
    for (std::size_t low = 0, high = texels.size() - bytesPerTexel; low < high;
         low += bytesPerTexel, high -= bytesPerTexel)
    {
        std::ranges::swap_ranges(texels.subspan(low, bytesPerTexel),
                                 texels.subspan(high, bytesPerTexel));
    }
}

Image CutSquares(const Image& picture, const Layout& layout, int width)
{
    const auto texel = static_cast<std::size_t>(BytesPerTexel(picture.format));
    const auto side = static_cast<std::size_t>(width);
    const std::size_t rowBytes = texel * static_cast<std::size_t>(picture.width);
    Image faces{width, k_Faces * width, picture.format, {}};
    faces.texels.reserve(texel * TexelCount(faces));
    for (const Square& square : layout.squares)
    {
        const std::byte* row = picture.texels.data() +
                               rowBytes * side * static_cast<std::size_t>(square.row) +
                               texel * side * static_cast<std::size_t>(square.column);
        for (int y = 0; y < width; ++y, row += rowBytes)
        {
            faces.texels.insert(faces.texels.end(), row, row + texel * side);
        }
        if (square.isUpsideDown)
        {
            TurnOver(std::span(faces.texels).last(texel * side * side), texel);
        }
    }
    return faces;
}

/// The directions of a face, as CubemapFaces describes them.
struct FaceAxes
{
    glm::vec3 forward;
    glm::vec3 up;
    glm::vec3 right;
};

constexpr std::array<FaceAxes, k_Faces> k_Axes = {{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
    {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 1, 0}, {0, 0, -1}, {1, 0, 0}},
    {{0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
    {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
    {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
}};

/// Linear between four texels; longitudes go round.
glm::vec4 AtDirection(const TexelAccess& texels, const Image& picture, const glm::vec3& direction)
{
    const float longitude = std::atan2(direction.x, direction.z) / glm::two_pi<float>() + 0.5f;
    const float fromTop = std::acos(std::clamp(direction.y, -1.0f, 1.0f)) / glm::pi<float>();
    const float x = longitude * static_cast<float>(picture.width) - 0.5f;
    const float y = fromTop * static_cast<float>(picture.height) - 0.5f;
    const auto at = [&](float column, float row)
    {
        const int round = (static_cast<int>(column) + picture.width) % picture.width;
        const int inside = std::clamp(static_cast<int>(row), 0, picture.height - 1);
        return texels.Get(static_cast<std::size_t>(inside) *
                              static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(round));
    };
    const float left = std::floor(x);
    const float top = std::floor(y);
    return glm::mix(glm::mix(at(left, top), at(left + 1, top), x - left),
                    glm::mix(at(left, top + 1), at(left + 1, top + 1), x - left), y - top);
}

Image SampleAround(Image& picture, int width)
{
    Image faces{width, k_Faces * width, picture.format, {}};
    faces.texels.resize(TexelCount(faces) * static_cast<std::size_t>(BytesPerTexel(faces.format)));
    const bool isSrgb = IsSRGBFormat(picture.format);
    const TexelAccess from(picture, isSrgb);
    const TexelAccess to(faces, isSrgb);
    std::size_t index = 0;
    for (const FaceAxes& axes : k_Axes)
    {
        for (int y = 0; y < width; ++y)
        {
            const float up =
                1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(width);
            for (int x = 0; x < width; ++x)
            {
                const float right =
                    2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 1.0f;
                const glm::vec3 direction = axes.forward + up * axes.up + right * axes.right;
                to.Set(index++, AtDirection(from, picture, glm::normalize(direction)));
            }
        }
    }
    return faces;
}

} // namespace

int FacesAlong(const Image& picture, CubeMapping mapping)
{
    const Layout& layout = LayoutOf(picture, mapping);
    return std::max(layout.columns, layout.rows);
}

std::optional<Image> CutCube(Image picture, CubeMapping mapping)
{
    const Layout& layout = LayoutOf(picture, mapping);
    const int width = std::min(picture.width / layout.columns, picture.height / layout.rows);
    if (layout.mapping == CubeMapping::Spheremap || width == 0)
    {
        return std::nullopt;
    }
    return layout.mapping == CubeMapping::Cylindrical ? SampleAround(picture, width)
                                                      : CutSquares(picture, layout, width);
}

} // namespace limn
