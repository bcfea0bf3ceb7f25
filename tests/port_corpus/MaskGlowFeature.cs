using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 10: ConfigureTarget of an identifier, DrawRenderers with an override material, settings shared.
public class MaskGlowFeature : ScriptableRendererFeature
{
    public enum QueueType { Opaque, Transparent }

    [System.Serializable]
    public class FilterSettings
    {
        public QueueType RenderQueueType = QueueType.Opaque;
        public LayerMask LayerMask = 0;
        public string[] PassNames = { "UniversalForward", "SRPDefaultUnlit" };
    }

    [System.Serializable]
    public class MaskGlowSettings
    {
        public string passTag = "MaskGlowFeature";
        public RenderPassEvent Event = RenderPassEvent.AfterRenderingOpaques;
        public FilterSettings filterSettings = new FilterSettings();
        [ColorUsage(true, true)] public Color glowColor = new Color(1, .5f, 0);
        public Material overrideMaterial = null;
        public int overrideMaterialPassIndex = 0;
    }

    public MaskGlowSettings settings = new MaskGlowSettings();
    MaskPass maskPass;
    GlowPass glowPass;

    public override void Create()
    {
        FilterSettings filter = settings.filterSettings;
        maskPass = new MaskPass(settings, filter.PassNames);
        glowPass = new GlowPass(settings);
        glowPass.renderPassEvent = RenderPassEvent.AfterRenderingTransparents + 1;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(maskPass);
        glowPass.Setup(renderer);
        renderer.EnqueuePass(glowPass);
    }

    class MaskPass : ScriptableRenderPass
    {
        private MaskGlowSettings settings;
        private FilteringSettings m_FilteringSettings;
        private readonly List<ShaderTagId> m_ShaderTagIdList = new List<ShaderTagId>();
        private readonly RenderTargetHandle maskTexture;
        private ProfilingSampler m_ProfilingSampler = new ProfilingSampler("Mask");

        public MaskPass(MaskGlowSettings settings, string[] shaderTags)
        {
            this.settings = settings;
            this.renderPassEvent = settings.Event;
            maskTexture.Init("_MaskTexture");
            RenderQueueRange range = settings.filterSettings.RenderQueueType == QueueType.Transparent
                ? RenderQueueRange.transparent
                : RenderQueueRange.opaque;
            m_FilteringSettings = new FilteringSettings(range, settings.filterSettings.LayerMask);
            foreach (var passName in shaderTags)
                m_ShaderTagIdList.Add(new ShaderTagId(passName));
        }

        public override void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
        {
            var desc = cameraTextureDescriptor;
            desc.graphicsFormat = GraphicsFormat.R8_UNorm;
            cmd.GetTemporaryRT(maskTexture.id, desc, FilterMode.Point);
            ConfigureTarget(maskTexture.Identifier());
            ConfigureClear(ClearFlag.All, Color.clear);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var sortFlags = renderingData.cameraData.defaultOpaqueSortFlags;
            var drawSettings = CreateDrawingSettings(m_ShaderTagIdList, ref renderingData, sortFlags);
            drawSettings.overrideMaterial = settings.overrideMaterial;
            drawSettings.overrideMaterialPassIndex = settings.overrideMaterialPassIndex;
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, m_ProfilingSampler))
            {
                context.ExecuteCommandBuffer(cmd);
                cmd.Clear();
                context.DrawRenderers(renderingData.cullResults, ref drawSettings, ref m_FilteringSettings);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public override void OnCameraCleanup(CommandBuffer cmd) => cmd.ReleaseTemporaryRT(maskTexture.id);
    }

    class GlowPass : ScriptableRenderPass
    {
        MaskGlowSettings settings;
        ScriptableRenderer renderer;

        public GlowPass(MaskGlowSettings s) { settings = s; }

        public void Setup(ScriptableRenderer renderer) { this.renderer = renderer; }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get(settings.passTag);
            cmd.SetGlobalColor("_GlowColor", settings.glowColor);
            Blit(cmd, renderer.cameraColorTarget, renderer.cameraColorTarget, settings.overrideMaterial);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
    }
}
