#pragma once

#include "SelectionGlowFeature.h"

#include <limn/core/ProfilingScope.h>

namespace porting
{

// SelectionGlowUrp14Feature.cs, line by line.
class SelectionGlowUrp14Feature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
        LayerMask layerMask = LayerMask::Nothing();
        Color color = Color(0.3f, 0.8f, 1.0f, 1.0f);
        float radius = 8.0f;
        int stencilReference = 2;
    };

private:
    class GlowPass final : public ScriptableRenderPass
    {
        static constexpr int k_BlurPass = 4;
        static constexpr int k_CompositePass = 5;

        std::shared_ptr<Material> m_Material;
        FilteringSettings m_FilteringSettings;
        RTHandle m_Mask;
        RTHandle m_Blurred;

    public:
        GlowPass(const Settings& settings)
        {
            m_Material = SelectionGlow::CreateMaterial(settings.color, settings.radius,
                                                       settings.stencilReference);
            m_FilteringSettings = FilteringSettings(RenderQueueRange::opaque, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
            profilingSampler = ProfilingSampler("Selection Glow");
        }

        void OnCameraSetup([[maybe_unused]] CommandBuffer& cmd,
                           RenderingData& renderingData) override
        {
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.graphicsFormat = GraphicsFormat::R8_UNorm;
            RenderingUtils::ReAllocateIfNeeded(m_Mask, descriptor, FilterMode::Point,
                                               TextureWrapMode::Clamp, "_GlowMask");
            descriptor.graphicsFormat = GraphicsFormat::R16_SFloat;
            RenderingUtils::ReAllocateIfNeeded(m_Blurred, descriptor, FilterMode::Point,
                                               TextureWrapMode::Clamp, "_GlowBlurred");
        }

        RendererList CreateList(ScriptableRenderContext& context, RenderingData& renderingData,
                                int pass)
        {
            DrawingSettings drawingSettings = CreateDrawingSettings(
                ShaderTagId("UniversalForward"), renderingData, SortingCriteria::CommonOpaque);
            drawingSettings.overrideMaterial = m_Material;
            drawingSettings.overrideMaterialPassIndex = pass;
            RendererListParams parameters(renderingData.cullResults, drawingSettings,
                                          m_FilteringSettings);
            return context.CreateRendererList(parameters);
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            RTHandle color = renderingData.cameraData.renderer->cameraColorTargetHandle();
            RTHandle depth = renderingData.cameraData.renderer->cameraDepthTargetHandle();
            RendererList marked = CreateList(context, renderingData, SelectionGlow::k_MarkPass);
            RendererList masked = CreateList(context, renderingData, SelectionGlow::k_MaskPass);

            auto cmd = CommandBufferPool::Get();
            {
                const ProfilingScope scope(*cmd, profilingSampler);
                CoreUtils::SetRenderTarget(*cmd, color, depth);
                cmd->DrawRendererList(marked);
                CoreUtils::SetRenderTarget(*cmd, m_Mask, ClearFlag::Color, Color::clear);
                cmd->DrawRendererList(masked);

                SelectionGlow::SetDirection(*cmd, 1.0f, 0.0f);
                Blitter::BlitCameraTexture(*cmd, m_Mask, m_Blurred, m_Material, k_BlurPass);
                SelectionGlow::SetDirection(*cmd, 0.0f, 1.0f);
                Blitter::BlitCameraTexture(*cmd, m_Blurred, m_Mask, m_Material, k_BlurPass);
                CoreUtils::SetRenderTarget(*cmd, color, depth);
                Blitter::BlitTexture(*cmd, m_Mask, Vector4(1.0f, 1.0f, 0.0f, 0.0f), m_Material,
                                     k_CompositePass);
            }
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }

        void Dispose()
        {
            m_Mask.Release();
            m_Blurred.Release();
        }
    };

public:
    Settings settings = Settings();

private:
    std::unique_ptr<GlowPass> m_GlowPass;

public:
    void Create() override { m_GlowPass = std::make_unique<GlowPass>(settings); }

    void AddRenderPasses(ScriptableRenderer& renderer,
                         [[maybe_unused]] RenderingData& renderingData) override
    {
        renderer.EnqueuePass(*m_GlowPass);
    }

    void Dispose([[maybe_unused]] bool disposing) override { m_GlowPass->Dispose(); }

    void Describe(Inspector& inspector) override
    {
        inspector.BeginGroup("settings");
        inspector.Field("renderPassEvent", settings.renderPassEvent,
                        "The event at which it is drawn");
        inspector.Field("layerMask", settings.layerMask, "The layers of the objects that glow");
        inspector.Field("color", settings.color, "The colour in sRGB; its alpha is the opacity");
        inspector.Field("radius", settings.radius, {1.0f, 24.0f}, "Texels");
        inspector.Field("stencilReference", settings.stencilReference, {1, 255},
                        "Marks the objects, over which no glow is drawn");
        inspector.EndGroup();
    }
};

} // namespace porting
