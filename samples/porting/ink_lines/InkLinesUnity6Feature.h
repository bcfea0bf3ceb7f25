#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/Debug.h>
#include <limn/core/Inspector.h>
#include <limn/core/Mathf.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/core/UniversalFrameData.h>

namespace porting
{

using namespace limn;

// InkLinesUnity6Feature.cs, line by line.
class InkLinesUnity6Feature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::BeforeRenderingTransparents;
        LayerMask layerMask = LayerMask::Everything();
        std::shared_ptr<Material> material;
        Color color = Color::black;
        float angle = 25.0f;
    };

private:
    class InkPass final : public ScriptableRenderPass
    {
        static constexpr int k_SurfacePass = 0;
        static constexpr int k_InkPass = 2;
        static inline const ShaderPropertyId s_Normals = Shader::PropertyToID("_InkNormals");
        static inline const ShaderPropertyId s_Ids = Shader::PropertyToID("_InkIds");

        const Settings* m_Settings;
        MaterialPropertyBlock m_Properties;

        struct SurfaceData
        {
            RendererListHandle objects;
        };

        struct InkData
        {
            TextureHandle normals;
            TextureHandle ids;
            std::shared_ptr<Material> material;
            MaterialPropertyBlock properties;
        };

    public:
        InkPass(const Settings& settings)
        {
            m_Settings = &settings;
            renderPassEvent = settings.renderPassEvent;
        }

        void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) override
        {
            UniversalResourceData& resourceData = frameData.Get<UniversalResourceData>();
            UniversalCameraData& cameraData = frameData.Get<UniversalCameraData>();
            UniversalRenderingData& renderingData = frameData.Get<UniversalRenderingData>();

            RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
            descriptor.msaaSamples = 1;
            descriptor.depthBufferBits = 0;
            descriptor.graphicsFormat = GraphicsFormat::A2B10G10R10_UNormPack32;
            TextureHandle normals = UniversalRenderer::CreateRenderGraphTexture(
                renderGraph, descriptor, "_InkNormals", true);
            descriptor.graphicsFormat = GraphicsFormat::R8_UNorm;
            TextureHandle ids = UniversalRenderer::CreateRenderGraphTexture(renderGraph, descriptor,
                                                                            "_InkIds", true);
            descriptor.graphicsFormat = GraphicsFormat::None;
            descriptor.SetDepthStencilFormat(GraphicsFormat::D32_SFloat_S8_UInt);
            TextureHandle depth = UniversalRenderer::CreateRenderGraphTexture(
                renderGraph, descriptor, "_InkDepth", true);

            {
                SurfaceData* passData = nullptr;
                auto builder =
                    renderGraph.AddRasterRenderPass<SurfaceData>("Ink Surfaces", passData);
                RendererListDesc desc(ShaderTagId("UniversalForward"), renderingData.cullResults(),
                                      *cameraData.camera);
                desc.sortingCriteria = cameraData.defaultOpaqueSortFlags;
                desc.renderQueueRange = RenderQueueRange::opaque;
                desc.layerMask = m_Settings->layerMask;
                desc.overrideMaterial = m_Settings->material;
                desc.overrideMaterialPassIndex = k_SurfacePass;
                passData->objects = renderGraph.CreateRendererList(desc);
                builder.UseRendererList(passData->objects);
                builder.SetRenderAttachment(normals, 0);
                builder.SetRenderAttachment(ids, 1);
                builder.SetRenderAttachmentDepth(depth, AccessFlags::ReadWrite);
                builder.SetRenderFunc([](SurfaceData& data, RasterGraphContext& context)
                                      { context.cmd.DrawRendererList(data.objects); });
            }

            m_Properties.SetVector("_InkSize", Vector4(descriptor.width, descriptor.height, 0, 0));
            m_Properties.SetColor("_InkColor", m_Settings->color);
            m_Properties.SetFloat("_InkCosine", Mathf::Cos(m_Settings->angle * Mathf::Deg2Rad));

            {
                InkData* passData = nullptr;
                auto builder = renderGraph.AddRasterRenderPass<InkData>("Ink Lines", passData);
                passData->normals = normals;
                passData->ids = ids;
                passData->material = m_Settings->material;
                passData->properties = m_Properties;
                builder.UseTexture(normals);
                builder.UseTexture(ids);
                builder.SetRenderAttachment(resourceData.activeColorTexture(), 0);
                builder.SetRenderFunc(
                    [](InkData& data, RasterGraphContext& context)
                    {
                        data.properties.SetTexture(s_Normals, data.normals);
                        data.properties.SetTexture(s_Ids, data.ids);
                        CoreUtils::DrawFullScreen(context.cmd, data.material, data.properties,
                                                  k_InkPass);
                    });
            }
        }
    };

public:
    Settings settings = Settings();

private:
    std::unique_ptr<InkPass> m_InkPass;

public:
    void Create() override { m_InkPass = std::make_unique<InkPass>(settings); }

    void AddRenderPasses(ScriptableRenderer& renderer,
                         [[maybe_unused]] RenderingData& renderingData) override
    {
        if (settings.material == nullptr)
        {
            Debug::LogWarning("Ink Lines: there is no material.");
            return;
        }
        renderer.EnqueuePass(*m_InkPass);
    }

    void Describe(Inspector& inspector) override
    {
        inspector.BeginGroup("settings");
        inspector.Field("renderPassEvent", settings.renderPassEvent,
                        "The event at which it is drawn");
        inspector.Field("layerMask", settings.layerMask,
                        "The layers of the objects that have lines");
        inspector.Field("material", settings.material, "Draws surfaces, then lines");
        inspector.Field("color", settings.color, "The colour in sRGB; its alpha is the opacity");
        inspector.Field("angle", settings.angle, {1.0f, 90.0f},
                        "The angle between two normals, in degrees, from which on there is a line");
        inspector.EndGroup();
    }
};

} // namespace porting
