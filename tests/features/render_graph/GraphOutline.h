#pragma once

#include "features/OutlineScene.h"

#include <algorithm>
#include <limn/core/UniversalFrameData.h>

namespace limn::test
{

/// OutlineDrawingRenderPass as Unity 6 has it: the same three draws, each a raster pass.
class GraphOutlinePass final : public ScriptableRenderPass
{
public:
    explicit GraphOutlinePass(const ScreenSpaceOutlineSettings& settings)
        : m_Material(CoreUtils::CreateEngineMaterial(settings.m_ScreenSpaceOutlineShader)),
          m_Filtering(RenderQueueRange::opaque, settings.m_LayerMask,
                      RenderingLayerMask::FromIndex(settings.m_RenderingLayerMask))
    {
        profilingSampler = ProfilingSampler("Screen Space Outline");
        renderPassEvent = settings.m_RenderPassEvent;
    }

    void Setup(const ScreenSpaceOutline& component)
    {
        m_Material->SetColor("_OutlineColor", component.m_OutlineColor.value());
        m_Material->SetFloat("_OutlineWidth", component.m_OutlineWidth.value());
    }

    void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) override
    {
        const auto& resourceData = frameData.Get<UniversalResourceData>();
        const auto& cameraData = frameData.Get<UniversalCameraData>();

        RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
        descriptor.width = std::max(descriptor.width / 2, 1);
        descriptor.height = std::max(descriptor.height / 2, 1);
        descriptor.SetColorFormat(RenderTextureFormat::R8);
        descriptor.depthBufferBits = 0;
        TextureDesc desc(descriptor);
        desc.name = "_RendererDrawingTexture";
        desc.clearColor = Color::clear;
        const TextureHandle mask = renderGraph.CreateTexture(desc);
        const TextureHandle outline = UniversalRenderer::CreateRenderGraphTexture(
            renderGraph, descriptor, "_OutlineTexture", false, FilterMode::Bilinear);

        AddMaskPass(renderGraph, frameData, mask);
        renderGraph.AddBlitPass({mask, outline, m_Material, 1}, "Edges");
        renderGraph.AddBlitPass({outline, resourceData.activeColorTexture(), m_Material, 2},
                                "Composite");
    }

private:
    struct PassData
    {
        RendererListHandle rendererList;
    };

    void AddMaskPass(RenderGraph& renderGraph, ContextContainer& frameData,
                     const TextureHandle& mask)
    {
        const auto& renderingData = frameData.Get<UniversalRenderingData>();
        DrawingSettings drawing = RenderingUtils::CreateDrawingSettings(
            ForwardShaderTags(), renderingData, frameData.Get<UniversalCameraData>(),
            frameData.Get<UniversalLightData>(),
            SortingCriteria::CommonTransparent | SortingCriteria::CommonOpaque);
        drawing.overrideMaterial = m_Material;
        drawing.overrideMaterialPassIndex = 0;

        PassData* passData = nullptr;
        auto builder = renderGraph.AddRasterRenderPass<PassData>("Mask", passData);
        passData->rendererList = renderGraph.CreateRendererList(
            RendererListParams(renderingData.cullResults(), drawing, m_Filtering));
        builder.UseRendererList(passData->rendererList);
        builder.SetRenderAttachment(mask, 0);
        builder.SetRenderFunc([](PassData& data, RasterGraphContext& context)
                              { context.cmd.DrawRendererList(data.rendererList); });
    }

    std::shared_ptr<Material> m_Material;
    FilteringSettings m_Filtering;
};

class GraphOutlineFeature final : public ScriptableRendererFeature
{
public:
    GraphOutlineFeature() { name = "Screen Space Outline"; }
    void Create() override { m_Pass = std::make_unique<GraphOutlinePass>(Settings()); }
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        m_Pass->Setup(*renderingData.volumeStack->GetComponent<ScreenSpaceOutline>());
        renderer.EnqueuePass(*m_Pass);
    }

private:
    std::unique_ptr<GraphOutlinePass> m_Pass;
};

/// The outline scene drawn by the feature of one style or the other.
class OutlineOfStyle
{
public:
    OutlineOfStyle(GraphicsDevice& device, bool isGraph) : m_Pipeline(device)
    {
        if (isGraph)
        {
            m_Renderer.AddFeature(std::make_unique<GraphOutlineFeature>());
        }
        else
        {
            AddOutline(m_Renderer);
        }
    }

    RenderResult Render(float width = 4.0f)
    {
        RenderRequest request;
        request.scene = &content.scene;
        request.camera = &content.camera;
        request.width = 64;
        request.height = 48;
        request.volumeStack = &m_Volumes.With(true, {0.9f, 0.7f, 0.2f, 1.0f}, width);
        return m_Pipeline.RenderSingleCamera(m_Renderer, request);
    }

    OutlineScene content;

private:
    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
    BlendedOutline m_Volumes;
};

} // namespace limn::test
