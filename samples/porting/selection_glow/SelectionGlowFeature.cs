using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

public static class SelectionGlow
{
    public const int k_MarkPass = 0;
    public const int k_MaskPass = 1;
    static readonly int s_Direction = Shader.PropertyToID("_GlowDirection");

    public static Material CreateMaterial(Color color, float radius, int stencilReference)
    {
        Material material = CoreUtils.CreateEngineMaterial(Shader.Find("Hidden/Porting/SelectionGlow"));
        material.SetColor("_GlowColor", color);
        material.SetFloat("_GlowDeviation", Mathf.Max(0.5f, radius / 2.5f));
        material.SetInt("_StencilReference", stencilReference);
        return material;
    }

    public static void SetDirection(CommandBuffer cmd, float x, float y)
    {
        cmd.SetGlobalVector(s_Direction, new Vector4(x, y, 0f, 0f));
    }
}

// As one wrote it for URP 7: the shader by its name, textures of one channel, cmd.Blit there and back,
// and the stencil that comes with the camera's colour.
public class SelectionGlowFeature : ScriptableRendererFeature
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
        const string k_Tag = "Selection Glow";
        const int k_BlurPass = 2;
        const int k_CompositePass = 3;

        readonly Material m_Material;
        FilteringSettings m_FilteringSettings;
        RenderTargetHandle m_Mask;
        RenderTargetHandle m_Blurred;
        RenderTargetIdentifier m_Target;

        public GlowPass(Settings settings)
        {
            m_Material = SelectionGlow.CreateMaterial(settings.color, settings.radius, settings.stencilReference);
            m_FilteringSettings = new FilteringSettings(RenderQueueRange.opaque, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
            m_Mask.Init("_GlowMask");
            m_Blurred.Init("_GlowBlurred");
        }

        public void Setup(RenderTargetIdentifier target)
        {
            m_Target = target;
        }

        public override void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
        {
            RenderTextureDescriptor descriptor = cameraTextureDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.colorFormat = RenderTextureFormat.R8;
            cmd.GetTemporaryRT(m_Mask.id, descriptor, FilterMode.Point);
            descriptor.colorFormat = RenderTextureFormat.RHalf;
            cmd.GetTemporaryRT(m_Blurred.id, descriptor, FilterMode.Point);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            DrawingSettings drawingSettings = CreateDrawingSettings(new ShaderTagId("UniversalForward"), ref renderingData, SortingCriteria.CommonOpaque);
            drawingSettings.overrideMaterial = m_Material;
            drawingSettings.overrideMaterialPassIndex = SelectionGlow.k_MarkPass;
            context.DrawRenderers(renderingData.cullResults, ref drawingSettings, ref m_FilteringSettings);

            CommandBuffer cmd = CommandBufferPool.Get(k_Tag);
            cmd.SetRenderTarget(m_Mask.Identifier());
            cmd.ClearRenderTarget(false, true, Color.clear);
            context.ExecuteCommandBuffer(cmd);
            cmd.Clear();
            drawingSettings.overrideMaterialPassIndex = SelectionGlow.k_MaskPass;
            context.DrawRenderers(renderingData.cullResults, ref drawingSettings, ref m_FilteringSettings);

            SelectionGlow.SetDirection(cmd, 1f, 0f);
            cmd.Blit(m_Mask.Identifier(), m_Blurred.Identifier(), m_Material, k_BlurPass);
            SelectionGlow.SetDirection(cmd, 0f, 1f);
            cmd.Blit(m_Blurred.Identifier(), m_Mask.Identifier(), m_Material, k_BlurPass);
            cmd.Blit(m_Mask.Identifier(), m_Target, m_Material, k_CompositePass);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public override void FrameCleanup(CommandBuffer cmd)
        {
            cmd.ReleaseTemporaryRT(m_Mask.id);
            cmd.ReleaseTemporaryRT(m_Blurred.id);
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
        m_GlowPass.Setup(renderer.cameraColorTarget);
        renderer.EnqueuePass(m_GlowPass);
    }
}
