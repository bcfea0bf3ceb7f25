#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/ProfilingScope.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace porting
{

using namespace limn;

// XRayFeature.cs, line by line.
class XRayFeature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingOpaques;
        LayerMask layerMask = LayerMask::Nothing();
        std::shared_ptr<const Shader> shader = nullptr;
        Color color = Color(1.0f, 0.45f, 0.1f, 0.6f);
        int stencilReference = 1;
    };

private:
    class XRayPass final : public ScriptableRenderPass
    {
        static constexpr int k_MarkPass = 0;
        static constexpr int k_ColorPass = 1;
        static inline const ShaderPropertyId s_Color = Shader::PropertyToID("_XRayColor");

        List<ShaderTagId> m_ShaderTagIds = List<ShaderTagId>();
        const ProfilingSampler m_ProfilingSampler = ProfilingSampler("X-Ray");
        std::shared_ptr<Material> m_Material;
        FilteringSettings m_FilteringSettings;
        RenderStateBlock m_Visible;
        RenderStateBlock m_Hidden;

    public:
        XRayPass(const Settings& settings)
        {
            renderPassEvent = settings.renderPassEvent;
            m_FilteringSettings = FilteringSettings(RenderQueueRange::opaque, settings.layerMask);
            m_ShaderTagIds.Add(ShaderTagId("SRPDefaultUnlit"));
            m_ShaderTagIds.Add(ShaderTagId("UniversalForward"));
            m_Material = CoreUtils::CreateEngineMaterial(settings.shader);
            m_Material->SetColor(s_Color, settings.color);

            StencilState visible = StencilState::defaultValue;
            visible.SetPassOperation(StencilOp::Replace);
            m_Visible = RenderStateBlock(RenderStateMask::Stencil);
            m_Visible.stencilReference = settings.stencilReference;
            m_Visible.stencilState = visible;

            StencilState hidden = StencilState::defaultValue;
            hidden.SetCompareFunction(CompareFunction::NotEqual);
            hidden.SetPassOperation(StencilOp::Replace);
            m_Hidden = RenderStateBlock(RenderStateMask::Depth | RenderStateMask::Stencil);
            m_Hidden.depthState = DepthState(false, CompareFunction::Greater);
            m_Hidden.stencilReference = settings.stencilReference;
            m_Hidden.stencilState = hidden;
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            SortingCriteria sortingCriteria = renderingData.cameraData.defaultOpaqueSortFlags;
            DrawingSettings drawingSettings =
                CreateDrawingSettings(m_ShaderTagIds, renderingData, sortingCriteria);
            drawingSettings.overrideMaterial = m_Material;

            auto cmd = CommandBufferPool::Get();
            {
                const ProfilingScope scope(*cmd, m_ProfilingSampler);
                context.ExecuteCommandBuffer(*cmd);
                cmd->Clear();

                drawingSettings.overrideMaterialPassIndex = k_MarkPass;
                context.DrawRenderers(renderingData.cullResults, drawingSettings,
                                      m_FilteringSettings, m_Visible);
                drawingSettings.overrideMaterialPassIndex = k_ColorPass;
                context.DrawRenderers(renderingData.cullResults, drawingSettings,
                                      m_FilteringSettings, m_Hidden);
            }
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }
    };

public:
    Settings settings = Settings();

private:
    std::unique_ptr<XRayPass> m_Pass;

public:
    void Create() override { m_Pass = std::make_unique<XRayPass>(settings); }

    void AddRenderPasses(ScriptableRenderer& renderer,
                         [[maybe_unused]] RenderingData& renderingData) override
    {
        renderer.EnqueuePass(*m_Pass);
    }

    void Describe(Inspector& inspector) override
    {
        inspector.BeginGroup("settings");
        inspector.Field("renderPassEvent", settings.renderPassEvent,
                        "The event at which it is drawn");
        inspector.Field("layerMask", settings.layerMask,
                        "The layers of the objects whose hidden parts are shown");
        inspector.Field("shader", settings.shader, "Draws the hidden parts");
        inspector.Field("color", settings.color, "The colour in sRGB; its alpha is the opacity");
        inspector.Field("stencilReference", settings.stencilReference, {1, 255},
                        "The stencil value of pixels that need no colour");
        inspector.EndGroup();
    }
};

} // namespace porting
