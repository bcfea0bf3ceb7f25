using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RenderGraphModule.Util;
using UnityEngine.Rendering.Universal;

// A glow as of Unity 6: a raster pass, an unsafe pass, a blit. Written for limn's tests.
public class EdgeGlowFeature : ScriptableRendererFeature
{
    [System.Serializable]
    public struct Settings
    {
        public float width;
        public RenderPassEvent injection;
    }

    public Settings settings;
    [SerializeField] Shader m_Shader;
    EdgeGlowPass m_Pass;

    public override void Create()
    {
        m_Pass = new EdgeGlowPass(settings)
        {
            renderPassEvent = RenderPassEvent.AfterRenderingOpaques
        };
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_Pass);
    }

    class EdgeGlowPass : ScriptableRenderPass
    {
        class PassData
        {
            public TextureHandle source;
            public RendererListHandle objects;
            public Material material;
            public float width;
        }

        readonly Settings m_Settings;
        Material m_Material;
        static readonly ShaderTagId k_Tag = new("UniversalForward");

        public EdgeGlowPass(Settings settings) { m_Settings = settings; }

        static void ExecutePass(PassData data, RasterGraphContext context)
        {
            context.cmd.ClearRenderTarget(RTClearFlags.Color, Color.clear, 1, 0);
            context.cmd.DrawRendererList(data.objects);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            var cameraData = frameData.Get<UniversalCameraData>();
            var renderingData = frameData.Get<UniversalRenderingData>();
            var lightData = frameData.Get<UniversalLightData>();
            var desc = renderGraph.GetTextureDesc(resourceData.activeColorTexture);
            desc.name = "_Glow";
            desc.clearBuffer = false;
            TextureHandle glow = renderGraph.CreateTexture(desc);
            var drawing = RenderingUtils.CreateDrawingSettings(k_Tag, renderingData, cameraData, lightData, SortingCriteria.CommonOpaque);
            var filtering = new FilteringSettings(RenderQueueRange.opaque, ~0);

            using (var builder = renderGraph.AddRasterRenderPass<PassData>("Edge Glow Mask", out var passData))
            {
                passData.objects = renderGraph.CreateRendererList(new RendererListParams(renderingData.cullResults, drawing, filtering));
                passData.width = m_Settings.width;
                builder.UseRendererList(passData.objects);
                builder.SetRenderAttachment(glow, 0);
                builder.SetRenderAttachmentDepth(resourceData.activeDepthTexture, AccessFlags.Read);
                builder.SetRenderFunc((PassData data, RasterGraphContext context) => ExecutePass(data, context));
            }
            using (var builder = renderGraph.AddUnsafePass<PassData>("Edge Glow", out var passData))
            {
                passData.source = glow;
                builder.UseTexture(glow, AccessFlags.ReadWrite);
                builder.AllowPassCulling(false);
                builder.SetRenderFunc(static (data, context) =>
                {
                    CommandBuffer cmd = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
                    Blitter.BlitTexture(cmd, data.source, new Vector4(1, 1, 0, 0), data.material, 0);
                });
            }
            var parameters = new RenderGraphUtils.BlitMaterialParameters(glow, resourceData.activeColorTexture, m_Material, 1);
            renderGraph.AddBlitPass(parameters, passName: "Edge Glow Blit");
        }

        [System.Obsolete]
        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData) { }
    }
}
