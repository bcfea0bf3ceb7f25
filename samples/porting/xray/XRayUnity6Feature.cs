using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

// As one writes it for Unity 6: two renderer lists in one raster pass.
public class XRayUnity6Feature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingOpaques;
        public LayerMask layerMask;
        public Shader shader;
        public Color color = new Color(1f, 0.45f, 0.1f, 0.6f);
        [Range(1, 255)] public int stencilReference = 1;
    }

    class XRayPass : ScriptableRenderPass
    {
        const int k_MarkPass = 0;
        const int k_ColorPass = 1;
        static readonly ShaderTagId[] s_ShaderTagIds = { new("SRPDefaultUnlit"), new("UniversalForward") };

        readonly Settings m_Settings;
        readonly Material m_Material;

        class PassData
        {
            public RendererListHandle visible;
            public RendererListHandle hidden;
        }

        public XRayPass(Settings settings)
        {
            m_Settings = settings;
            renderPassEvent = settings.renderPassEvent;
            m_Material = CoreUtils.CreateEngineMaterial(settings.shader);
            m_Material.SetColor("_XRayColor", settings.color);
        }

        RenderStateBlock MakeState(bool isVisible)
        {
            StencilState stencil = StencilState.defaultValue;
            stencil.SetPassOperation(StencilOp.Replace);
            stencil.SetCompareFunction(isVisible ? CompareFunction.Always : CompareFunction.NotEqual);
            RenderStateBlock state = new(RenderStateMask.Depth | RenderStateMask.Stencil);
            state.depthState = new DepthState(false, isVisible ? CompareFunction.LessEqual : CompareFunction.Greater);
            state.stencilReference = m_Settings.stencilReference;
            state.stencilState = stencil;
            return state;
        }

        RendererListHandle CreateList(RenderGraph renderGraph, ContextContainer frameData, int pass)
        {
            UniversalRenderingData renderingData = frameData.Get<UniversalRenderingData>();
            UniversalCameraData cameraData = frameData.Get<UniversalCameraData>();
            RendererListDesc desc = new(s_ShaderTagIds, renderingData.cullResults, cameraData.camera);
            desc.sortingCriteria = cameraData.defaultOpaqueSortFlags;
            desc.renderQueueRange = RenderQueueRange.opaque;
            desc.layerMask = m_Settings.layerMask;
            desc.overrideMaterial = m_Material;
            desc.overrideMaterialPassIndex = pass;
            desc.stateBlock = MakeState(pass == k_MarkPass);
            return renderGraph.CreateRendererList(desc);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();

            using (var builder = renderGraph.AddRasterRenderPass<PassData>("X-Ray", out var passData))
            {
                passData.visible = CreateList(renderGraph, frameData, k_MarkPass);
                passData.hidden = CreateList(renderGraph, frameData, k_ColorPass);
                builder.UseRendererList(passData.visible);
                builder.UseRendererList(passData.hidden);
                builder.SetRenderAttachment(resourceData.activeColorTexture, 0);
                builder.SetRenderAttachmentDepth(resourceData.activeDepthTexture, AccessFlags.ReadWrite);
                builder.SetRenderFunc((PassData data, RasterGraphContext context) =>
                {
                    context.cmd.DrawRendererList(data.visible);
                    context.cmd.DrawRendererList(data.hidden);
                });
            }
        }
    }

    public Settings settings = new Settings();
    XRayPass m_Pass;

    public override void Create()
    {
        m_Pass = new XRayPass(settings);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_Pass);
    }
}
