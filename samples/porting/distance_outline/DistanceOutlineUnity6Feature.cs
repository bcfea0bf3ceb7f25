using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RenderGraphModule.Util;
using UnityEngine.Rendering.Universal;

// As one writes it for Unity 6: a raster pass, a compute pass and a blit.
public class DistanceOutlineUnity6Feature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingTransparents;
        public LayerMask layerMask;
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

        readonly Settings m_Settings;
        readonly Material m_Material;

        class MaskData
        {
            public RendererListHandle objects;
        }

        class DistanceData
        {
            public ComputeShader compute;
            public TextureHandle mask;
            public TextureHandle rows;
            public TextureHandle distance;
            public int width;
            public int height;
            public int reach;
        }

        public OutlinePass(Settings settings)
        {
            m_Settings = settings;
            m_Material = CoreUtils.CreateEngineMaterial(settings.shader);
            m_Material.SetColor("_OutlineColor", settings.color);
            m_Material.SetFloat("_OutlineWidth", settings.width);
            renderPassEvent = settings.renderPassEvent;
        }

        static void MeasureDistances(DistanceData data, ComputeGraphContext context)
        {
            ComputeCommandBuffer cmd = context.cmd;
            int rowsKernel = data.compute.FindKernel("Rows");
            int columnsKernel = data.compute.FindKernel("Columns");
            int groupsX = (data.width + k_GroupSize - 1) / k_GroupSize;
            int groupsY = (data.height + k_GroupSize - 1) / k_GroupSize;
            cmd.SetComputeVectorParam(data.compute, "_Size", new Vector4(data.width, data.height, data.reach, 0));
            cmd.SetComputeTextureParam(data.compute, rowsKernel, "_Mask", data.mask);
            cmd.SetComputeTextureParam(data.compute, rowsKernel, "_Rows", data.rows);
            cmd.DispatchCompute(data.compute, rowsKernel, groupsX, groupsY, 1);
            cmd.SetComputeTextureParam(data.compute, columnsKernel, "_Rows", data.rows);
            cmd.SetComputeTextureParam(data.compute, columnsKernel, "_Distance", data.distance);
            cmd.DispatchCompute(data.compute, columnsKernel, groupsX, groupsY, 1);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            UniversalCameraData cameraData = frameData.Get<UniversalCameraData>();
            UniversalRenderingData renderingData = frameData.Get<UniversalRenderingData>();

            RenderTextureDescriptor descriptor = cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = 1;
            descriptor.graphicsFormat = GraphicsFormat.R8_UNorm;
            TextureHandle mask = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_Mask", true);
            descriptor.enableRandomWrite = true;
            descriptor.graphicsFormat = GraphicsFormat.R32_SFloat;
            TextureHandle rows = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_Rows", false);
            TextureHandle distance = UniversalRenderer.CreateRenderGraphTexture(renderGraph, descriptor, "_Distance", false);

            using (var builder = renderGraph.AddRasterRenderPass<MaskData>("Mask", out var passData))
            {
                RendererListDesc desc = new(new ShaderTagId("UniversalForward"), renderingData.cullResults, cameraData.camera);
                desc.renderQueueRange = RenderQueueRange.all;
                desc.layerMask = m_Settings.layerMask;
                desc.overrideMaterial = m_Material;
                desc.overrideMaterialPassIndex = k_MaskPass;
                passData.objects = renderGraph.CreateRendererList(desc);
                builder.UseRendererList(passData.objects);
                builder.SetRenderAttachment(mask, 0);
                builder.SetRenderFunc((MaskData data, RasterGraphContext context) => context.cmd.DrawRendererList(data.objects));
            }

            using (var builder = renderGraph.AddComputePass<DistanceData>("Distances", out var passData))
            {
                passData.compute = m_Settings.computeShader;
                passData.mask = mask;
                passData.rows = rows;
                passData.distance = distance;
                passData.width = descriptor.width;
                passData.height = descriptor.height;
                passData.reach = m_Settings.width + 1;
                builder.UseTexture(mask, AccessFlags.Read);
                builder.UseTexture(rows, AccessFlags.ReadWrite);
                builder.UseTexture(distance, AccessFlags.Write);
                builder.SetRenderFunc((DistanceData data, ComputeGraphContext context) => MeasureDistances(data, context));
            }

            RenderGraphUtils.BlitMaterialParameters composite = new(distance, resourceData.activeColorTexture, m_Material, k_CompositePass);
            renderGraph.AddBlitPass(composite, "Composite");
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
}
