#pragma once

#include <array>
#include <limn/core/ScriptableRenderer.h>
#include <limn/shaderlab/ShaderCompiler.h>

namespace limn
{

class BlitPass;
class CameraTextures;
class DrawObjectsPass;

/// URP's forward renderer in small: opaque objects (event 250), transparent objects (450), final
/// copy to the output (1001); and before them what makes the camera's depth, normals and opaque
/// colour, in frames that draw with a shader that reads these.
/// Unity: UnityEngine.Rendering.Universal.UniversalRenderer (URP 14).
class UniversalRenderer final : public ScriptableRenderer
{
public:
    explicit UniversalRenderer(std::shared_ptr<ShaderCompiler> compiler);
    ~UniversalRenderer() override;

    LayerMask opaqueLayerMask = LayerMask::Everything();
    LayerMask transparentLayerMask = LayerMask::Everything();

    std::shared_ptr<ShaderCompiler> shaderCompiler() const override { return m_Compiler; }

    /// Where the picture ends up: R8G8B8A8_SRGB of the camera's size. Set before rendering.
    void SetOutput(RTHandle output) { m_Output = std::move(output); }

protected:
    void Setup(ScriptableRenderContext& context, RenderingData& renderingData) override;
    const RTHandle& GetCameraColorFrontBuffer() override;
    void SwapColorBuffer(CommandBuffer& cmd) override;
    std::shared_ptr<const Material> copyMaterial() const override { return m_CopyMaterial; }
    void BeforePass(ScriptableRenderContext& context, RenderingData& renderingData,
                    const ScriptableRenderPass* next, const PassPlace& place) override;

private:
    std::shared_ptr<ShaderCompiler> m_Compiler;
    std::shared_ptr<const Material> m_CopyMaterial; ///< of CoreBlit.shader
    RTHandle m_Output;
    std::array<RTHandle, 2> m_Colors; ///< the second one is made when it is asked for
    std::size_t m_Current = 0;        ///< of them, what cameraColorTargetHandle gives
    RTHandle m_Depth;
    std::unique_ptr<DrawObjectsPass> m_OpaquePass;
    std::unique_ptr<DrawObjectsPass> m_TransparentPass;
    std::unique_ptr<BlitPass> m_FinalBlitPass;
    std::unique_ptr<CameraTextures> m_CameraTextures;
};

} // namespace limn
