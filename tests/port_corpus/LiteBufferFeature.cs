using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 12: two colours and a depth of its own in one pass, formats by hand, a texture for everybody.
public class LiteBufferFeature : ScriptableRendererFeature
{
    class LiteBufferPass : ScriptableRenderPass
    {
        private static readonly int s_AlbedoId = Shader.PropertyToID("_LiteAlbedo"), s_NormalsId = Shader.PropertyToID("_LiteNormals");
        private readonly int m_DepthId;
        private readonly ShaderTagId m_Tag = new ShaderTagId("LiteBuffer");
        private readonly RenderTargetIdentifier[] m_Colors = new RenderTargetIdentifier[2];
        private FilteringSettings m_Filtering = new FilteringSettings(RenderQueueRange.opaque);
        private GraphicsFormat[] m_Formats = { GraphicsFormat.R8G8B8A8_SRGB, GraphicsFormat.R16G16_SFloat };
        private bool m_HalfSize;

        public LiteBufferPass(bool halfSize, string depthName = "_LiteDepth")
        {
            m_HalfSize = halfSize;
            m_DepthId = Shader.PropertyToID(depthName);
            base.profilingSampler = new ProfilingSampler("Lite Buffer");
            m_Colors[0] = new RenderTargetIdentifier(s_AlbedoId);
            m_Colors[1] = new RenderTargetIdentifier(s_NormalsId);
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.msaaSamples = 1;
            descriptor.width >>= m_HalfSize ? 1 : 0;
            descriptor.height >>= m_HalfSize ? 1 : 0;
            RenderTextureDescriptor depth = descriptor;
            depth.colorFormat = RenderTextureFormat.Depth;
            depth.depthBufferBits = 32;
            cmd.GetTemporaryRT(m_DepthId, depth, FilterMode.Point);
            descriptor.depthBufferBits = 0;
            descriptor.graphicsFormat = m_Formats[0];
            cmd.GetTemporaryRT(s_AlbedoId, descriptor, FilterMode.Point);
            descriptor.graphicsFormat = m_Formats[1];
            cmd.GetTemporaryRT(s_NormalsId, descriptor, FilterMode.Point);
            ConfigureTarget(m_Colors, new RenderTargetIdentifier(m_DepthId));
            ConfigureClear(ClearFlag.All, Color.black);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, profilingSampler))
            {
                context.ExecuteCommandBuffer(cmd);
                cmd.Clear();
                var drawing = CreateDrawingSettings(m_Tag, ref renderingData, SortingCriteria.CommonOpaque);
                drawing.perObjectData = PerObjectData.None;
                context.DrawRenderers(renderingData.cullResults, ref drawing, ref m_Filtering);
                Publish(cmd, s_AlbedoId, s_NormalsId);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        void Publish(CommandBuffer cmd, params int[] names)
        {
            foreach (int id in names)
                cmd.SetGlobalTexture(id, new RenderTargetIdentifier(id));
        }

        public override void OnCameraCleanup(CommandBuffer cmd)
        {
            if (cmd == null) throw new System.ArgumentNullException("cmd");
            cmd.ReleaseTemporaryRT(s_AlbedoId);
            cmd.ReleaseTemporaryRT(s_NormalsId);
            cmd.ReleaseTemporaryRT(m_DepthId);
        }
    }

    [SerializeField] private RenderPassEvent m_RenderPassEvent = RenderPassEvent.AfterRenderingPrePasses;
    [SerializeField] private bool m_HalfSize;
    private LiteBufferPass m_ScriptablePass;

    public override void Create()
    {
        m_ScriptablePass = new LiteBufferPass(m_HalfSize, "_LiteDepthTexture");
        m_ScriptablePass.renderPassEvent = m_RenderPassEvent;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_ScriptablePass);
    }
}
