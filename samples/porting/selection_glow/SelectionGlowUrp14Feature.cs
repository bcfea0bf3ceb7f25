using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// As one writes it for URP 14: RTHandles, renderer lists, Blitter, and the targets bound by hand.
public class SelectionGlowUrp14Feature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingTransparents;
        public LayerMask layerMask = 0;
        public Color color = new Color(0.3f, 0.8f, 1f, 1f);
        [Range(1f, 24f)] public float radius = 8f;
        [Range(1, 255)] public int stencilReference = 2;
    }

    class GlowPass : ScriptableRenderPass
    {
        const int k_BlurPass = 4;
        const int k_CompositePass = 5;

        readonly Material m_Material;
        FilteringSettings m_FilteringSettings;
        RTHandle m_Mask;
        RTHandle m_Blurred;

        public GlowPass(Settings settings)
        {
            m_Material = SelectionGlow.CreateMaterial(settings.color, settings.radius, settings.stencilReference);
            m_FilteringSettings = new FilteringSettings(RenderQueueRange.opaque, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
            profilingSampler = new ProfilingSampler("Selection Glow");
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.graphicsFormat = GraphicsFormat.R8_UNorm;
            RenderingUtils.ReAllocateIfNeeded(ref m_Mask, descriptor, FilterMode.Point, TextureWrapMode.Clamp, name: "_GlowMask");
            descriptor.graphicsFormat = GraphicsFormat.R16_SFloat;
            RenderingUtils.ReAllocateIfNeeded(ref m_Blurred, descriptor, FilterMode.Point, TextureWrapMode.Clamp, name: "_GlowBlurred");
        }

        RendererList CreateList(ScriptableRenderContext context, ref RenderingData renderingData, int pass)
        {
            DrawingSettings drawingSettings = CreateDrawingSettings(new ShaderTagId("UniversalForward"), ref renderingData, SortingCriteria.CommonOpaque);
            drawingSettings.overrideMaterial = m_Material;
            drawingSettings.overrideMaterialPassIndex = pass;
            RendererListParams parameters = new RendererListParams(renderingData.cullResults, drawingSettings, m_FilteringSettings);
            return context.CreateRendererList(ref parameters);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            RTHandle color = renderingData.cameraData.renderer.cameraColorTargetHandle;
            RTHandle depth = renderingData.cameraData.renderer.cameraDepthTargetHandle;
            RendererList marked = CreateList(context, ref renderingData, SelectionGlow.k_MarkPass);
            RendererList masked = CreateList(context, ref renderingData, SelectionGlow.k_MaskPass);

            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, profilingSampler))
            {
                CoreUtils.SetRenderTarget(cmd, color, depth);
                cmd.DrawRendererList(marked);
                CoreUtils.SetRenderTarget(cmd, m_Mask, ClearFlag.Color, Color.clear);
                cmd.DrawRendererList(masked);

                SelectionGlow.SetDirection(cmd, 1f, 0f);
                Blitter.BlitCameraTexture(cmd, m_Mask, m_Blurred, m_Material, k_BlurPass);
                SelectionGlow.SetDirection(cmd, 0f, 1f);
                Blitter.BlitCameraTexture(cmd, m_Blurred, m_Mask, m_Material, k_BlurPass);
                CoreUtils.SetRenderTarget(cmd, color, depth);
                Blitter.BlitTexture(cmd, m_Mask, new Vector4(1f, 1f, 0f, 0f), m_Material, k_CompositePass);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public void Dispose()
        {
            m_Mask?.Release();
            m_Blurred?.Release();
        }
    }

    public Settings settings = new Settings();
    GlowPass m_GlowPass;

    public override void Create()
    {
        m_GlowPass = new GlowPass(settings);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_GlowPass);
    }

    protected override void Dispose(bool disposing)
    {
        m_GlowPass.Dispose();
    }
}
