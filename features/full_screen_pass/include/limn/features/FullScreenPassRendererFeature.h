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
    /// Copies the picture first, so that the pass reads the copy and never its target.
    bool fetchColorBuffer = true;
    ScriptableRenderPassInput requirements = ScriptableRenderPassInput::None;
    std::shared_ptr<Material> passMaterial;
    int passIndex = 0;
    bool bindDepthStencilAttachment = false; ///< the camera's depth and stencil can be tested

    void Create() override;
    /// Adds the pass. Without a material, or with a pass index that it does not have, nothing is
    /// drawn and the report says so.
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    void Describe(Inspector& inspector) override;

private:
    std::unique_ptr<FullScreenRenderPass> m_FullScreenPass;
};

} // namespace limn
