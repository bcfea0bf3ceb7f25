#pragma once

#include <glm/vec2.hpp>
#include <limn/core/Texture.h>
#include <memory>
#include <string_view>

namespace limn
{

inline constexpr float k_DefaultSpriteUnit = 256.0f; ///< texels a metre

/// Draws the picture of one of the shapes of Unity's menu "2D Object > Sprites": white, with the
/// shape as its alpha, and no larger than it. They lie in Unity's own package, so that projects
/// name them and do not have them. Returns null for every other guid.
/// Unity: com.unity.2d.sprite 1.0 (2021.1), without the triangle.
std::shared_ptr<const Texture2D> MakeDefaultSprite(std::string_view guid);

} // namespace limn
