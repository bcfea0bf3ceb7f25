#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/UniversalRenderer.h>

namespace limn
{

namespace
{

constexpr int k_FinalBlitPass = 2; // "Final" of CoreBlit.shader

/// A texture of the renderer's own: nobody sees it after the frame.
void AllocateAttachment(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                        const char* name)
{
    if (handle && handle.rt()->descriptor() == descriptor)
    {
        return;
    }
    const SamplerState sampler{FilterMode::Bilinear, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                               TextureWrapMode::Clamp, false};
    handle = RTHandle(std::make_shared<const RenderTexture>(name, descriptor, sampler, true));
}

} // namespace

/// Draws the objects of a queue range with their own materials.
/// Unity: UnityEngine.Rendering.Universal.Internal.DrawObjectsPass (URP 14).
class UniversalRenderer::DrawObjectsPass final : public ScriptableRenderPass
{
public:
    DrawObjectsPass(const char* name, RenderPassEvent event, RenderQueueRange queues,
                    SortingCriteria sorting)
        : m_Filtering(queues), m_Sorting(sorting)
    {
        profilingSampler = ProfilingSampler(name);
        renderPassEvent = event;
    }

    void SetLayerMask(LayerMask layers) { m_Filtering.layerMask = layers; }

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
    {
        const DrawingSettings drawing =
            CreateDrawingSettings(ForwardShaderTags(), renderingData, m_Sorting);
        context.DrawRenderers(renderingData.cullResults, drawing, m_Filtering);
    }

private:
    FilteringSettings m_Filtering;
    SortingCriteria m_Sorting;
};

/// Copies the camera's colour to the output, where it becomes sRGB.
/// Unity: UnityEngine.Rendering.Universal.Internal.FinalBlitPass (URP 14).
class UniversalRenderer::FinalBlitPass final : public ScriptableRenderPass
{
public:
    explicit FinalBlitPass(std::shared_ptr<const Shader> shader)
        : m_Material(CoreUtils::CreateEngineMaterial(std::move(shader)))
    {
        profilingSampler = ProfilingSampler("Final Blit");
        renderPassEvent = RenderPassEvent::AfterRendering + 1;
    }

    void SetTargets(const RTHandle& source, const RTHandle& destination)
    {
        m_Source = source;
        ConfigureTarget(destination);
    }

    void Execute(ScriptableRenderContext& context, RenderingData&) override
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        Blitter::BlitTexture(*cmd, m_Source, {1.0f, 1.0f, 0.0f, 0.0f}, m_Material, k_FinalBlitPass);
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    std::shared_ptr<const Material> m_Material;
    RTHandle m_Source;
};

UniversalRenderer::UniversalRenderer(std::shared_ptr<ShaderCompiler> compiler)
    : m_OpaquePass(std::make_unique<DrawObjectsPass>(
          "Draw Opaque Objects", RenderPassEvent::BeforeRenderingOpaques, RenderQueueRange::opaque,
          SortingCriteria::CommonOpaque)),
      m_TransparentPass(std::make_unique<DrawObjectsPass>(
          "Draw Transparent Objects", RenderPassEvent::BeforeRenderingTransparents,
          RenderQueueRange::transparent, SortingCriteria::CommonTransparent)),
      m_FinalBlitPass(
          std::make_unique<FinalBlitPass>(FindBuiltinShader("Hidden/Universal/CoreBlit", compiler)))
{
}

UniversalRenderer::~UniversalRenderer() = default;

void UniversalRenderer::Setup(ScriptableRenderContext&, RenderingData& renderingData)
{
    if (!m_Output)
    {
        throw ContractError("UniversalRenderer: SetOutput was not called before rendering");
    }
    RenderTextureDescriptor color = renderingData.cameraData.cameraTargetDescriptor;
    color.depthBufferBits = 0;
    AllocateAttachment(m_Color, color, "_CameraColorAttachmentA");
    AllocateAttachment(m_Depth, renderingData.cameraData.cameraTargetDescriptor,
                       "_CameraDepthAttachment");
    ConfigureCameraTarget(m_Color, m_Depth);

    m_OpaquePass->SetLayerMask(opaqueLayerMask);
    m_TransparentPass->SetLayerMask(transparentLayerMask);
    m_FinalBlitPass->SetTargets(m_Color, m_Output);
    EnqueuePass(*m_OpaquePass);
    EnqueuePass(*m_TransparentPass);
    EnqueuePass(*m_FinalBlitPass);
}

} // namespace limn
