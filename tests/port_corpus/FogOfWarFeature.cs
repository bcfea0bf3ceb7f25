using UnityEngine;
using UnityEngine.Rendering;
#if UNITY_6000_0_OR_NEWER
using UnityEngine.Rendering.RenderGraphModule;
#elif UNITY_2023_1_OR_NEWER
using UnityEngine.Experimental.Rendering.RenderGraphModule;
#endif
using UnityEngine.Rendering.Universal;

#if URP_12_OR_NEWER || URP_12_0_0_OR_NEWER
// One file for three generations of URP.
public class FogOfWarFeature : ScriptableRendererFeature
{
    [SerializeField] private Material material;
    [SerializeField] private bool useDepth = true;
#if UNITY_EDITOR
    [SerializeField] private bool previewInEditor;
#endif

    private FogOfWarPass pass;

    public override void Create()
    {
        pass = new FogOfWarPass(useDepth)
        {
#if URP_17_OR_NEWER
            requiresIntermediateTexture = true,
#endif
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents
        };
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (material == null) return;
        pass.material = material;
        renderer.EnqueuePass(pass);
    }

#if UNITY_2022_1_OR_NEWER
    public override void SetupRenderPasses(ScriptableRenderer renderer, in RenderingData renderingData)
    {
        pass.color = renderer.cameraColorTargetHandle;
    }
#endif

    private class FogOfWarPass : ScriptableRenderPass
    {
        internal Material material;
#if UNITY_2022_1_OR_NEWER
        internal RTHandle color;
        private RTHandle copy;
#else
        internal RenderTargetIdentifier color;
        private int copy = Shader.PropertyToID("_FogCopy");
#endif

        public FogOfWarPass(bool useDepth)
        {
            ConfigureInput(useDepth ? ScriptableRenderPassInput.Depth : ScriptableRenderPassInput.None);
        }

#if UNITY_6000_0_OR_NEWER
        private class PassData
        {
            internal Material material;
            internal TextureHandle source;
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            var resources = frameData.Get<UniversalResourceData>();
            using (var builder = renderGraph.AddRasterRenderPass<PassData>("Fog of War", out var data))
            {
                data.material = material;
                data.source = resources.activeColorTexture;
                builder.UseTexture(data.source);
                builder.SetRenderFunc((PassData d, RasterGraphContext c) => Blitter.BlitTexture(c.cmd, d.source, Vector2.one, d.material, 0));
            }
        }
#endif

#if !UNITY_6000_0_OR_NEWER || URP_COMPATIBILITY_MODE
        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            var desc = renderingData.cameraData.cameraTargetDescriptor;
            desc.depthBufferBits = 0;
#if UNITY_2022_1_OR_NEWER
            RenderingUtils.ReAllocateIfNeeded(ref copy, desc, name: "_FogCopy");
#else
            cmd.GetTemporaryRT(copy, desc);
#endif
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var cmd = CommandBufferPool.Get("Fog of War");
#if UNITY_2022_1_OR_NEWER
            Blitter.BlitCameraTexture(cmd, color, copy, material, 0);
            Blitter.BlitCameraTexture(cmd, copy, color);
#else
            cmd.Blit(color, copy, material, 0);
            cmd.Blit(copy, color);
#endif
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
#endif
    }
}
#endif
