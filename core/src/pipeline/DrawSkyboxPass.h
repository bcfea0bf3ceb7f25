#pragma once

#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Draws the scene's skybox at the far plane. Its position is rounded to float before anything is
/// computed from it, so that the sky is as exact far away from the world's origin as near it.
/// Unity: UnityEngine.Rendering.Universal.DrawSkyboxPass (URP 14).
class DrawSkyboxPass final : public ScriptableRenderPass
{
public:
    DrawSkyboxPass();

    /// Returns whether the camera shows a sky.
    static bool HasSky(const RenderingData& renderingData);

    /// @pre HasSky
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;
};

/// Returns the projection with which a camera sees the sky: everything in front of it is at the far
/// plane. An orthographic camera sees the sky behind the picture that it has at its far plane.
glm::mat4 SkyProjection(const CameraData& cameraData);

} // namespace limn
