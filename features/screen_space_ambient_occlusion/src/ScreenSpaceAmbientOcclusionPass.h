#pragma once

#include <array>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/ScreenSpaceAmbientOcclusion.h>
#include <string_view>

namespace limn
{

/// Textures: _SSAO_OcclusionTexture0...2, what is hidden, of the camera's size or half of it, in
/// red, with the normal in the other channels where the blur needs that;
/// _ScreenSpaceOcclusionTexture [H, W], R8_UNorm, the share of light that is left, but not with
/// AfterOpaque. Unity: ScreenSpaceAmbientOcclusion.ScreenSpaceAmbientOcclusionPass (URP 14).
class ScreenSpaceAmbientOcclusionPass final : public ScriptableRenderPass
{
public:
    static constexpr const char* k_Shader =
        "Hidden/Universal Render Pipeline/ScreenSpaceAmbientOcclusion";

    ScreenSpaceAmbientOcclusionPass(const std::string& featureName,
                                    std::shared_ptr<const Shader> shader);

    /// Before each frame. @param settings  with something to draw
    void Setup(const ScreenSpaceAmbientOcclusionSettings& settings, const CameraData& cameraData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;
    void OnCameraCleanup(CommandBuffer& cmd) override;

private:
    void SetKeywords(bool isOrthographic);
    /// @return what the last blur, by which pass of the shader, reads
    const RTHandle& DrawUpToLastBlur(CommandBuffer& cmd, int& lastPass) const;

    std::shared_ptr<Material> m_Material;
    std::array<std::string_view, 4> m_Keywords; ///< of the material; "" = none
    ScreenSpaceAmbientOcclusionSettings m_Settings;
    RTHandle m_Occlusion; ///< straight from the estimator
    RTHandle m_BlurredOnce;
    RTHandle m_BlurredTwice;
    RTHandle m_Result;
};

/// Sets what SSAO.hlsl wants to know of a camera and of settings with something to draw; the blue
/// noise is not among it.
void SetSsaoConstants(CommandBuffer& cmd, const ScreenSpaceAmbientOcclusionSettings& settings,
                      const CameraData& cameraData);

} // namespace limn
