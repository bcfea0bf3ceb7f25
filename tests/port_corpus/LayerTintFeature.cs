using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.Universal;

// Unity 6: masks of rendering layers as settings, as numbers and as volume parameters.
[Serializable, VolumeComponentMenu("Custom/Layer Tint"), SupportedOnRenderPipeline(typeof(UniversalRenderPipelineAsset))]
public class LayerTint : VolumeComponent
{
    public LayerTint() { displayName = "Layer Tint"; }

    [Tooltip("Which layers.")] public LayerBitsParameter layers = new LayerBitsParameter(1);
    public RenderingLayerMaskParameter masks = new RenderingLayerMaskParameter(0);
    public VolumeParameter<uint> count = new VolumeParameter<uint>();
    public CountParameter steps = new CountParameter(8, true);
    public EnumParameter<BlendMode> blend = new EnumParameter<BlendMode>(BlendMode.Zero);
    public EnumParameter<LayerTintFeature.Kind> kind = new EnumParameter<LayerTintFeature.Kind>(LayerTintFeature.Kind.Flat);
    public ColorParameter tint = new(Color.cyan, false, false, true);

    [Serializable] public class LayerBitsParameter : VolumeParameter<uint>
    {
        public LayerBitsParameter(uint value, bool overrideState = false) : base(value, overrideState) { }
    }

    [Serializable] public class CountParameter : VolumeParameter<uint>
    {
        public CountParameter(uint value, bool overrideState = false) : base(value, overrideState) { }
        public override void Interp(uint from, uint to, float t) => m_Value = from + (uint)((to - from) * t);
    }
}

public class LayerTintFeature : ScriptableRendererFeature
{
    public enum Kind { Flat, Lit }

    [SerializeField] RenderingLayerMask m_RenderingLayerMask = RenderingLayerMask.defaultRenderingLayerMask;
    [SerializeField] RenderingLayerMask m_Other = 2;
    [SerializeField] uint m_Mask = 0xFFFFFFFF;
    [SerializeField] LayerMask m_LayerMask = -1;
    [SerializeField] Material m_Material;

    class TintPass : ScriptableRenderPass
    {
        class PassData { public RendererListHandle list; public Color tint; }

        static readonly ShaderTagId[] k_Tags = new ShaderTagId[] { new ShaderTagId("UniversalForward") };
        readonly uint m_Mask;
        RenderingLayerMask m_Layers;
        Material m_Material;

        public TintPass(uint mask, RenderingLayerMask layers, Material material)
        {
            m_Mask = mask;
            m_Layers = layers;
            m_Material = material;
            renderPassEvent = RenderPassEvent.AfterRenderingOpaques;
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            var tint = VolumeManager.instance.stack.GetComponent<LayerTint>();
            if (tint == null || !tint.active) return;
            UniversalRenderingData renderingData = frameData.Get<UniversalRenderingData>();
            UniversalCameraData cameraData = frameData.Get<UniversalCameraData>();
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            var desc = new RendererListDesc(k_Tags, renderingData.cullResults, cameraData.camera)
            {
                renderQueueRange = RenderQueueRange.opaque,
                renderingLayerMask = m_Mask & m_Layers,
                overrideMaterial = m_Material,
                sortingCriteria = SortingCriteria.CommonOpaque
            };
            using (var builder = renderGraph.AddRasterRenderPass<PassData>(GetType().Name, out var passData))
            {
                passData.list = renderGraph.CreateRendererList(desc);
                passData.tint = tint.tint.value;
                builder.UseRendererList(passData.list);
                builder.SetRenderAttachment(resourceData.activeColorTexture, 0);
                builder.SetRenderAttachmentDepth(resourceData.activeDepthTexture);
                builder.SetRenderFunc(static (PassData data, RasterGraphContext context) => context.cmd.DrawRendererList(data.list));
            }
        }
    }

    TintPass m_Pass;

    public override void Create() => m_Pass = new TintPass(m_Mask, m_RenderingLayerMask, m_Material);

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData) => renderer.EnqueuePass(m_Pass);
}
