#pragma once

#include <glm/vec3.hpp>

namespace limn
{

/// What the order of drawing goes by; the keys apply in the order of their values, the first that
/// differs decides; equal items keep the scene's order. Unity:
/// UnityEngine.Rendering.SortingCriteria.
enum class SortingCriteria
{
    None = 0,
    SortingLayer = 1, ///< accepted; limn has no 2D sorting layers, so all are equal
    RenderQueue = 2,
    BackToFront = 4,           ///< distances whose squares are the same float are equal
    QuantizedFrontToBack = 8,  ///< distances within the same eighth of an octave are equal
    OptimizeStateChanges = 16, ///< equal shader, material and mesh together
    CanvasOrder = 32,          ///< accepted; all are equal
    RendererPriority = 64,     ///< accepted; all are equal
    CommonOpaque = 59,
    CommonTransparent = 23
};
constexpr SortingCriteria operator|(SortingCriteria a, SortingCriteria b)
{
    return static_cast<SortingCriteria>(static_cast<int>(a) | static_cast<int>(b));
}
constexpr bool operator&(SortingCriteria a, SortingCriteria b)
{
    return (static_cast<int>(a) & static_cast<int>(b)) != 0;
}

/// Unity: UnityEngine.Rendering.DistanceMetric.
enum class DistanceMetric
{
    Perspective = 0,  ///< distance from the camera
    Orthographic = 1, ///< distance along the view direction
    CustomAxis = 2    ///< distance along SortingSettings::customAxis
};

/// Unity: UnityEngine.Rendering.SortingSettings (2022.3).
struct SortingSettings
{
    SortingCriteria criteria = SortingCriteria::None;
    glm::dvec3 cameraPosition{0.0};   ///< world, metres
    glm::vec3 cameraForward{0, 0, 1}; ///< world, unit length
    DistanceMetric distanceMetric = DistanceMetric::Perspective;
    glm::vec3 customAxis{0, 0, 1}; ///< world, of any length; what lies farther along it is farther

    bool operator==(const SortingSettings&) const = default;
};

} // namespace limn
