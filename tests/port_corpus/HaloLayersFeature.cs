using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 14 with a stand-in for Unity 6's RenderingLayerMask, and handles that are set to null.
#if !UNITY_6000_0_OR_NEWER
[Serializable]
public struct RenderingLayerMask
{
    [SerializeField] private uint m_Bits;

    public RenderingLayerMask(uint bits) { m_Bits = bits; }

    public static implicit operator uint(RenderingLayerMask mask) => mask.m_Bits;
    public static implicit operator RenderingLayerMask(uint bits) => new RenderingLayerMask(bits);
}
#endif

[Serializable]
public class LayerBitsParameter : VolumeParameter<uint>
{
    public LayerBitsParameter(uint value, bool overrideState = false) : base(value, overrideState) { }
}

[Serializable]
public class HaloLayers : VolumeComponent
{
    public BoolParameter isOn = new BoolParameter(true, true);
    public LayerBitsParameter layers = new LayerBitsParameter(2);
}

[Serializable]
public class HaloLayersSettings
{
    public float width = 0.01f;
    public RenderingLayerMask layers = 2u;
}

public class HaloLayersFeature : ScriptableRendererFeature
{
    class HaloPass : ScriptableRenderPass
    {
        private readonly HaloLayersSettings m_Settings;
        private FilteringSettings m_Filtering;
        private RTHandle m_Mask;

        public HaloPass(HaloLayersSettings settings)
        {
            m_Settings = settings;
            m_Filtering = new FilteringSettings(RenderQueueRange.all, renderingLayerMask: (uint)settings.layers);
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            Allocate(renderingData.cameraData.cameraTargetDescriptor);
        }

        private void Allocate(RenderTextureDescriptor desc)
        {
            desc.depthBufferBits = 0;
            RenderingUtils.ReAllocateIfNeeded(ref m_Mask, desc, name: "_HaloMask");
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get("Halo");
            CoreUtils.SetRenderTarget(cmd, m_Mask, ClearFlag.Color, Color.clear);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public void Dispose()
        {
            m_Mask?.Release();
            m_Mask = null;
        }
    }

    [SerializeField] private HaloLayersSettings m_Settings = new HaloLayersSettings();

    private HaloPass m_Pass;

    public override void Create()
    {
        m_Pass?.Dispose();
        m_Pass = new HaloPass(m_Settings);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_Pass);
    }
}
