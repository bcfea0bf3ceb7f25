using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

// As one writes it for Unity 6: a raster pass of two attachments and a depth, then a raster pass with a
// property block that holds its textures.
public class InkLinesUnity6Feature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.BeforeRenderingTransparents;
        public LayerMask layerMask = -1;
        public Material material;
        public Color color = Color.black;
        [Range(1f, 90f)] public float angle = 25f;
    }

    class InkPass : ScriptableRenderPass
    {
        const int k_SurfacePass = 0;
        const int k_InkPass = 2;
        static readonly int s_Normals = Shader.PropertyToID("_InkNormals");
        static readonly int s_Ids = Shader.PropertyToID("_InkIds");

        readonly Settings m_Settings;
        readonly MaterialPropertyBlock m_Properties = new();

        class SurfaceData
        {
            public RendererListHandle objects;
        }

        class InkData
        {
            public TextureHandle normals;
            public TextureHandle ids;
            public Material material;
            public MaterialPropertyBlock properties;
        }

        public InkPass(Settings settings)
        {
            m_Settings = settings;
            renderPassEvent = settings.renderPassEvent;
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            UniversalCameraData cameraData = frameData.Get<UniversalCameraData>();
            UniversalRenderingData renderingData = frameData.Get<UniversalRenderingData>();

            RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
            descriptor.msaaSamples = 1;
            descriptor.depthBufferBits = 0;
            descriptor.graphicsFormat = GraphicsFormat.A2B10G10R10_UNormPack32;
            TextureHandle normals = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_InkNormals", true);
            descriptor.graphicsFormat = GraphicsFormat.R8_UNorm;
            TextureHandle ids = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_InkIds", true);
            descriptor.graphicsFormat = GraphicsFormat.None;
            descriptor.depthStencilFormat = GraphicsFormat.D32_SFloat_S8_UInt;
            TextureHandle depth = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_InkDepth", true);

            using (var builder = renderGraph.AddRasterRenderPass<SurfaceData>("Ink Surfaces", out var passData))
            {
                RendererListDesc desc = new(new ShaderTagId("UniversalForward"), renderingData.cullResults, cameraData.camera);
                desc.sortingCriteria = cameraData.defaultOpaqueSortFlags;
                desc.renderQueueRange = RenderQueueRange.opaque;
                desc.layerMask = m_Settings.layerMask;
                desc.overrideMaterial = m_Settings.material;
                desc.overrideMaterialPassIndex = k_SurfacePass;
                passData.objects = renderGraph.CreateRendererList(desc);
                builder.UseRendererList(passData.objects);
                builder.SetRenderAttachment(normals, 0);
                builder.SetRenderAttachment(ids, 1);
                builder.SetRenderAttachmentDepth(depth, AccessFlags.ReadWrite);
                builder.SetRenderFunc((SurfaceData data, RasterGraphContext context) =>
                {
                    context.cmd.DrawRendererList(data.objects);
                });
            }

            m_Properties.SetVector("_InkSize", new Vector4(descriptor.width, descriptor.height, 0, 0));
            m_Properties.SetColor("_InkColor", m_Settings.color);
            m_Properties.SetFloat("_InkCosine", Mathf.Cos(m_Settings.angle * Mathf.Deg2Rad));

            using (var builder = renderGraph.AddRasterRenderPass<InkData>("Ink Lines", out var passData))
            {
                passData.normals = normals;
                passData.ids = ids;
                passData.material = m_Settings.material;
                passData.properties = m_Properties;
                builder.UseTexture(normals);
                builder.UseTexture(ids);
                builder.SetRenderAttachment(resourceData.activeColorTexture, 0);
                builder.SetRenderFunc((InkData data, RasterGraphContext context) =>
                {
                    data.properties.SetTexture(s_Normals, data.normals);
                    data.properties.SetTexture(s_Ids, data.ids);
                    CoreUtils.DrawFullScreen(context.cmd, data.material, data.properties, k_InkPass);
                });
            }
        }
    }

    public Settings settings = new Settings();
    InkPass m_InkPass;

    public override void Create()
    {
        m_InkPass = new InkPass(settings);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (settings.material == null)
        {
            Debug.LogWarning("Ink Lines: there is no material.");
            return;
        }
        renderer.EnqueuePass(m_InkPass);
    }
}
