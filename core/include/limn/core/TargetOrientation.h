#pragma once

#include <glm/vec4.hpp>
#include <limn/core/RenderTexture.h>

namespace limn
{

// The rows of targets. This header alone decides which way up a camera draws, and everything else
// follows from it.
//
// It is as in Unity on a Direct3D-like API: clip space has y up, and y = 1 is the first row of a
// target. A camera's picture is stored with its bottom row first, as all textures are, so that v =
// 0 is the bottom whatever a shader samples. That needs a projection with y flipped, which flips
// the winding, too. Only a target whose image has its top row first, a window's or a host's, is
// drawn without the flip; Unity calls that the back buffer. Rows are flipped once more where a
// picture leaves limn as an Image. Source: GL.GetGPUProjectionMatrix (Unity 2022.3), CameraData
// (URP 14).

/// Returns whether a camera's projection is flipped when it draws into the target.
inline bool IsProjectionFlipped(const RenderTexture& target)
{
    return !target.descriptor().isTopRowFirst;
}

/// Returns a projection with y flipped: from one for a back buffer to one for a texture, and back.
/// @tparam Matrix  glm::mat4 or glm::dmat4
template <typename Matrix>
Matrix WithFlippedY(Matrix projection)
{
    for (int column = 0; column < 4; ++column)
    {
        projection[column][1] = -projection[column][1];
    }
    return projection;
}

/// Returns the value of _ProjectionParams.x in shaders.
constexpr float ProjectionSign(bool isProjectionFlipped)
{
    return isProjectionFlipped ? -1.0f : 1.0f;
}

/// Returns _ScaleBiasRt, with which GetNormalizedScreenSpaceUV flips y where that is needed.
constexpr glm::vec4 ScaleBiasRt(bool isProjectionFlipped)
{
    return isProjectionFlipped ? glm::vec4(-1.0f, 1.0f, -1.0f, 1.0f)
                               : glm::vec4(1.0f, 0.0f, 1.0f, 1.0f);
}

/// Returns the scale and offset of the source's uv with which a blit of a texture fills the target
/// upright.
constexpr glm::vec4 BlitScaleBias(bool isProjectionFlipped)
{
    return isProjectionFlipped ? glm::vec4(1.0f, 1.0f, 0.0f, 0.0f)
                               : glm::vec4(1.0f, -1.0f, 0.0f, 1.0f);
}

} // namespace limn
