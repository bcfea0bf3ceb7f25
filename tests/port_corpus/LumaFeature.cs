using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

// Unity 6: a compute pass counts, a raster pass shows.
public class LumaFeature : ScriptableRendererFeature
{
    [Flags] public enum Show { None = 0, Bars = 1 << 0, Curve = 1 << 1, Both = Bars | Curve, All = ~0 }
    public enum Bins : uint { Few = 0x20u, Many = 256, Most = 0x80000000 }
    public enum Odd : byte { A = 1 << 2 + 1, B = (A | 1) & ~2, C = (int)Show.Both, D }

    public ComputeShader computeShader;
    public Show show = Show.Bars | Show.Curve;
    public Bins bins = Bins.Many;
    public Odd odd;
    LumaPass m_Pass;

    public override void Create()
    {
        m_Pass = new LumaPass();
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (!SystemInfo.supportsComputeShaders) { Debug.LogWarning("Device does not support compute shaders."); return; }
        if (computeShader == null) return;
        m_Pass.Setup(computeShader, (int)bins);
        renderer.EnqueuePass(m_Pass);
    }

    class LumaPass : ScriptableRenderPass
    {
        ComputeShader cs;
        GraphicsBuffer counts;
        uint[] zeros = new uint[256];
        int kernel = -1, binCount;
        (int x, int y) groups;

        public LumaPass()
        {
            renderPassEvent = RenderPassEvent.AfterRenderingPostProcessing;
            counts = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 256, sizeof(uint));
        }

        public void Setup(ComputeShader cs, int binCount)
        {
            this.cs = cs;
            this.binCount = binCount;
            kernel = cs.FindKernel("Count");
        }

        class CountData
        {
            public ComputeShader cs;
            public int kernel;
            public BufferHandle counts;
            public TextureHandle source;
            public Vector2Int size;
        }

        class ShowData
        {
            public BufferHandle counts;
            public Vector4 scale = new Vector4(1f, 1f);
        }

        static void Count(CountData data, ComputeGraphContext ctx)
        {
            ctx.cmd.SetComputeTextureParam(data.cs, data.kernel, "_Source", data.source);
            ctx.cmd.SetComputeBufferParam(data.cs, data.kernel, "_Counts", data.counts);
            ctx.cmd.DispatchCompute(data.cs, data.kernel, (data.size.x + 7) / 8, (data.size.y + 7) / 8, 1);
        }

        public override void RecordRenderGraph(RenderGraph graph, ContextContainer frameData)
        {
            var resources = frameData.Get<UniversalResourceData>();
            BufferHandle handle = graph.ImportBuffer(counts);
            using (var builder = graph.AddComputePass("Luma Count", out CountData data))
            {
                data.cs = cs;
                builder.SetRenderFunc((CountData d, ComputeGraphContext ctx) => Count(d, ctx));
            }
            using (var builder = graph.AddComputePass<CountData>("Luma Count", out CountData passData))
            {
                passData.cs = cs;
                passData.kernel = kernel;
                passData.counts = handle;
                passData.source = resources.activeColorTexture;
                builder.UseBuffer(handle, AccessFlags.ReadWrite);
                builder.UseTexture(passData.source);
                builder.EnableAsyncCompute(false);
                builder.SetRenderFunc<CountData>(Count);
            }
            if (binCount > 0)
            {
                using (var builder = graph.AddRasterRenderPass<ShowData>("Luma Show", out var data))
                {
                    builder.UseBuffer(handle);
                    builder.SetRenderFunc((ShowData d, RasterGraphContext c) => { });
                }
            }
        }
    }
}
