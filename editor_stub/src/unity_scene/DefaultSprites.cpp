#include "unity_scene/DefaultSprites.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <vector>

namespace limn
{

namespace
{

/// A shape holds all that lies within `radius` of a convex polygon, a line or a point. Its places
/// are in texels from the middle of the picture, y upwards.
struct Shape
{
    std::string_view guid;
    const char* name;
    glm::ivec2 size; ///< of the picture
    float radius;
    std::array<glm::vec2, 6> corners; ///< counterclockwise
    std::size_t cornerCount;
};

constexpr Shape k_Shapes[] = {
    {"311925a002f4447b3a28927169b83ea6",
     "Square",
     {256, 256},
     0,
     {{{-128, -128}, {128, -128}, {128, 128}, {-128, 128}}},
     4},
    {"a86470a33a6bf42c4b3595704624658b", "Circle", {256, 256}, 128, {{{0, 0}}}, 1},
    {"207ee8102dd4143d288186ef0be518ee", "Capsule", {256, 512}, 128, {{{0, -128}, {0, 128}}}, 2},
    {"19fb86013d8c24d6cb8410c0aadf30fa",
     "Isometric Diamond",
     {256, 128},
     0,
     {{{-128, 0}, {0, -64}, {128, 0}, {0, 64}}},
     4},
    {"b670ab75dde984907b8570040daa08c5",
     "Hexagon Flat-Top",
     {256, 226},
     0,
     {{{-128, 0}, {-64, -111}, {64, -111}, {128, 0}, {64, 111}, {-64, 111}}},
     6},
    {"5aa8b770bc43046bc8d993d0d5b7f4a5",
     "Hexagon Pointed-Top",
     {226, 256},
     0,
     {{{-111, -64}, {0, -128}, {111, -64}, {111, 64}, {0, 128}, {-111, 64}}},
     6},
    {"8884154dfe85442a3a3578be807dbcdf",
     "9-Sliced",
     {256, 256},
     64,
     {{{-64, -64}, {64, -64}, {64, 64}, {-64, 64}}},
     4},
};

/// Returns the distance to the shape's rim in texels, below 0 inside.
float DistanceTo(const Shape& shape, const glm::vec2& place)
{
    const std::span corners(shape.corners.data(), shape.cornerCount);
    float nearest = std::numeric_limits<float>::max();
    bool isInside = corners.size() > 2;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const glm::vec2 side = corners[(i + 1) % corners.size()] - corners[i];
        const glm::vec2 toPlace = place - corners[i];
        const float length = std::max(glm::dot(side, side), 1.0f); // a point has no side
        const float along = glm::clamp(glm::dot(toPlace, side) / length, 0.0f, 1.0f);
        nearest = std::min(nearest, glm::distance(toPlace, along * side));
        isInside = isInside && side.x * toPlace.y > side.y * toPlace.x;
    }
    return (isInside ? -nearest : nearest) - shape.radius;
}

} // namespace

std::shared_ptr<const Texture2D> MakeDefaultSprite(std::string_view guid)
{
    const auto* const shape = std::ranges::find(k_Shapes, guid, &Shape::guid);
    if (shape == std::end(k_Shapes))
    {
        return nullptr;
    }
    SamplerState sampler;
    sampler.wrapModeU = sampler.wrapModeV = TextureWrapMode::Clamp;
    std::vector<std::byte> texels;
    for (int y = 0; y < shape->size.y; ++y)
    {
        for (int x = 0; x < shape->size.x; ++x)
        {
            const glm::vec2 place = glm::vec2(x, y) + 0.5f - 0.5f * glm::vec2(shape->size);
            const float covered = glm::clamp(0.5f - DistanceTo(*shape, place), 0.0f, 1.0f);
            texels.insert(texels.end(), 3, std::byte{255});
            texels.push_back(static_cast<std::byte>(covered * 255.0f + 0.5f));
        }
    }
    return std::make_shared<const Texture2D>(shape->name, shape->size.x, shape->size.y,
                                             GraphicsFormat::R8G8B8A8_SRGB, std::move(texels),
                                             sampler);
}

} // namespace limn
