using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

// Unity 6: an unsafe pass with the old command buffer in it, and the old Execute beside it.
public class ChromaFeature : ScriptableRendererFeature
{
    [SerializeField] private Shader m_Shader;
    [SerializeField] private ChromaSettings m_Settings = new();
    private Material m_Material;
    private ChromaPass m_ChromaPass;

    [System.Serializable]
    public class ChromaSettings
    {
        public float offset = 2;
        [Range(0, 6)] public int downsample = 1;
    }

    public override void Create()
    {
        if (m_Shader == null) return;
        m_Material = new Material(m_Shader);
        m_ChromaPass = new ChromaPass(m_Material, m_Settings);
        m_ChromaPass.renderPassEvent = RenderPassEvent.AfterRenderingSkybox;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (m_ChromaPass == null) return;
        if (renderingData.cameraData.cameraType == CameraType.Game) renderer.EnqueuePass(m_ChromaPass);
    }

    protected override void Dispose(bool disposing)
    {
        if (Application.isPlaying) Destroy(m_Material);
        else DestroyImmediate(m_Material);
    }

    public class ChromaPass : ScriptableRenderPass
    {
        private static readonly int offsetId = Shader.PropertyToID("_Offset");
        private Material material;
        private ChromaSettings defaultSettings;
        private RTHandle m_Half;

        private class PassData
        {
            public TextureHandle source, half;
            public Material material;
            public ChromaSettings settings;
        }

        public ChromaPass(Material material, ChromaSettings defaultSettings)
        {
            this.material = material;
            this.defaultSettings = defaultSettings;
        }

        static void ExecutePass(PassData data, UnsafeGraphContext context)
        {
            CommandBuffer unsafeCmd = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
            data.material.SetFloat(offsetId, data.settings.offset);
            context.cmd.SetRenderTarget(data.half);
            Blitter.BlitTexture(unsafeCmd, data.source, new Vector4(1, 1, 0, 0), data.material, 0);
            context.cmd.SetRenderTarget(data.source);
            Blitter.BlitTexture(unsafeCmd, data.half, new Vector4(1, 1, 0, 0), 0, true);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            const string passName = "Chroma";
            using (var builder = renderGraph.AddUnsafePass<PassData>("Chroma", out var passData))
            {
                UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
                UniversalCameraData cameraData = frameData.Get<UniversalCameraData>();
                RenderTextureDescriptor desc = cameraData.cameraTargetDescriptor;
                desc.msaaSamples = 1;
                desc.depthBufferBits = 0;
                desc.width >>= defaultSettings.downsample;
                desc.height >>= defaultSettings.downsample;
                passData.source = resourceData.activeColorTexture;
                passData.half = UniversalRenderer.CreateRenderGraphTexture(renderGraph, desc, "_ChromaHalf", false);
                passData.material = material;
                passData.settings = defaultSettings;
                builder.UseTexture(passData.source, AccessFlags.ReadWrite);
                builder.UseTexture(passData.half, AccessFlags.ReadWrite);
                builder.AllowPassCulling(false);
                builder.SetRenderFunc((PassData data, UnsafeGraphContext context) => ExecutePass(data, context));
            }
        }

        [System.Obsolete("This rendering path is for compatibility mode only.", false)]
        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var cmd = CommandBufferPool.Get("Chroma");
            Blitter.BlitCameraTexture(cmd, renderingData.cameraData.renderer.cameraColorTargetHandle, m_Half, material, 0);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
    }
}
