using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RenderGraphModule.Util;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.Universal;

// Passes of a render graph in each way that C# has to write one down. Written for limn's tests.
public class GraphToolboxFeature : ScriptableRendererFeature
{
    [SerializeField] Shader m_Shader;
    [SerializeField] int m_Rounds = 2;
    [SerializeField] RenderPassEvent m_Event = RenderPassEvent.AfterRenderingTransparents;

    GraphToolboxPass m_Pass;

    public override void Create()
    {
        m_Pass = new GraphToolboxPass(m_Rounds);
        m_Pass.renderPassEvent = m_Event;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_Pass);
    }

    protected override void Dispose(bool disposing)
    {
        m_Pass = null;
    }

    class GraphToolboxPass : ScriptableRenderPass
    {
        const string k_UnsafeName = "Toolbox Unsafe";

        class DrawData
        {
            internal RendererListHandle objects;
            internal Color tint;
        }

        struct ComputeData
        {
            public ComputeShader compute;
            public TextureHandle target;
            public BufferHandle counts;
            public int kernel;
            public AnimationCurve falloff;
        }

        class EmptyData { }

        readonly int m_Rounds;
        Material m_Material;
        ComputeShader m_Compute;
        GraphicsBuffer m_Counts;
        RTHandle m_History;

        public GraphToolboxPass(int rounds)
        {
            m_Rounds = rounds;
            profilingSampler = new ProfilingSampler("Graph Toolbox");
        }

        static void Draw(DrawData data, RasterGraphContext context)
        {
            context.cmd.ClearRenderTarget(true, true, data.tint);
            context.cmd.DrawRendererList(data.objects);
            context.cmd.DrawProcedural(Matrix4x4.identity, null, 0, MeshTopology.Triangles, 3, 1);
        }

        TextureHandle AddCompute(RenderGraph graph, TextureHandle target)
        {
            BufferHandle counts = graph.ImportBuffer(m_Counts);
            using (var builder = graph.AddComputePass<ComputeData>("Toolbox Compute", out ComputeData passData))
            {
                passData.compute = m_Compute;
                passData.target = target;
                passData.counts = counts;
                passData.kernel = m_Compute.FindKernel("Main");
                builder.UseTexture(target, AccessFlags.Write);
                builder.UseBuffer(counts, AccessFlags.Read);
                builder.EnableAsyncCompute(true);
                builder.SetRenderFunc(static (ComputeData data, ComputeGraphContext context) =>
                {
                    ComputeCommandBuffer cmd = context.cmd;
                    cmd.SetComputeTextureParam(data.compute, data.kernel, "_Target", data.target);
                    cmd.SetComputeBufferParam(data.compute, data.kernel, "_Counts", data.counts);
                    cmd.DispatchCompute(data.compute, data.kernel, 8, 8, 1);
                });
            }
            return target;
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            var resourceData = frameData.Get<UniversalResourceData>();
            var cameraData = frameData.Get<UniversalCameraData>();
            var universal = frameData.Get<UniversalRenderingData>();
            TextureDesc desc = renderGraph.GetTextureDesc(resourceData.activeColorTexture);
            desc.name = "_Toolbox";
            desc.enableRandomWrite = true;
            desc.msaaSamples = MSAASamples.None;
            TextureHandle target = renderGraph.CreateTexture(desc);
            TextureHandle history = renderGraph.ImportTexture(m_History);

            // The objects that glow.
            using (IRasterRenderGraphBuilder builder = renderGraph.AddRasterRenderPass<DrawData>("Toolbox Draw", out DrawData passData, profilingSampler))
            {
                var list = new RendererListDesc(new ShaderTagId("UniversalForward"), universal.cullResults, cameraData.camera);
                passData.objects = renderGraph.CreateRendererList(list);
                passData.tint = Color.clear;
                builder.UseRendererList(passData.objects);
                builder.SetRenderAttachment(target, 0);
                builder.SetRenderAttachmentDepth(resourceData.activeDepthTexture, AccessFlags.Read);
                builder.SetGlobalTextureAfterPass(target, Shader.PropertyToID("_ToolboxTexture"));
                builder.AllowPassCulling(false);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc((DrawData data, RasterGraphContext context) => Draw(data, context));
            }

            using (var builder = renderGraph.AddRasterRenderPass<DrawData>(nameof(GraphToolboxPass), out var passData))
            {
                builder.UseAllGlobalTextures(true);
                builder.SetRenderAttachment(history, 0, AccessFlags.ReadWrite);
                builder.SetRenderFunc<DrawData>(Draw);
            }

            AddCompute(renderGraph, target);

            for (int i = 0; i < m_Rounds; i++)
            {
                using (var builder = renderGraph.AddUnsafePass<EmptyData>("Toolbox Round", out var passData))
                {
                    builder.SetRenderFunc((EmptyData data, UnsafeGraphContext context) => { });
                }
            }

            using (var builder = renderGraph.AddUnsafePass<EmptyData>("Round " + m_Rounds, out var passData))
            {
                builder.SetRenderFunc((EmptyData data, UnsafeGraphContext context) => { });
            }

            using (var builder = renderGraph.AddUnsafePass<ForeignData>("Toolbox Foreign", out var passData))
            {
                builder.SetRenderFunc((ForeignData data, UnsafeGraphContext context) => { });
            }

            using (var builder = renderGraph.AddRasterRenderPass<EmptyData>("Toolbox Empty", out var passData))
            {
                builder.SetRenderAttachment(target, 0);
            }

            renderGraph.AddCopyPass(target, history, passName: "Toolbox Copy");
            renderGraph.AddBlitPass(new RenderGraphUtils.BlitMaterialParameters(target, resourceData.activeColorTexture, m_Material, 0), "Toolbox Blit");

            using var unsafeBuilder = renderGraph.AddUnsafePass<DrawData>(k_UnsafeName, out var unsafeData);
            unsafeData.tint = Color.white;
            unsafeBuilder.UseTexture(history, AccessFlags.ReadWrite);
            unsafeBuilder.SetRenderFunc((data, context) =>
            {
                CommandBuffer native = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
                context.cmd.SetGlobalFloat("_HasObjects", data.objects.IsValid() ? 1 : 0);
                native.SetGlobalColor("_Tint", data.tint);
            });
        }
    }
}
