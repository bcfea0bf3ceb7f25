#pragma once

#include <glm/mat4x4.hpp>
#include <limn/core/LayerMask.h>
#include <limn/shaderlab/ShaderProgram.h>

namespace limn
{

/// What shaders get to know of one object, rounded to float last.
/// @param origin  what its place is relative to, see Camera::renderOrigin
PerDrawData MakePerDrawData(const glm::dmat4& localToWorld, RenderingLayerMask renderingLayers,
                            const glm::dvec3& origin);

/// A view matrix, or one of view and projection, for positions relative to `origin`: without
/// rounding, and so without translation, where the origin is the camera of Camera::viewMatrix.
glm::dmat4 RelativeTo(const glm::dvec3& origin, const glm::dmat4& view);

} // namespace limn
