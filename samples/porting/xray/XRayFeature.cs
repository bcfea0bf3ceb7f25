using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// As one wrote it for URP 10: two DrawRenderers with state blocks.
// Objects of a layer shine through what hides them: where they are seen, the stencil is marked, and
// where they are not, they are drawn in a colour, each pixel once.
public class XRayFeature : ScriptableRendererFeature
{
    [System.Serializable]
    public class Settings
    {
        public RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingOpaques;
        public LayerMask layerMask = 0;
        public Shader shader = null;
        public Color color = new Color(1f, 0.45f, 0.1f, 0.6f);
        [Range(1, 255)] public int stencilReference = 1;
    }

    class XRayPass : ScriptableRenderPass
    {
        const int k_MarkPass = 0;
        const int k_ColorPass = 1;
        static readonly int s_Color = Shader.PropertyToID("_XRayColor");

        readonly List<ShaderTagId> m_ShaderTagIds = new List<ShaderTagId>();
        readonly ProfilingSampler m_ProfilingSampler = new ProfilingSampler("X-Ray");
        readonly Material m_Material;
        FilteringSettings m_FilteringSettings;
        RenderStateBlock m_Visible;
        RenderStateBlock m_Hidden;

        public XRayPass(Settings settings)
        {
            renderPassEvent = settings.renderPassEvent;
            m_FilteringSettings = new FilteringSettings(RenderQueueRange.opaque, settings.layerMask);
            m_ShaderTagIds.Add(new ShaderTagId("SRPDefaultUnlit"));
            m_ShaderTagIds.Add(new ShaderTagId("UniversalForward"));
            m_Material = CoreUtils.CreateEngineMaterial(settings.shader);
            m_Material.SetColor(s_Color, settings.color);

            StencilState visible = StencilState.defaultValue;
            visible.SetPassOperation(StencilOp.Replace);
            m_Visible = new RenderStateBlock(RenderStateMask.Stencil);
            m_Visible.stencilReference = settings.stencilReference;
            m_Visible.stencilState = visible;

            StencilState hidden = StencilState.defaultValue;
            hidden.SetCompareFunction(CompareFunction.NotEqual);
            hidden.SetPassOperation(StencilOp.Replace);
            m_Hidden = new RenderStateBlock(RenderStateMask.Depth | RenderStateMask.Stencil);
            m_Hidden.depthState = new DepthState(false, CompareFunction.Greater);
            m_Hidden.stencilReference = settings.stencilReference;
            m_Hidden.stencilState = hidden;
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            SortingCriteria sortingCriteria = renderingData.cameraData.defaultOpaqueSortFlags;
            DrawingSettings drawingSettings = CreateDrawingSettings(m_ShaderTagIds, ref renderingData, sortingCriteria);
            drawingSettings.overrideMaterial = m_Material;

            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, m_ProfilingSampler))
            {
                context.ExecuteCommandBuffer(cmd);
                cmd.Clear();

                drawingSettings.overrideMaterialPassIndex = k_MarkPass;
                context.DrawRenderers(renderingData.cullResults, ref drawingSettings, ref m_FilteringSettings, ref m_Visible);
                drawingSettings.overrideMaterialPassIndex = k_ColorPass;
                context.DrawRenderers(renderingData.cullResults, ref drawingSettings, ref m_FilteringSettings, ref m_Hidden);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
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
