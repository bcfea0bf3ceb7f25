using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.Universal;

// Unity 6: types of builders and data written out, samplers, a pass's name in a variable, helpers
// that make renderer lists and states, components kept as members, vectors by name.
public class Contour : VolumeComponent, IPostProcessComponent
{
    public Vector2Parameter shift = new Vector2Parameter(Vector2.zero);
    public Vector3Parameter axis = new Vector3Parameter(Vector3.up, true);
    public Vector4Parameter weights = new Vector4Parameter(Vector4.one);
    public ClampedIntParameter size = new ClampedIntParameter(0, 0, 8);

    public bool IsActive() => size.value > 0;
    public bool IsTileCompatible() => false;
}

public class ContourFeature : ScriptableRendererFeature
{
    private class MaskPass : ScriptableRenderPass
    {
        private class PassData
        {
            public RendererListHandle front;
            public RendererListHandle back;
        }

        private static readonly ShaderTagId[] s_Tags = { new ShaderTagId("UniversalForward") };

        private readonly Material m_Material;
        private Contour m_Contour;

        public MaskPass(Material material)
        {
            profilingSampler = new ProfilingSampler("Contour");
            renderPassEvent = RenderPassEvent.AfterRenderingOpaques;
            m_Material = material;
        }

        public void Setup(Contour contour)
        {
            m_Contour = contour;
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalRenderingData renderingData = frameData.Get<UniversalRenderingData>();
            UniversalCameraData cameraData = frameData.Get<UniversalCameraData>();
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            TextureHandle mask = renderGraph.CreateTexture(resourceData.cameraColor, "_ContourMask", true);

            using (IRasterRenderGraphBuilder builder = renderGraph.AddRasterRenderPass("Contour Mask", out PassData passData, profilingSampler))
            {
                passData.front = MakeList(renderGraph, renderingData, cameraData, ColorWriteMask.Red);
                passData.back = MakeList(renderGraph, renderingData, cameraData, ColorWriteMask.Green | ColorWriteMask.Blue);
                builder.UseRendererList(passData.front);
                builder.UseRendererList(passData.back);
                builder.SetRenderAttachment(mask, 0, AccessFlags.Write);
                builder.SetRenderFunc((PassData data, RasterGraphContext context) => Draw(data, context));
            }

            string passName = "Contour Composite";
            using (var builder = renderGraph.AddUnsafePass<PassData>(passName, out var passData, this.profilingSampler))
            {
                builder.UseTexture(mask);
                builder.UseTexture(resourceData.activeColorTexture, AccessFlags.ReadWrite);
                builder.SetRenderFunc((PassData data, UnsafeGraphContext context) => { });
            }
        }

        private RendererListHandle MakeList(RenderGraph renderGraph, UniversalRenderingData renderingData, UniversalCameraData cameraData, ColorWriteMask mask)
        {
            RendererListDesc desc = new RendererListDesc(s_Tags, renderingData.cullResults, cameraData.camera);
            desc.overrideMaterial = m_Material;
            desc.stateBlock = BlockOf(mask);
            return renderGraph.CreateRendererList(desc);
        }

        private static RenderStateBlock BlockOf(ColorWriteMask mask)
        {
            RenderStateMask which = (mask & ColorWriteMask.Red) != 0 ? RenderStateMask.Nothing : RenderStateMask.Blend;
            return new RenderStateBlock(which);
        }

        private static void Draw(PassData data, RasterGraphContext context)
        {
            context.cmd.DrawRendererList(data.front);
            context.cmd.DrawRendererList(data.back);
        }
    }

    [SerializeField, Tooltip("Draws the mask; " + "and what is made of it.")] private Material m_Material;

    private MaskPass m_Pass;

    public override void Create()
    {
        m_Pass = new MaskPass(m_Material);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        Contour contour = VolumeManager.instance.stack.GetComponent<Contour>();
        if (contour == null || !contour.IsActive()) return;
        m_Pass.Setup(contour);
        renderer.EnqueuePass(m_Pass);
    }
}
