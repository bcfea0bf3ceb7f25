#pragma once

#include <array>
#include <limn/core/ScriptableRenderer.h>
#include <limn/shaderlab/ShaderCompiler.h>

namespace limn
{

class AdditionalLightsShadowCasterPass;
class BlitPass;
class CameraTextures;
class DrawObjectsPass;
class DrawSkyboxPass;
class MainLightShadowCasterPass;
class RenderGraph;
class TextureHandle;

/// A small version of URP's forward renderer: shadow maps if something shows shadows (event 50),
/// opaque objects (250), the skybox if the camera shows one (350), transparent objects (450), final
/// copy to the output (1001) behind the last camera of a stack. Before them it makes the camera's
/// depth, normals and opaque colour, in frames that draw with a shader that reads these.
/// Unity: UnityEngine.Rendering.Universal.UniversalRenderer (URP 14).
class UniversalRenderer final : public ScriptableRenderer
{
public:
    explicit UniversalRenderer(std::shared_ptr<ShaderCompiler> compiler);
    ~UniversalRenderer() override;

    LayerMask opaqueLayerMask = LayerMask::Everything();
    LayerMask transparentLayerMask = LayerMask::Everything();

    std::shared_ptr<ShaderCompiler> shaderCompiler() const override { return m_Compiler; }

    /// Makes a texture of a render graph. Unity: the same (URP 17).
    /// @param clear  if true, clears it to black, or to far, before the first pass that writes it
    static TextureHandle
    CreateRenderGraphTexture(RenderGraph& renderGraph, const RenderTextureDescriptor& desc,
                             ResourceName name, bool clear,
                             FilterMode filterMode = FilterMode::Point,
                             TextureWrapMode wrapMode = TextureWrapMode::Clamp);

    /// Sets the output that receives the picture: a colour of the camera's size. Call it before
    /// rendering.
    void SetOutput(RTHandle output) { m_Output = std::move(output); }

protected:
    void Setup(ScriptableRenderContext& context, RenderingData& renderingData) override;
    const RTHandle& GetCameraColorFrontBuffer() override;
    void SwapColorBuffer(CommandBuffer& cmd) override;
    void SetCameraColor(CommandBuffer& cmd, const RTHandle& color) override;
    std::shared_ptr<const Material> copyMaterial() const override { return m_CopyMaterial; }
    void BeforePass(ScriptableRenderContext& context, RenderingData& renderingData,
                    const ScriptableRenderPass* next, const PassPlace& place) override;

private:
    /// Makes a base camera's targets, onto which the overlays of its stack draw.
    void MakeTargets(const CameraData& camera);
    bool BringsDepth(const CameraData& camera) const;

    std::shared_ptr<ShaderCompiler> m_Compiler;
    std::shared_ptr<const Material> m_CopyMaterial; ///< of CoreBlit.shader
    RTHandle m_Output;
    std::array<RTHandle, 2> m_Colors; ///< the second one is made when it is needed
    std::size_t m_Current = 0;        ///< index of the colour that cameraColorTargetHandle returns
    RTHandle m_Depth;
    std::unique_ptr<MainLightShadowCasterPass> m_MainLightShadowCasterPass;
    std::unique_ptr<AdditionalLightsShadowCasterPass> m_AdditionalLightsShadowCasterPass;
    std::unique_ptr<DrawObjectsPass> m_OpaquePass;
    std::unique_ptr<DrawSkyboxPass> m_SkyboxPass;
    std::unique_ptr<DrawObjectsPass> m_TransparentPass;
    std::unique_ptr<BlitPass> m_FinalBlitPass;
    std::unique_ptr<CameraTextures> m_CameraTextures;
};

} // namespace limn
