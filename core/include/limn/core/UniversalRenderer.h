#pragma once

#include <limn/core/ScriptableRenderer.h>
#include <limn/shaderlab/ShaderCompiler.h>

namespace limn
{

/// URP's forward renderer in small: opaque objects (event 250), transparent objects (450), final
/// copy to the output (1001). Unity: UnityEngine.Rendering.Universal.UniversalRenderer (URP 14).
class UniversalRenderer final : public ScriptableRenderer
{
public:
    explicit UniversalRenderer(std::shared_ptr<ShaderCompiler> compiler);
    ~UniversalRenderer() override;

    LayerMask opaqueLayerMask = LayerMask::Everything();
    LayerMask transparentLayerMask = LayerMask::Everything();

    /// Where the picture ends up: R8G8B8A8_SRGB of the camera's size. Set before rendering.
    void SetOutput(RTHandle output) { m_Output = std::move(output); }

protected:
    void Setup(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    class DrawObjectsPass;
    class FinalBlitPass;

    RTHandle m_Output;
    RTHandle m_Color;
    RTHandle m_Depth;
    std::unique_ptr<DrawObjectsPass> m_OpaquePass;
    std::unique_ptr<DrawObjectsPass> m_TransparentPass;
    std::unique_ptr<FinalBlitPass> m_FinalBlitPass;
};

} // namespace limn
