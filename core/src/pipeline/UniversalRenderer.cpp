#include "pipeline/CameraTextures.h"
#include "pipeline/DrawSkyboxPass.h"
#include "shadows/AdditionalLightsShadowCasterPass.h"
#include "shadows/MainLightShadowCasterPass.h"
#include "texture/ScaledTexture.h"

#include <algorithm>
#include <limits>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/ShaderSource.h>
#include <limn/core/UniversalRenderer.h>

namespace limn
{

namespace
{

// The passes of CoreBlit.shader: for a picture of its target's size, and for another one.
struct BlitPasses
{
    int ofSize;
    int scaled;
};
constexpr BlitPasses k_Copy{0, 1};      // "Nearest", "Bilinear"
constexpr BlitPasses k_FinalBlit{2, 5}; // "Final", "FinalBilinear": opaque

} // namespace

UniversalRenderer::UniversalRenderer(std::shared_ptr<ShaderCompiler> compiler)
    : m_Compiler(std::move(compiler)),
      m_CopyMaterial(CoreUtils::CreateEngineMaterial(
          FindBuiltinShader("Hidden/Universal/CoreBlit", m_Compiler))),
      m_MainLightShadowCasterPass(std::make_unique<MainLightShadowCasterPass>()),
      m_AdditionalLightsShadowCasterPass(std::make_unique<AdditionalLightsShadowCasterPass>()),
      m_OpaquePass(std::make_unique<DrawObjectsPass>(
          "Draw Opaque Objects", RenderPassEvent::BeforeRenderingOpaques, ForwardShaderTags(),
          RenderQueueRange::opaque, SortingCriteria::CommonOpaque)),
      m_SkyboxPass(std::make_unique<DrawSkyboxPass>()),
      m_TransparentPass(std::make_unique<DrawObjectsPass>(
          "Draw Transparent Objects", RenderPassEvent::BeforeRenderingTransparents,
          ForwardShaderTags(), RenderQueueRange::transparent, SortingCriteria::CommonTransparent))
{
    m_FinalBlitPass = std::make_unique<BlitPass>("Final Blit", RenderPassEvent::AfterRendering + 1,
                                                 m_CopyMaterial, k_FinalBlit.ofSize);
    m_CameraTextures = std::make_unique<CameraTextures>(m_CopyMaterial);
    SetShaderSource(std::make_shared<ShaderSource>(&BuiltinShaders, m_Compiler));
}

UniversalRenderer::~UniversalRenderer() = default;

void UniversalRenderer::Setup(ScriptableRenderContext&, RenderingData& renderingData)
{
    if (!m_Output)
    {
        throw ContractError("UniversalRenderer: SetOutput was not called before rendering");
    }
    const CameraData& camera = renderingData.cameraData;
    if (camera.renderType == CameraRenderType::Base)
    {
        MakeTargets(camera);
    }
    m_CameraTextures->Setup(activeRenderPassQueue(), opaqueLayerMask, camera.cameraTargetDescriptor,
                            renderingData.report->notes);
    m_OpaquePass->SetLayerMask(opaqueLayerMask);
    m_TransparentPass->SetLayerMask(transparentLayerMask);
    if (m_MainLightShadowCasterPass->Setup(renderingData))
    {
        EnqueuePass(*m_MainLightShadowCasterPass);
    }
    if (m_AdditionalLightsShadowCasterPass->Setup(renderingData))
    {
        EnqueuePass(*m_AdditionalLightsShadowCasterPass);
    }
    EnqueuePass(*m_OpaquePass);
    if (DrawSkyboxPass::HasSky(renderingData))
    {
        EnqueuePass(*m_SkyboxPass);
    }
    EnqueuePass(*m_TransparentPass);
    if (camera.resolveFinalTarget)
    {
        EnqueuePass(*m_FinalBlitPass);
    }
}

void UniversalRenderer::MakeTargets(const CameraData& camera)
{
    RenderTextureDescriptor color = camera.cameraTargetDescriptor;
    color.depthBufferBits = 0;
    m_Current = 0;
    RenderTextureDescriptor depth = camera.cameraTargetDescriptor;
    depth.graphicsFormat = GraphicsFormat::None;
    AllocateTransient(m_Depth, depth, "_CameraDepthAttachment", FilterMode::Bilinear);
    AllocateTransient(m_Colors[0], color, "_CameraColorAttachmentA", FilterMode::Bilinear,
                      BringsDepth(camera) ? m_Depth.rt() : nullptr);
    ConfigureCameraTarget(m_Colors[0], m_Depth);
    const BlitPasses& passes = camera.targetTexture ? k_Copy : k_FinalBlit;
    const bool isScaled = color.width != camera.pixelWidth || color.height != camera.pixelHeight;
    m_FinalBlitPass->SetMaterialPass(isScaled ? passes.scaled : passes.ofSize,
                                     BlitScaleBias(IsProjectionFlipped(*m_Output.rt())));
    m_FinalBlitPass->SetTargets(m_Colors[0], m_Output);
}

/// Returns whether the camera's colour has the camera's depth, as in URP 7 to 11 where no depth
/// texture is made of that. Source: UniversalRenderer.Setup, CreateCameraRenderTarget (URP 10).
bool UniversalRenderer::BringsDepth(const CameraData& camera) const
{
    return camera.pipelineVersion < 12 &&
           std::ranges::none_of(activeRenderPassQueue(), [](const ScriptableRenderPass* pass)
                                { return pass->input() & ScriptableRenderPassInput::Depth; });
}

const RTHandle& UniversalRenderer::GetCameraColorFrontBuffer()
{
    RTHandle& front = m_Colors[1 - m_Current];
    AllocateTransient(front, m_Colors[m_Current].rt()->descriptor(),
                      m_Current == 0 ? "_CameraColorAttachmentB" : "_CameraColorAttachmentA",
                      FilterMode::Bilinear);
    return front;
}

void UniversalRenderer::SwapColorBuffer(CommandBuffer& cmd)
{
    ScriptableRenderer::SwapColorBuffer(cmd);
    m_Current = 1 - m_Current;
}

void UniversalRenderer::SetCameraColor(CommandBuffer& cmd, const RTHandle& color)
{
    ScriptableRenderer::SetCameraColor(cmd, color);
    m_FinalBlitPass->SetTargets(color, m_Output);
}

void UniversalRenderer::BeforePass(ScriptableRenderContext& context, RenderingData& renderingData,
                                   const ScriptableRenderPass* next, const PassPlace& place)
{
    if (next != nullptr)
    {
        m_CameraTextures->BeforePass(context, next->renderPassEvent, place,
                                     cameraColorTargetHandle());
        return;
    }
    constexpr auto behindAll = static_cast<RenderPassEvent>(std::numeric_limits<int>::max());
    m_CameraTextures->BeforePass(context, behindAll, place, cameraColorTargetHandle());
    for (const auto& late : m_CameraTextures->Needed(context, m_Depth))
    {
        ExecuteAt(late.place, context, *late.pass, renderingData);
    }
}

} // namespace limn
