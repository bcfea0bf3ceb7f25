#pragma once

#include <array>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/UniversalFrameData.h>

namespace porting
{

using namespace limn;

// XRayUnity6Feature.cs, line by line.
class XRayUnity6Feature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingOpaques;
        LayerMask layerMask;
        std::shared_ptr<const Shader> shader;
        Color color = Color(1.0f, 0.45f, 0.1f, 0.6f);
        int stencilReference = 1;
    };

private:
    class XRayPass final : public ScriptableRenderPass
    {
        static constexpr int k_MarkPass = 0;
        static constexpr int k_ColorPass = 1;
        static inline const std::array s_ShaderTagIds = {ShaderTagId("SRPDefaultUnlit"),
                                                         ShaderTagId("UniversalForward")};

        const Settings* m_Settings;
        std::shared_ptr<Material> m_Material;

        struct PassData
        {
            RendererListHandle visible;
            RendererListHandle hidden;
        };

    public:
        XRayPass(const Settings& settings)
        {
            m_Settings = &settings;
            renderPassEvent = settings.renderPassEvent;
            m_Material = CoreUtils::CreateEngineMaterial(settings.shader);
            m_Material->SetColor("_XRayColor", settings.color);
        }

        RenderStateBlock MakeState(bool isVisible)
        {
            StencilState stencil = StencilState::defaultValue;
            stencil.SetPassOperation(StencilOp::Replace);
            stencil.SetCompareFunction(isVisible ? CompareFunction::Always
                                                 : CompareFunction::NotEqual);
            RenderStateBlock state(RenderStateMask::Depth | RenderStateMask::Stencil);
            state.depthState = DepthState(false, isVisible ? CompareFunction::LessEqual
                                                           : CompareFunction::Greater);
            state.stencilReference = m_Settings->stencilReference;
            state.stencilState = stencil;
            return state;
        }

        RendererListHandle CreateList(RenderGraph& renderGraph, ContextContainer& frameData,
                                      int pass)
        {
            UniversalRenderingData& renderingData = frameData.Get<UniversalRenderingData>();
            UniversalCameraData& cameraData = frameData.Get<UniversalCameraData>();
            RendererListDesc desc(s_ShaderTagIds, renderingData.cullResults(), *cameraData.camera);
            desc.sortingCriteria = cameraData.defaultOpaqueSortFlags;
            desc.renderQueueRange = RenderQueueRange::opaque;
            desc.layerMask = m_Settings->layerMask;
            desc.overrideMaterial = m_Material;
            desc.overrideMaterialPassIndex = pass;
            desc.stateBlock = MakeState(pass == k_MarkPass);
            return renderGraph.CreateRendererList(desc);
        }

        void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) override
        {
            UniversalResourceData& resourceData = frameData.Get<UniversalResourceData>();

            PassData* passData = nullptr;
            auto builder = renderGraph.AddRasterRenderPass<PassData>("X-Ray", passData);
            passData->visible = CreateList(renderGraph, frameData, k_MarkPass);
            passData->hidden = CreateList(renderGraph, frameData, k_ColorPass);
            builder.UseRendererList(passData->visible);
            builder.UseRendererList(passData->hidden);
            builder.SetRenderAttachment(resourceData.activeColorTexture(), 0);
            builder.SetRenderAttachmentDepth(resourceData.activeDepthTexture(),
                                             AccessFlags::ReadWrite);
            builder.SetRenderFunc(
                [](PassData& data, RasterGraphContext& context)
                {
                    context.cmd.DrawRendererList(data.visible);
                    context.cmd.DrawRendererList(data.hidden);
                });
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
