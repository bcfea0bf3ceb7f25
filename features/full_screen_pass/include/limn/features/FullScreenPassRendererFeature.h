#pragma once

#include <limn/core/RenderPassEvent.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <memory>

namespace limn
{

class FullScreenRenderPass;
class Material;

/// Draws one pass of a material over the whole picture, which it can read as _BlitTexture.
/// Unity: FullScreenPassRendererFeature (URP 14).
class FullScreenPassRendererFeature final : public ScriptableRendererFeature
{
public:
    enum class InjectionPoint
    {
        BeforeRenderingTransparents = 450,
        BeforeRenderingPostProcessing = 550,
        AfterRenderingPostProcessing = 600
    };

    FullScreenPassRendererFeature();
    ~FullScreenPassRendererFeature() override;

    InjectionPoint injectionPoint = InjectionPoint::AfterRenderingPostProcessing;
    /// The picture so far is copied first, so that the pass reads a copy, never its target.
    bool fetchColorBuffer = true;
    ScriptableRenderPassInput requirements = ScriptableRenderPassInput::None;
    std::shared_ptr<Material> passMaterial;
    int passIndex = 0;
    bool bindDepthStencilAttachment = false; ///< the camera's depth and stencil can be tested

    void Create() override;
    /// Without a material, or with a pass index it does not have, nothing is drawn and the report
    /// says so.
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    void Describe(Inspector& inspector) override;

private:
    std::unique_ptr<FullScreenRenderPass> m_FullScreenPass;
};

} // namespace limn
