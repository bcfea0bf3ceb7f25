#pragma once

#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/Transform.h>

namespace limn
{

/// Unity: UnityEngine.LightType.
enum class LightType
{
    Spot = 0,
    Directional = 1,
    Point = 2
};

/// How a light's shadows end: at once, or softly. Unity: UnityEngine.LightShadows.
enum class LightShadows
{
    None = 0,
    Hard = 1,
    Soft = 2
};

/// A light besides the main one, without shadows. Unity: UnityEngine.Light (2022.3).
struct Light
{
    LightType type = LightType::Point;
    Transform transform; ///< shines along its +z, from its position; its scale does not matter
    Color color = Color::white; ///< sRGB
    float intensity = 1.0f;     ///< multiplies the linear colour
    float range = 10.0f;        ///< metres, > 0; nothing is lit from there on (not Directional)
    float spotAngle = 30.0f;    ///< degrees across, where a spot's light ends
    float innerSpotAngle = 21.80208f; ///< degrees across, up to where it is full
};

/// How many lights besides the main one shaders get. Unity: MAX_VISIBLE_LIGHTS of its small
/// platforms; 256 elsewhere.
inline constexpr int k_MaxVisibleAdditionalLights = 32;

} // namespace limn
