using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// As one wrote it for URP 10: two targets and a depth of its own by ConfigureTarget, then the
// full-screen mesh with a property block.
public class InkLinesFeature : ScriptableRendererFeature
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
        const int k_InkPass = 1;
        static readonly int s_Normals = Shader.PropertyToID("_InkNormals");
        static readonly int s_Ids = Shader.PropertyToID("_InkIds");
        static readonly int s_Depth = Shader.PropertyToID("_InkDepth");
        static readonly ShaderTagId s_ShaderTagId = new ShaderTagId("UniversalForward");

        readonly Settings m_Settings;
        readonly ProfilingSampler m_ProfilingSampler = new ProfilingSampler("Ink Lines");
        readonly MaterialPropertyBlock m_Properties = new MaterialPropertyBlock();
        readonly RenderTargetIdentifier[] m_Targets = new RenderTargetIdentifier[2];
        FilteringSettings m_FilteringSettings;

        public InkPass(Settings settings)
        {
            m_Settings = settings;
            m_FilteringSettings = new FilteringSettings(RenderQueueRange.opaque, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
        }

        public override void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
        {
            RenderTextureDescriptor descriptor = cameraTextureDescriptor;
            descriptor.msaaSamples = 1;
            descriptor.depthBufferBits = 0;
            descriptor.graphicsFormat = GraphicsFormat.A2B10G10R10_UNormPack32;
            cmd.GetTemporaryRT(s_Normals, descriptor, FilterMode.Point);
            descriptor.graphicsFormat = GraphicsFormat.R8_UNorm;
            cmd.GetTemporaryRT(s_Ids, descriptor, FilterMode.Point);
            descriptor.colorFormat = RenderTextureFormat.Depth;
            descriptor.depthBufferBits = 32;
            cmd.GetTemporaryRT(s_Depth, descriptor, FilterMode.Point);

            m_Targets[0] = s_Normals;
            m_Targets[1] = s_Ids;
            ConfigureTarget(m_Targets, s_Depth);
            ConfigureClear(ClearFlag.All, Color.clear);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, m_ProfilingSampler))
            {
                context.ExecuteCommandBuffer(cmd);
                cmd.Clear();

                DrawingSettings drawingSettings = CreateDrawingSettings(s_ShaderTagId, ref renderingData, SortingCriteria.CommonOpaque);
                drawingSettings.overrideMaterial = m_Settings.material;
                drawingSettings.overrideMaterialPassIndex = k_SurfacePass;
                context.DrawRenderers(renderingData.cullResults, ref drawingSettings, ref m_FilteringSettings);

                CameraData cameraData = renderingData.cameraData;
                RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
                m_Properties.SetVector("_InkSize", new Vector4(descriptor.width, descriptor.height, 0, 0));
                m_Properties.SetColor("_InkColor", m_Settings.color);
                m_Properties.SetFloat("_InkCosine", Mathf.Cos(m_Settings.angle * Mathf.Deg2Rad));
                cmd.SetRenderTarget(cameraData.renderer.cameraColorTarget);
                cmd.SetViewProjectionMatrices(Matrix4x4.identity, Matrix4x4.identity);
                cmd.DrawMesh(RenderingUtils.fullscreenMesh, Matrix4x4.identity, m_Settings.material, 0, k_InkPass, m_Properties);
                cmd.SetViewProjectionMatrices(cameraData.GetViewMatrix(), cameraData.GetProjectionMatrix());
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public override void OnCameraCleanup(CommandBuffer cmd)
        {
            cmd.ReleaseTemporaryRT(s_Normals);
            cmd.ReleaseTemporaryRT(s_Ids);
            cmd.ReleaseTemporaryRT(s_Depth);
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
