#pragma once

#include <glm/mat4x4.hpp>
#include <limn/core/FrameCommands.h>

namespace limn
{

/// Returns the region of a target in which the bounds are seen; nothing if they reach behind the
/// camera, so that they may be anywhere.
/// @param bounds          in the object's own space
/// @param radius          of a sphere around the centre of `bounds` that also contains the object;
///     infinite = no such sphere
/// @param viewProjection  unity_MatrixVP
std::optional<TargetRegion> ProjectBounds(const Bounds& bounds, float radius,
                                          const glm::mat4& localToWorld,
                                          const glm::mat4& viewProjection);

TargetRegion Union(const TargetRegion& a, const TargetRegion& b);

} // namespace limn
