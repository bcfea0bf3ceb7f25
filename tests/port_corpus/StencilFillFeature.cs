using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 10: a stencil written by objects, then a full-screen mesh where it is set.
public class StencilFillFeature : ScriptableRendererFeature
{
    [System.Serializable]
    public class StencilSettings
    {
        [Header("Stencil")]
        [Range(0, 255)] public int reference = 1;
        public CompareFunction compare = CompareFunction.Equal;
        public StencilOp passOperation = StencilOp.Replace;
        [SerializeField] byte writeMask = 255;
    }

    [SerializeField] LayerMask m_Layers = ~0;
    [SerializeField] StencilSettings m_Stencil = new StencilSettings();
    [SerializeField, Tooltip("The colour \"inside\", sRGB")] Color m_Fill = Color.red;
    [SerializeField] Shader m_Shader;
    [SerializeField, HideInInspector] Mesh m_FullScreen;

    WritePass m_Write;
    FillPass m_FillPass;

    public override void Create()
    {
        m_Write = new WritePass(m_Layers, m_Stencil) { renderPassEvent = RenderPassEvent.BeforeRenderingTransparents };
        m_FillPass = new FillPass(m_Fill)
        {
            renderPassEvent = RenderPassEvent.BeforeRenderingTransparents + 1
        };
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (renderingData.cameraData.cameraType == CameraType.Preview) return;
        renderer.EnqueuePass(m_Write);
        m_FillPass.material = m_FillPass.material ?? CoreUtils.CreateEngineMaterial(m_Shader);
        renderer.EnqueuePass(m_FillPass);
    }

    protected override void Dispose(bool disposing)
    {
        CoreUtils.Destroy(m_FillPass?.material);
    }

    private class WritePass : ScriptableRenderPass
    {
        static readonly ShaderTagId[] s_Tags = { new ShaderTagId("UniversalForward"), new ShaderTagId("UniversalForwardOnly") };
        FilteringSettings m_Filtering;
        RenderStateBlock m_State;

        public WritePass(LayerMask layers, StencilSettings stencil)
        {
            m_Filtering = new FilteringSettings(RenderQueueRange.opaque, layers);
            m_State = new RenderStateBlock(RenderStateMask.Stencil | RenderStateMask.Depth);
            m_State.stencilReference = stencil.reference;
            var state = StencilState.defaultValue;
            state.SetCompareFunction(stencil.compare);
            state.SetPassOperation(stencil.passOperation);
            m_State.stencilState = state;
            m_State.depthState = new DepthState(false, CompareFunction.LessEqual);
            profilingSampler = new ProfilingSampler(nameof(WritePass));
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var drawing = CreateDrawingSettings(s_Tags[0], ref renderingData, SortingCriteria.CommonOpaque);
            for (int i = 1; i < s_Tags.Length; ++i)
                drawing.SetShaderPassName(i, s_Tags[i]);
            context.DrawRenderers(renderingData.cullResults, ref drawing, ref m_Filtering, ref m_State);
        }
    }

    private class FillPass : ScriptableRenderPass
    {
        internal Material material;
        Color m_Color;

        public FillPass(Color color)
        {
            m_Color = color;
            ConfigureInput(ScriptableRenderPassInput.Depth);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (!material) return;
            var cmd = CommandBufferPool.Get("Stencil Fill");
            material.SetColor("_BaseColor", m_Color);
            cmd.SetViewProjectionMatrices(Matrix4x4.identity, Matrix4x4.identity);
            cmd.DrawMesh(RenderingUtils.fullscreenMesh, Matrix4x4.identity, material, 0, 0);
            var camera = renderingData.cameraData.camera;
            cmd.SetViewProjectionMatrices(camera.worldToCameraMatrix, camera.projectionMatrix);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
    }
}
