using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

// As one writes it for Unity 6: the same chain in one unsafe pass, which sets its targets itself.
public class BlurredGlassUnity6Feature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingSkybox;
        public Shader blurShader;
        [Range(1, 8)] public int iterations = 4;
        [Range(1, 4)] public int downsample = 2;
    }

    class BlurPass : ScriptableRenderPass
    {
        const string k_PassName = "Blurred Glass";
        static readonly int s_Offset = Shader.PropertyToID("_Offset");
        static readonly int s_Blurred = Shader.PropertyToID("_GlassBlurTexture");

        readonly Settings m_Settings;
        readonly Material m_Material;

        class PassData
        {
            public TextureHandle source;
            public TextureHandle ping;
            public TextureHandle pong;
            public Material material;
            public int iterations;
        }

        public BlurPass(Settings settings)
        {
            m_Settings = settings;
            m_Material = CoreUtils.CreateEngineMaterial(settings.blurShader);
            renderPassEvent = settings.renderPassEvent;
        }

        static void ExecutePass(PassData data, UnsafeGraphContext context)
        {
            CommandBuffer cmd = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
            cmd.SetGlobalFloat(s_Offset, 0.5f);
            Blitter.BlitCameraTexture(cmd, data.source, data.ping, data.material, 1);
            for (int i = 1; i < data.iterations; i++)
            {
                cmd.SetGlobalFloat(s_Offset, 0.5f + i);
                TextureHandle from = i % 2 == 1 ? data.ping : data.pong;
                TextureHandle to = i % 2 == 1 ? data.pong : data.ping;
                Blitter.BlitCameraTexture(cmd, from, to, data.material, 1);
            }
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            UniversalCameraData cameraData = frameData.Get<UniversalCameraData>();

            RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
            descriptor.width = Mathf.Max(1, descriptor.width / m_Settings.downsample);
            descriptor.height = Mathf.Max(1, descriptor.height / m_Settings.downsample);
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            TextureHandle ping = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_GlassPing", false, FilterMode.Bilinear);
            TextureHandle pong = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_GlassPong", false, FilterMode.Bilinear);

            using (var builder = renderGraph.AddUnsafePass<PassData>(k_PassName, out var passData))
            {
                passData.source = resourceData.activeColorTexture;
                passData.ping = ping;
                passData.pong = pong;
                passData.material = m_Material;
                passData.iterations = m_Settings.iterations;

                builder.UseTexture(passData.source, AccessFlags.Read);
                builder.UseTexture(passData.ping, AccessFlags.ReadWrite);
                builder.UseTexture(passData.pong, AccessFlags.ReadWrite);
                builder.AllowGlobalStateModification(true);
                builder.SetGlobalTextureAfterPass(m_Settings.iterations % 2 == 1 ? ping : pong, s_Blurred);
                builder.SetRenderFunc((PassData data, UnsafeGraphContext context) => ExecutePass(data, context));
            }
        }
    }

    public Settings settings = new Settings();
    BlurPass m_BlurPass;

    public override void Create()
    {
        m_BlurPass = new BlurPass(settings);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (settings.blurShader == null || renderingData.cameraData.cameraType == CameraType.Preview)
        {
            return;
        }
        renderer.EnqueuePass(m_BlurPass);
    }
}
