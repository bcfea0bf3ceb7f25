#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/Mathf.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace porting
{

using namespace limn;

// SelectionGlowFeature.cs, line by line.
struct SelectionGlow
{
    static constexpr int k_MarkPass = 0;
    static constexpr int k_MaskPass = 1;
    static inline const ShaderPropertyId s_Direction = Shader::PropertyToID("_GlowDirection");

    static std::shared_ptr<Material> CreateMaterial(Color color, float radius, int stencilReference)
    {
        std::shared_ptr<Material> material =
            CoreUtils::CreateEngineMaterial(Shader::Find("Hidden/Porting/SelectionGlow"));
        material->SetColor("_GlowColor", color);
        material->SetFloat("_GlowDeviation", Mathf::Max(0.5f, radius / 2.5f));
        material->SetInt("_StencilReference", stencilReference);
        return material;
    }

    static void SetDirection(CommandBuffer& cmd, float x, float y)
    {
        cmd.SetGlobalVector(s_Direction, Vector4(x, y, 0.0f, 0.0f));
    }
};

class SelectionGlowFeature final : public ScriptableRendererFeature
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
        static constexpr const char* k_Tag = "Selection Glow";
        static constexpr int k_BlurPass = 2;
        static constexpr int k_CompositePass = 3;

        std::shared_ptr<Material> m_Material;
        FilteringSettings m_FilteringSettings;
        RenderTargetHandle m_Mask;
        RenderTargetHandle m_Blurred;
        RenderTargetIdentifier m_Target;

    public:
        GlowPass(const Settings& settings)
        {
            m_Material = SelectionGlow::CreateMaterial(settings.color, settings.radius,
                                                       settings.stencilReference);
            m_FilteringSettings = FilteringSettings(RenderQueueRange::opaque, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
            m_Mask.Init("_GlowMask");
            m_Blurred.Init("_GlowBlurred");
        }

        void Setup(RenderTargetIdentifier target) { m_Target = target; }

        void Configure(CommandBuffer& cmd,
                       const RenderTextureDescriptor& cameraTextureDescriptor) override
        {
            RenderTextureDescriptor descriptor = cameraTextureDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.SetColorFormat(RenderTextureFormat::R8);
            cmd.GetTemporaryRT(m_Mask.id, descriptor, FilterMode::Point);
            descriptor.SetColorFormat(RenderTextureFormat::RHalf);
            cmd.GetTemporaryRT(m_Blurred.id, descriptor, FilterMode::Point);
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            DrawingSettings drawingSettings = CreateDrawingSettings(
                ShaderTagId("UniversalForward"), renderingData, SortingCriteria::CommonOpaque);
            drawingSettings.overrideMaterial = m_Material;
            drawingSettings.overrideMaterialPassIndex = SelectionGlow::k_MarkPass;
            context.DrawRenderers(renderingData.cullResults, drawingSettings, m_FilteringSettings);

            auto cmd = CommandBufferPool::Get(k_Tag);
            cmd->SetRenderTarget(m_Mask.Identifier());
            cmd->ClearRenderTarget(false, true, Color::clear);
            context.ExecuteCommandBuffer(*cmd);
            cmd->Clear();
            drawingSettings.overrideMaterialPassIndex = SelectionGlow::k_MaskPass;
            context.DrawRenderers(renderingData.cullResults, drawingSettings, m_FilteringSettings);

            SelectionGlow::SetDirection(*cmd, 1.0f, 0.0f);
            cmd->Blit(m_Mask.Identifier(), m_Blurred.Identifier(), m_Material, k_BlurPass);
            SelectionGlow::SetDirection(*cmd, 0.0f, 1.0f);
            cmd->Blit(m_Blurred.Identifier(), m_Mask.Identifier(), m_Material, k_BlurPass);
            cmd->Blit(m_Mask.Identifier(), m_Target, m_Material, k_CompositePass);
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }

        void FrameCleanup(CommandBuffer& cmd) override
        {
            cmd.ReleaseTemporaryRT(m_Mask.id);
            cmd.ReleaseTemporaryRT(m_Blurred.id);
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
        m_GlowPass->Setup(renderer.cameraColorTarget());
        renderer.EnqueuePass(*m_GlowPass);
    }

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
