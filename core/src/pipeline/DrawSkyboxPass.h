#pragma once

#include <limn/core/ScriptableRenderPass.h>

namespace limn
{

/// Draws the scene's skybox at the far plane. Its position is rounded to float before anything is
/// made of it, so that the sky is as exact far away from the world's origin as near it.
/// Unity: UnityEngine.Rendering.Universal.DrawSkyboxPass (URP 14).
class DrawSkyboxPass final : public ScriptableRenderPass
{
public:
    DrawSkyboxPass();

    /// Whether the camera shows one.
    static bool HasSky(const RenderingData& renderingData);

    /// @pre HasSky
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;
};

/// What a camera looks at the sky with: everything in front of it is at the far plane. An
/// orthographic one sees the sky behind the picture that it has at its far plane.
glm::mat4 SkyProjection(const CameraData& cameraData);

} // namespace limn
