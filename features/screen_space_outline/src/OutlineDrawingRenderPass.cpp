#include <algorithm>
#include <limn/core/CoreUtils.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/OutlineDrawingRenderPass.h>

namespace limn
{

namespace
{

// constants
constexpr SortingCriteria kSortingCriteria =
    SortingCriteria::CommonTransparent | SortingCriteria::CommonOpaque;
constexpr const char* kRenderedObjectTextureName = "_RendererDrawingTexture";
constexpr const char* kOutlineTextureName = "_OutlineTexture";
constexpr int kRendererDrawingPassIndex = 0;
constexpr int kEdgeDetectionPassIndex = 1;
constexpr int kCompositePassIndex = 2;

// cached shader property IDs
const ShaderPropertyId _OutlineWidth = Shader::PropertyToID("_OutlineWidth");
const ShaderPropertyId _OutlineColor = Shader::PropertyToID("_OutlineColor");

} // namespace

OutlineDrawingRenderPass::OutlineDrawingRenderPass(const std::string& featureName,
                                                   const ScreenSpaceOutlineSettings& settings)
    : mProfilingSampler(featureName)
{
    // initialization
    profilingSampler = mProfilingSampler;
    renderPassEvent = settings.m_RenderPassEvent;
    mPassMaterial = CoreUtils::CreateEngineMaterial(settings.m_ScreenSpaceOutlineShader);

    if (mPassMaterial->passCount() <= kCompositePassIndex)
    {
        throw ContractError(featureName + ": m_ScreenSpaceOutlineShader: the shader '" +
                            mPassMaterial->shader()->name() + "' has " +
                            std::to_string(mPassMaterial->passCount()) +
                            " of the three passes for mask, edge and composite; "
                            "Hidden/ScreenSpaceOutline has them");
    }

    // create FilteringSettings
    const RenderQueueRange renderQueueRange = ToRenderQueueRange(settings.m_RenderQueueRange);
    const auto renderingLayerMask = RenderingLayerMask::FromIndex(settings.m_RenderingLayerMask);
    mFilteringSettings =
        FilteringSettings(renderQueueRange, settings.m_LayerMask, renderingLayerMask);
}

void OutlineDrawingRenderPass::Setup(const ScreenSpaceOutline& volumeComponent)
{
    // pass shader properties
    mPassMaterial->SetColor(_OutlineColor, volumeComponent.m_OutlineColor.value());
    mPassMaterial->SetFloat(_OutlineWidth, volumeComponent.m_OutlineWidth.value());
}

void OutlineDrawingRenderPass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    // setup temporary render texture
    RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
    descriptor.width = std::max(descriptor.width / 2, 1);
    descriptor.height = std::max(descriptor.height / 2, 1);
    descriptor.SetColorFormat(RenderTextureFormat::R8);
    descriptor.depthBufferBits = 0;
    descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads them
    RenderingUtils::ReAllocateIfNeeded(mRendererDrawingTexture, descriptor, FilterMode::Bilinear,
                                       TextureWrapMode::Clamp, kRenderedObjectTextureName);
    RenderingUtils::ReAllocateIfNeeded(mOutlineTexture, descriptor, FilterMode::Bilinear,
                                       TextureWrapMode::Clamp, kOutlineTextureName);

    // setup color render target
    mCameraColorTexture = renderingData.cameraData.renderer->cameraColorTargetHandle();
}

void OutlineDrawingRenderPass::Execute(ScriptableRenderContext& context,
                                       RenderingData& renderingData)
{
    CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    {
        const ProfilingScope scope{*cmd, mProfilingSampler};
        // setup temporary texture as render target
        CoreUtils::SetRenderTarget(*cmd, mRendererDrawingTexture, ClearFlag::Color, Color::clear);

        context.ExecuteCommandBuffer(*cmd);
        cmd->Clear();

        // Step 1: render certain objects to temporary render texture
        DrawingSettings drawingSettings =
            CreateDrawingSettings(mShaderTagIDs, renderingData, kSortingCriteria);
        drawingSettings.overrideMaterial = mPassMaterial;
        drawingSettings.overrideMaterialPassIndex = kRendererDrawingPassIndex;
        context.DrawRenderers(renderingData.cullResults, drawingSettings, mFilteringSettings);

        // Step 2: edge detection to create outline
        Blitter::BlitCameraTexture(*cmd, mRendererDrawingTexture, mOutlineTexture, mPassMaterial,
                                   kEdgeDetectionPassIndex);

        // Step 3: composite
        CoreUtils::SetRenderTarget(*cmd, mCameraColorTexture);
        Blitter::BlitCameraTexture(*cmd, mOutlineTexture, mCameraColorTexture, mPassMaterial,
                                   kCompositePassIndex);
    }
    context.ExecuteCommandBuffer(*cmd);
    cmd->Clear();
    CommandBufferPool::Release(cmd);
}

} // namespace limn
