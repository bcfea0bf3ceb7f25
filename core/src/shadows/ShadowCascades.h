#pragma once

#include <limn/core/FixedList.h>
#include <limn/core/FrameCommands.h>
#include <limn/core/Light.h>
#include <limn/core/Scene.h>

namespace limn
{

struct Camera;

inline constexpr int k_MostCascades = 4;

/// A part of what a camera sees, and the light's picture of it. Everything is in world space and
/// double.
struct ShadowCascade
{
    glm::dvec3 center{0.0}; ///< the centre of a ball around the part
    double radius = 0.0;    ///< the ball's, metres; the same wherever the camera is and looks
    glm::dmat4 view{1.0};   ///< world to light space, right-handed, the light along -z
    double halfSize = 0.0;  ///< of the picture, metres
    double nearest = 0.0;   ///< distances from the view's origin along the light: where the
    double farthest = 0.0;  ///< picture's depth begins and ends
    ViewportRect tile;      ///< of the shadow map

    /// Returns the matrix from light space to clip space.
    glm::dmat4 Projection(bool usesReversedZBuffer) const;
    double TexelSize() const { return 2.0 * halfSize / tile.width; } ///< metres
};

using ShadowCascades = FixedList<ShadowCascade, k_MostCascades>;

/// Returns the size of the shadow map: two cascades lie side by side, more of them two by two.
/// Unity: MainLightShadowCasterPass.Setup, ShadowUtils.GetMaxTileResolutionInAtlas (URP 14).
glm::ivec2 ShadowMapSize(const ShadowSettings& settings);

/// Divides what the camera sees, up to the settings' distance or its far plane, into cascades. Each
/// moves by whole texels only, so that shadows do not crawl when the camera moves. Their depth
/// holds the ball; the caller must handle what casts from before it.
/// @param aspect  width / height of the picture
/// @return none, if shadows end before the near plane
ShadowCascades MakeShadowCascades(const Camera& camera, float aspect,
                                  const glm::dvec3& lightDirection, const ShadowSettings& settings);

/// Returns how far shadows are seen, in metres.
double ShadowDistance(const Camera& camera, const ShadowSettings& settings);

/// @throws ContractError naming the number, if one is outside its range
void ExpectValid(const ShadowSettings& settings);

} // namespace limn
