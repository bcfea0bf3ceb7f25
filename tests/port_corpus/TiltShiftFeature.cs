using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RenderGraphModule.Util;
using UnityEngine.Rendering.Universal;

// Unity 6: the AddBlitPass helper, there and back, and the camera's colour swapped.
public sealed class TiltShiftFeature : ScriptableRendererFeature
{
    [System.Serializable]
    public class TiltShiftSettings
    {
        [field: SerializeField, Range(0f, 1f)] public float Centre { get; private set; } = .5f;
        [field: SerializeField] public Material Material { get; set; }
        [Tooltip("Blur.")] public Vector4 kernel = new(1f, 2f, 0f, 0f);
        [Delayed] public int rounds = 2;
    }

    [SerializeField] private TiltShiftSettings settings;
    [SerializeField] private RenderPassEvent injectionPoint = RenderPassEvent.AfterRenderingPostProcessing;
    private TiltShiftPass pass;

    public override void Create()
    {
        pass = new TiltShiftPass(settings);
        pass.renderPassEvent = injectionPoint;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (settings.Material == null || renderingData.cameraData.cameraType is CameraType.Preview or CameraType.Reflection)
            return;
        pass.ConfigureInput(ScriptableRenderPassInput.Color);
        renderer.EnqueuePass(pass);
    }

    private sealed class TiltShiftPass : ScriptableRenderPass
    {
        private const string k_PassName = "Tilt Shift";
        private static readonly int k_Kernel = Shader.PropertyToID("_Kernel");
        private static readonly int k_Centre = Shader.PropertyToID("_Centre");
        private readonly TiltShiftSettings m_Settings;

        public TiltShiftPass(TiltShiftSettings settings)
        {
            m_Settings = settings;
            requiresIntermediateTexture = true;
        }

        private void UpdateMaterial()
        {
            m_Settings.Material.SetVector(k_Kernel, m_Settings.kernel);
            m_Settings.Material.SetFloat(k_Centre, m_Settings.Centre);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            if (resourceData.isActiveTargetBackBuffer)
                return;
            UpdateMaterial();
            TextureHandle source = resourceData.activeColorTexture;
            TextureDesc desc = renderGraph.GetTextureDesc(source);
            desc.name = $"CameraColor-{k_PassName}";
            desc.clearBuffer = false;
            desc.depthBufferBits = 0;
            TextureHandle destination = renderGraph.CreateTexture(desc);
            for (int i = 0; i < m_Settings.rounds; i++)
            {
                RenderGraphUtils.BlitMaterialParameters horizontal = new(source, destination, m_Settings.Material, 0);
                renderGraph.AddBlitPass(horizontal, passName: k_PassName);
                var vertical = new RenderGraphUtils.BlitMaterialParameters(destination, source, m_Settings.Material, 1);
                renderGraph.AddBlitPass(vertical, k_PassName);
            }
            renderGraph.AddCopyPass(source, destination, passName: "Tilt Shift Copy");
            resourceData.cameraColor = destination;
        }
    }
}
