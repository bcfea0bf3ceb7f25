#pragma once

#include "DistanceOutlineFeature.h"

#include <limn/core/UniversalFrameData.h>
#include <limn/core/UniversalRenderer.h>

namespace porting
{

// DistanceOutlineUnity6Feature.cs, line by line.
class DistanceOutlineUnity6Feature final : public ScriptableRendererFeature
{
public:
    struct Settings
    {
        RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
        LayerMask layerMask;
        std::shared_ptr<const Shader> shader;
        Shared<ComputeShader> computeShader;
        Color color = Color::white;
        int width = 6;
    };

private:
    class OutlinePass final : public ScriptableRenderPass
    {
        static constexpr int k_MaskPass = 0;
        static constexpr int k_CompositePass = 1;
        static constexpr int k_GroupSize = 8;

        const Settings* m_Settings;
        std::shared_ptr<Material> m_Material;

        struct MaskData
        {
            RendererListHandle objects;
        };

        struct DistanceData
        {
            Shared<ComputeShader> compute;
            TextureHandle mask;
            TextureHandle rows;
            TextureHandle distance;
            int width;
            int height;
            int reach;
        };

    public:
        OutlinePass(const Settings& settings)
        {
            m_Settings = &settings;
            m_Material = CoreUtils::CreateEngineMaterial(settings.shader);
            m_Material->SetColor("_OutlineColor", settings.color);
            m_Material->SetFloat("_OutlineWidth", settings.width);
            renderPassEvent = settings.renderPassEvent;
        }

        static void MeasureDistances(DistanceData& data, ComputeGraphContext& context)
        {
            ComputeCommandBuffer& cmd = context.cmd;
            int rowsKernel = data.compute->FindKernel("Rows");
            int columnsKernel = data.compute->FindKernel("Columns");
            int groupsX = (data.width + k_GroupSize - 1) / k_GroupSize;
            int groupsY = (data.height + k_GroupSize - 1) / k_GroupSize;
            cmd.SetComputeVectorParam(data.compute, "_Size",
                                      Vector4(data.width, data.height, data.reach, 0));
            cmd.SetComputeTextureParam(data.compute, rowsKernel, "_Mask", data.mask);
            cmd.SetComputeTextureParam(data.compute, rowsKernel, "_Rows", data.rows);
            cmd.DispatchCompute(data.compute, rowsKernel, groupsX, groupsY, 1);
            cmd.SetComputeTextureParam(data.compute, columnsKernel, "_Rows", data.rows);
            cmd.SetComputeTextureParam(data.compute, columnsKernel, "_Distance", data.distance);
            cmd.DispatchCompute(data.compute, columnsKernel, groupsX, groupsY, 1);
        }

        void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) override
        {
            UniversalResourceData& resourceData = frameData.Get<UniversalResourceData>();
            UniversalCameraData& cameraData = frameData.Get<UniversalCameraData>();
            UniversalRenderingData& renderingData = frameData.Get<UniversalRenderingData>();

            RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.graphicsFormat = GraphicsFormat::R8_UNorm;
            TextureHandle mask =
                UniversalRenderer::CreateRenderGraphTexture(renderGraph, descriptor, "_Mask", true);
            descriptor.enableRandomWrite = true;
            descriptor.graphicsFormat = GraphicsFormat::R32_SFloat;
            TextureHandle rows = UniversalRenderer::CreateRenderGraphTexture(
                renderGraph, descriptor, "_Rows", false);
            TextureHandle distance = UniversalRenderer::CreateRenderGraphTexture(
                renderGraph, descriptor, "_Distance", false);

            {
                MaskData* passData = nullptr;
                auto builder = renderGraph.AddRasterRenderPass<MaskData>("Mask", passData);
                RendererListDesc desc(ShaderTagId("UniversalForward"), renderingData.cullResults(),
                                      *cameraData.camera);
                desc.renderQueueRange = RenderQueueRange::all;
                desc.layerMask = m_Settings->layerMask;
                desc.overrideMaterial = m_Material;
                desc.overrideMaterialPassIndex = k_MaskPass;
                passData->objects = renderGraph.CreateRendererList(desc);
                builder.UseRendererList(passData->objects);
                builder.SetRenderAttachment(mask, 0);
                builder.SetRenderFunc([](MaskData& data, RasterGraphContext& context)
                                      { context.cmd.DrawRendererList(data.objects); });
            }

            {
                DistanceData* passData = nullptr;
                auto builder = renderGraph.AddComputePass<DistanceData>("Distances", passData);
                passData->compute = m_Settings->computeShader;
                passData->mask = mask;
                passData->rows = rows;
                passData->distance = distance;
                passData->width = descriptor.width;
                passData->height = descriptor.height;
                passData->reach = m_Settings->width + 1;
                builder.UseTexture(mask, AccessFlags::Read);
                builder.UseTexture(rows, AccessFlags::ReadWrite);
                builder.UseTexture(distance, AccessFlags::Write);
                builder.SetRenderFunc([](DistanceData& data, ComputeGraphContext& context)
                                      { MeasureDistances(data, context); });
            }

            RenderGraphUtils::BlitMaterialParameters composite(
                distance, resourceData.activeColorTexture(), m_Material, k_CompositePass);
            renderGraph.AddBlitPass(composite, "Composite");
        }
    };

public:
    Settings settings = Settings();

private:
    std::unique_ptr<OutlinePass> m_Pass;

public:
    void Create() override { m_Pass = std::make_unique<OutlinePass>(settings); }

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
                        "The layers of the objects that are outlined");
        inspector.Field("shader", settings.shader, "Draws the outline from the distances");
        inspector.Field("computeShader", settings.computeShader,
                        "Measures the distances to the objects");
        inspector.Field("color", settings.color, "The colour in sRGB; its alpha is the opacity");
        inspector.Field("width", settings.width, {1, 32}, "Texels");
        inspector.EndGroup();
    }
};

} // namespace porting
