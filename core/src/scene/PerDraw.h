#pragma once

#include <glm/mat4x4.hpp>
#include <limn/core/LayerMask.h>
#include <limn/shaderlab/ShaderProgram.h>

namespace limn
{

/// Returns the data that shaders get for one object, rounded to float last.
/// @param origin  the point to which its place is relative, see Camera::renderOrigin
PerDrawData MakePerDrawData(const glm::dmat4& localToWorld, RenderingLayerMask renderingLayers,
                            const glm::dvec3& origin);

/// Returns a view matrix, or one of view and projection, for positions relative to `origin`. It is
/// computed without rounding, and so has no translation where the origin is the camera of
/// Camera::viewMatrix.
glm::dmat4 RelativeTo(const glm::dvec3& origin, const glm::dmat4& view);

} // namespace limn
