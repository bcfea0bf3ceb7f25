using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

// Unity 6: raster passes that hand a texture on in a ContextItem.
public class SilhouetteFeature : ScriptableRendererFeature
{
    public class SilhouetteData : ContextItem
    {
        public TextureHandle mask;
        public TextureHandle blurred = TextureHandle.nullHandle;
        public int width;

        public override void Reset()
        {
            mask = TextureHandle.nullHandle;
            blurred = TextureHandle.nullHandle;
            width = 0;
        }

        public bool IsValid() { return mask.IsValid() && width > 0; }
    }

    [SerializeField] LayerMask m_LayerMask;
    [SerializeField] Material m_MaskMaterial;
    [SerializeField] Material m_ComposeMaterial;

    MaskPass m_Mask;
    ComposePass m_Compose;

    public override void Create()
    {
        m_Mask = new MaskPass(m_LayerMask, m_MaskMaterial) { renderPassEvent = RenderPassEvent.AfterRenderingOpaques };
        m_Compose = new ComposePass(m_ComposeMaterial) { renderPassEvent = RenderPassEvent.AfterRenderingTransparents };
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_Mask);
        renderer.EnqueuePass(m_Compose);
    }

    class MaskPass : ScriptableRenderPass
    {
        class PassData
        {
            internal RendererListHandle rendererList;
        }

        readonly List<ShaderTagId> m_Tags = new() { new("UniversalForward"), new("SRPDefaultUnlit") };
        LayerMask m_Layers;
        Material m_Material;

        public MaskPass(LayerMask layers, Material material)
        {
            m_Layers = layers;
            m_Material = material;
        }

        void InitRendererList(ContextContainer frameData, ref PassData passData, RenderGraph renderGraph)
        {
            var renderingData = frameData.Get<UniversalRenderingData>();
            var cameraData = frameData.Get<UniversalCameraData>();
            var lightData = frameData.Get<UniversalLightData>();
            var filter = new FilteringSettings(RenderQueueRange.opaque, m_Layers);
            var drawing = RenderingUtils.CreateDrawingSettings(m_Tags, renderingData, cameraData, lightData, cameraData.defaultOpaqueSortFlags);
            drawing.overrideMaterial = m_Material;
            passData.rendererList = renderGraph.CreateRendererList(new RendererListParams(renderingData.cullResults, drawing, filter));
        }

        static void ExecutePass(PassData data, RasterGraphContext context)
        {
            context.cmd.ClearRenderTarget(RTClearFlags.Color, Color.clear, 1, 0);
            context.cmd.DrawRendererList(data.rendererList);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameContext)
        {
            using (var builder = renderGraph.AddRasterRenderPass<PassData>("Silhouette Mask", out var passData))
            {
                var resourceData = frameContext.Get<UniversalResourceData>();
                var desc = resourceData.activeColorTexture.GetDescriptor(renderGraph);
                desc.name = "_SilhouetteMask";
                desc.format = GraphicsFormat.R8_UNorm;
                desc.msaaSamples = MSAASamples.None;
                var own = frameContext.Create<SilhouetteData>();
                own.mask = renderGraph.CreateTexture(desc);
                own.width = desc.width;
                InitRendererList(frameContext, ref passData, renderGraph);
                builder.UseRendererList(passData.rendererList);
                builder.SetRenderAttachment(own.mask, 0);
                builder.SetRenderAttachmentDepth(resourceData.activeDepthTexture, AccessFlags.Read);
                builder.SetRenderFunc((PassData data, RasterGraphContext context) => ExecutePass(data, context));
            }
        }
    }

    class ComposePass : ScriptableRenderPass
    {
        class ComposeData
        {
            public TextureHandle mask;
            public Material material;
        }

        Material m_Material;

        public ComposePass(Material material) => m_Material = material;

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            if (!frameData.Contains<SilhouetteData>()) return;
            var own = frameData.Get<SilhouetteData>();
            var resources = frameData.Get<UniversalResourceData>();
            using var builder = renderGraph.AddRasterRenderPass<ComposeData>("Silhouette Compose", out var passData, profilingSampler);
            passData.mask = own.mask;
            passData.material = m_Material;
            builder.UseTexture(own.mask, AccessFlags.Read);
            builder.SetRenderAttachment(resources.activeColorTexture, 0, AccessFlags.Write);
            builder.AllowPassCulling(false);
            builder.SetRenderFunc<ComposeData>(static (data, context) =>
            {
                Blitter.BlitTexture(context.cmd, data.mask, new Vector4(1, 1, 0, 0), data.material, 0);
            });
        }
    }
}
