using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// As one wrote it for URP 14: RTHandles, a compute shader, Blitter.
// An outline of even width around the objects of a layer: exact distances to what they cover, by two
// kernels, first along rows and then along columns.
public class DistanceOutlineFeature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingTransparents;
        public LayerMask layerMask = 0;
        public Shader shader;
        public ComputeShader computeShader;
        public Color color = Color.white;
        [Range(1, 32)] public int width = 6;
    }

    class OutlinePass : ScriptableRenderPass
    {
        const int k_MaskPass = 0;
        const int k_CompositePass = 1;
        const int k_GroupSize = 8;
        static readonly int s_Mask = Shader.PropertyToID("_Mask");
        static readonly int s_Rows = Shader.PropertyToID("_Rows");
        static readonly int s_Distance = Shader.PropertyToID("_Distance");
        static readonly int s_Size = Shader.PropertyToID("_Size");

        readonly Settings m_Settings;
        readonly Material m_Material;
        readonly int m_RowsKernel;
        readonly int m_ColumnsKernel;
        FilteringSettings m_FilteringSettings;
        RTHandle m_Mask;
        RTHandle m_Rows;
        RTHandle m_Distance;

        public OutlinePass(Settings settings)
        {
            m_Settings = settings;
            m_Material = CoreUtils.CreateEngineMaterial(settings.shader);
            m_Material.SetColor("_OutlineColor", settings.color);
            m_Material.SetFloat("_OutlineWidth", settings.width);
            m_RowsKernel = settings.computeShader.FindKernel("Rows");
            m_ColumnsKernel = settings.computeShader.FindKernel("Columns");
            m_FilteringSettings = new FilteringSettings(RenderQueueRange.all, settings.layerMask);
            renderPassEvent = settings.renderPassEvent;
            profilingSampler = new ProfilingSampler("Distance Outline");
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.graphicsFormat = GraphicsFormat.R8_UNorm;
            RenderingUtils.ReAllocateIfNeeded(ref m_Mask, descriptor, FilterMode.Point, TextureWrapMode.Clamp, name: "_Mask");
            descriptor.enableRandomWrite = true;
            descriptor.graphicsFormat = GraphicsFormat.R32_SFloat;
            RenderingUtils.ReAllocateIfNeeded(ref m_Rows, descriptor, FilterMode.Point, TextureWrapMode.Clamp, name: "_Rows");
            RenderingUtils.ReAllocateIfNeeded(ref m_Distance, descriptor, FilterMode.Point, TextureWrapMode.Clamp, name: "_Distance");
            ConfigureTarget(m_Mask);
            ConfigureClear(ClearFlag.Color, Color.clear);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, profilingSampler))
            {
                DrawingSettings drawingSettings = CreateDrawingSettings(new ShaderTagId("UniversalForward"), ref renderingData, SortingCriteria.None);
                drawingSettings.overrideMaterial = m_Material;
                drawingSettings.overrideMaterialPassIndex = k_MaskPass;
                context.DrawRenderers(renderingData.cullResults, ref drawingSettings, ref m_FilteringSettings);

                ComputeShader compute = m_Settings.computeShader;
                int groupsX = (m_Mask.rt.width + k_GroupSize - 1) / k_GroupSize;
                int groupsY = (m_Mask.rt.height + k_GroupSize - 1) / k_GroupSize;
                cmd.SetComputeVectorParam(compute, s_Size, new Vector4(m_Mask.rt.width, m_Mask.rt.height, m_Settings.width + 1, 0));
                cmd.SetComputeTextureParam(compute, m_RowsKernel, s_Mask, m_Mask);
                cmd.SetComputeTextureParam(compute, m_RowsKernel, s_Rows, m_Rows);
                cmd.DispatchCompute(compute, m_RowsKernel, groupsX, groupsY, 1);
                cmd.SetComputeTextureParam(compute, m_ColumnsKernel, s_Rows, m_Rows);
                cmd.SetComputeTextureParam(compute, m_ColumnsKernel, s_Distance, m_Distance);
                cmd.DispatchCompute(compute, m_ColumnsKernel, groupsX, groupsY, 1);

                Blitter.BlitCameraTexture(cmd, m_Distance, renderingData.cameraData.renderer.cameraColorTargetHandle, m_Material, k_CompositePass);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public void Dispose()
        {
            m_Mask?.Release();
            m_Rows?.Release();
            m_Distance?.Release();
        }
    }

    public Settings settings = new Settings();
    OutlinePass m_Pass;

    public override void Create()
    {
        m_Pass = new OutlinePass(settings);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_Pass);
    }

    protected override void Dispose(bool disposing)
    {
        m_Pass.Dispose();
    }
}
