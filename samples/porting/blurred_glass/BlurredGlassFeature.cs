using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// As one wrote it for URP 8: temporary textures by name, cmd.Blit, FrameCleanup.
// Blurs what is opaque for the glass in front of it, whose shader reads _GlassBlurTexture.
public class BlurredGlassFeature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingSkybox;
        public Shader blurShader = null;
        [Range(1, 8)] public int iterations = 4;
        [Range(1, 4)] public int downsample = 2;
    }

    class BlurPass : ScriptableRenderPass
    {
        const string k_Tag = "Blurred Glass";
        static readonly int s_Offset = Shader.PropertyToID("_Offset");
        static readonly int s_Blurred = Shader.PropertyToID("_GlassBlurTexture");

        readonly Settings m_Settings;
        readonly Material m_Material;
        RenderTargetIdentifier m_Source;
        RenderTargetHandle m_Ping;
        RenderTargetHandle m_Pong;

        public BlurPass(Settings settings)
        {
            m_Settings = settings;
            m_Material = CoreUtils.CreateEngineMaterial(settings.blurShader);
            renderPassEvent = settings.renderPassEvent;
            m_Ping.Init("_GlassPing");
            m_Pong.Init("_GlassPong");
        }

        public void Setup(RenderTargetIdentifier source)
        {
            m_Source = source;
        }

        public override void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
        {
            RenderTextureDescriptor descriptor = cameraTextureDescriptor;
            descriptor.width = Mathf.Max(1, descriptor.width / m_Settings.downsample);
            descriptor.height = Mathf.Max(1, descriptor.height / m_Settings.downsample);
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            cmd.GetTemporaryRT(m_Ping.id, descriptor, FilterMode.Bilinear);
            cmd.GetTemporaryRT(m_Pong.id, descriptor, FilterMode.Bilinear);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get(k_Tag);
            cmd.SetGlobalFloat(s_Offset, 0.5f);
            cmd.Blit(m_Source, m_Ping.Identifier(), m_Material, 0);
            for (int i = 1; i < m_Settings.iterations; i++)
            {
                cmd.SetGlobalFloat(s_Offset, 0.5f + i);
                cmd.Blit(m_Ping.Identifier(), m_Pong.Identifier(), m_Material, 0);
                CoreUtils.Swap(ref m_Ping, ref m_Pong);
            }
            cmd.SetGlobalTexture(s_Blurred, m_Ping.Identifier());
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public override void FrameCleanup(CommandBuffer cmd)
        {
            cmd.ReleaseTemporaryRT(m_Ping.id);
            cmd.ReleaseTemporaryRT(m_Pong.id);
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
        m_BlurPass.Setup(renderer.cameraColorTarget);
        renderer.EnqueuePass(m_BlurPass);
    }
}
