#pragma once

#include <glm/mat4x4.hpp>
#include <limn/core/FrameCommands.h>

namespace limn
{

/// Where on a target what lies within the bounds is seen; nothing where they reach behind the
/// camera, so that it may be anywhere.
/// @param bounds          of the object's own space
/// @param radius          of a sphere around the centre of `bounds` that it lies within too;
///                        infinite = of none
/// @param viewProjection  unity_MatrixVP
std::optional<TargetRegion> ProjectBounds(const Bounds& bounds, float radius,
                                          const glm::mat4& localToWorld,
                                          const glm::mat4& viewProjection);

TargetRegion Union(const TargetRegion& a, const TargetRegion& b);

} // namespace limn
