#pragma once

#include <array>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/ScreenSpaceAmbientOcclusion.h>
#include <string_view>

namespace limn
{

/// Computes the ambient occlusion. Textures: _SSAO_OcclusionTexture0...2, of the camera's size or
/// half of it, the occlusion in red, with the normal in the other channels if the blur needs it;
/// _ScreenSpaceOcclusionTexture [H, W], R8_UNorm, the remaining share of light, but not with
/// AfterOpaque. Unity: ScreenSpaceAmbientOcclusion.ScreenSpaceAmbientOcclusionPass (URP 14).
class ScreenSpaceAmbientOcclusionPass final : public ScriptableRenderPass
{
public:
    static constexpr const char* k_Shader =
        "Hidden/Universal Render Pipeline/ScreenSpaceAmbientOcclusion";

    ScreenSpaceAmbientOcclusionPass(const std::string& featureName,
                                    std::shared_ptr<const Shader> shader);

    /// Must be called before each frame.
    /// @param settings  must have something to draw
    void Setup(const ScreenSpaceAmbientOcclusionSettings& settings, const CameraData& cameraData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;
    void OnCameraCleanup(CommandBuffer& cmd) override;

private:
    void SetKeywords(bool isOrthographic);
    /// @param lastPass  receives the shader's pass of the last blur
    /// @return the texture that the last blur reads
    const RTHandle& DrawUpToLastBlur(CommandBuffer& cmd, int& lastPass);

    std::shared_ptr<Material> m_Material;
    MaterialPropertyBlock m_Properties;
    std::array<std::string_view, 4> m_Keywords; ///< the keywords of the material; "" = none
    ScreenSpaceAmbientOcclusionSettings m_Settings;
    RTHandle m_Occlusion; ///< the unblurred result
    RTHandle m_BlurredOnce;
    RTHandle m_BlurredTwice;
    RTHandle m_Result;
};

/// Sets the constants of SSAO.hlsl for a camera and for settings that have something to draw,
/// except the blue noise.
void SetSsaoConstants(CommandBuffer& cmd, const ScreenSpaceAmbientOcclusionSettings& settings,
                      const CameraData& cameraData);

} // namespace limn
