#include "FullScreenRenderPass.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/ScriptableRenderer.h>

namespace limn
{

namespace
{

constexpr int k_NearestBlitPass = 0; // "Nearest" of CoreBlit.shader
const glm::vec4 k_WholePicture{1.0f, 1.0f, 0.0f, 0.0f};

} // namespace

FullScreenRenderPass::FullScreenRenderPass(const std::string& passName)
{
    profilingSampler = ProfilingSampler(passName);
}

void FullScreenRenderPass::SetupMembers(std::shared_ptr<const Material> material, int passIndex,
                                        bool fetchActiveColor, bool bindDepthStencilAttachment,
                                        ScriptableRenderPassInput requirements)
{
    m_Material = std::move(material);
    m_PassIndex = passIndex;
    m_FetchActiveColor = fetchActiveColor;
    m_BindDepthStencilAttachment = bindDepthStencilAttachment;
    if (m_FetchActiveColor && !m_CopyMaterial)
    {
        m_CopyMaterial = CoreUtils::CreateEngineMaterial(
            FindBuiltinShader("Hidden/Universal/CoreBlit", m_Material->shader()->compiler()));
    }
    ConfigureInput(requirements);
}

void FullScreenRenderPass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    ResetTarget();
    if (m_FetchActiveColor)
    {
        RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
        descriptor.msaaSamples = 1;
        descriptor.depthBufferBits = 0;
        descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads them
        RenderingUtils::ReAllocateIfNeeded(m_CopiedColor, descriptor, FilterMode::Bilinear,
                                           TextureWrapMode::Clamp, "_FullscreenPassColorCopy");
    }
}

void FullScreenRenderPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const ScriptableRenderer& renderer = *renderingData.cameraData.renderer;
    const RTHandle& color = renderer.cameraColorTargetHandle();
    const RTHandle depth =
        m_BindDepthStencilAttachment ? renderer.cameraDepthTargetHandle() : RTHandle();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    if (m_FetchActiveColor)
    {
        Blitter::BlitCameraTexture(*cmd, color, m_CopiedColor, m_CopyMaterial, k_NearestBlitPass);
    }
    CoreUtils::SetRenderTarget(*cmd, color, depth);
    MaterialPropertyBlock properties;
    if (m_FetchActiveColor)
    {
        properties.SetTexture(Shader::PropertyToID("_BlitTexture"), m_CopiedColor.rt());
    }
    properties.SetVector(Shader::PropertyToID("_BlitScaleBias"), k_WholePicture);
    cmd->DrawProcedural(glm::mat4(1.0f), m_Material, m_PassIndex, 3, properties);
    context.ExecuteCommandBuffer(*cmd);
}

} // namespace limn
