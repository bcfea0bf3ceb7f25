using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.Universal;

// URP 14 with renderer lists: a mask of some rendering layers, then an outline from the mask.
public class HighlightFeature : ScriptableRendererFeature
{
    [SerializeField] private RenderPassEvent renderPassEvent = RenderPassEvent.AfterRenderingSkybox;
    [SerializeField] private uint renderingLayerMask = 1u << 4;
    [SerializeField] private LayerMask layerMask = 1 << 3;
    [SerializeField] private Shader maskShader, outlineShader;
    [SerializeField] private HighlightLook look = new HighlightLook();

    [System.Serializable]
    public class HighlightLook
    {
        [ColorUsage(false, true)] public Color color = Color.yellow;
        [Range(1, 16)] public int width = 4;
        public bool inside;
    }

    private MaskPass maskPass;
    private OutlinePass outlinePass;
    private Material maskMaterial, outlineMaterial;

    public override void Create()
    {
        maskPass = new MaskPass(layerMask, renderingLayerMask);
        maskPass.renderPassEvent = renderPassEvent;
        outlinePass = new OutlinePass(look);
        outlinePass.renderPassEvent = renderPassEvent + 1;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (!CreateMaterials()) return;
        maskPass.Setup(ref maskMaterial);
        outlinePass.Setup(outlineMaterial, maskPass);
        renderer.EnqueuePass(maskPass);
        renderer.EnqueuePass(outlinePass);
    }

    private bool CreateMaterials()
    {
        if (maskMaterial == null) maskMaterial = CoreUtils.CreateEngineMaterial(maskShader);
        if (outlineMaterial == null) outlineMaterial = CoreUtils.CreateEngineMaterial(outlineShader);
        return maskMaterial && outlineMaterial;
    }

    protected override void Dispose(bool disposing)
    {
        maskPass?.Dispose();
        CoreUtils.Destroy(maskMaterial);
        CoreUtils.Destroy(outlineMaterial);
    }

    private class MaskPass : ScriptableRenderPass
    {
        public RTHandle mask;
        private readonly List<ShaderTagId> shaderTagIds = new()
        {
            new ShaderTagId("UniversalForward"),
            new ShaderTagId("LightweightForward")
        };
        private FilteringSettings filteringSettings;
        private Material material;

        public MaskPass(LayerMask layers, uint renderingLayers)
        {
            filteringSettings = new FilteringSettings(RenderQueueRange.all, layers, renderingLayers);
            profilingSampler = new ProfilingSampler("Highlight Mask");
        }

        public void Setup(ref Material material) => this.material = material;

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            var descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.colorFormat = RenderTextureFormat.R8;
            descriptor.depthBufferBits = 0;
            RenderingUtils.ReAllocateIfNeeded(ref mask, descriptor, name: "_HighlightMask");
            ConfigureTarget(mask, renderingData.cameraData.renderer.cameraDepthTargetHandle);
            ConfigureClear(ClearFlag.Color, Color.clear);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, profilingSampler))
            {
                var drawing = CreateDrawingSettings(shaderTagIds, ref renderingData, SortingCriteria.CommonOpaque);
                drawing.overrideMaterial = material;
                var parameters = new RendererListParams(renderingData.cullResults, drawing, filteringSettings);
                RendererList list = context.CreateRendererList(ref parameters);
                cmd.DrawRendererList(list);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public void Dispose() => mask?.Release();
    }

    private class OutlinePass : ScriptableRenderPass
    {
        private HighlightLook look;
        private Material material;
        private MaskPass maskPass;

        public OutlinePass(HighlightLook look) { this.look = look; }

        public void Setup(Material material, MaskPass maskPass)
        {
            this.material = material;
            this.maskPass = maskPass;
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var cmd = CommandBufferPool.Get("Highlight Outline");
            material.SetColor("_Color", look.color);
            material.SetInteger("_Width", look.width);
            Blitter.BlitCameraTexture(cmd, maskPass.mask, renderingData.cameraData.renderer.cameraColorTargetHandle, material, look.inside ? 1 : 0);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
    }
}
