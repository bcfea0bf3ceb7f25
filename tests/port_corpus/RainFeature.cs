using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 12: a component with every kind of parameter and tooltips on them, read by a pass.
[Serializable, VolumeComponentMenuForRenderPipeline("Weather/Rain", typeof(UniversalRenderPipeline))]
public sealed class Rain : VolumeComponent, IPostProcessComponent
{
    public enum Quality { Low, Medium, High = 10 }

    [Header("Drops")]
    [Tooltip("How many drops.")]
    public MinFloatParameter amount = new MinFloatParameter(0f, 0f);
    [Tooltip("Their colour, which may be brighter than white.")]
    public ColorParameter color = new ColorParameter(new Color(.6f, .7f, 1f, .5f), true, true, true);
    [Tooltip("Without an eye dropper.")]
    public NoInterpColorParameter splash = new NoInterpColorParameter(Color.white, hdr: true, showAlpha: false, showEyeDropper: false, overrideState: true);
    public ColorParameter ground = new ColorParameter(Color.gray, overrideState: true);
    [Tooltip("Metres a second.")] public Vector3Parameter wind = new Vector3Parameter(new Vector3(1f, -9, 0));
    public Vector2Parameter tiling = new Vector2Parameter(Vector2.one);
    public Vector4Parameter ripples = new Vector4Parameter(new Vector4(1, 1, 0, 0), true);
    [Tooltip("Rounds.")] public ClampedIntParameter layers = new ClampedIntParameter(value: 2, min: 1, max: 4);
    public IntParameter seed = new ClampedIntParameter(7, 0, 9);
    public MaxIntParameter most = new MaxIntParameter(3, 8, true);
    public NoInterpClampedFloatParameter speed = new(1f, 0f, 5f);
    public FloatRangeParameter range = new FloatRangeParameter(new Vector2(0f, 50f), 0f, 100f);
    public BoolParameter indoors = new BoolParameter(false);
    public LayerMaskParameter mask = new LayerMaskParameter(-1);
    public TextureParameter noise = new TextureParameter(null);
    public QualityParameter quality = new QualityParameter(Quality.Medium, false);
    public VolumeParameter<Quality> fallback = new VolumeParameter<Quality>();
    public AnimationCurveParameter falloff = new AnimationCurveParameter(new AnimationCurve());
    float m_Age = 1.5f;

    public bool IsActive()
    {
        return active && amount.value > 0f;
    }

    public bool IsTileCompatible() => true;

    public float Density(int layer) => amount.value / (layer + 1) + m_Age;
}

[Serializable]
public sealed class QualityParameter : VolumeParameter<Rain.Quality>
{
    public QualityParameter(Rain.Quality value, bool overrideState = false) : base(value, overrideState) { }
}

public class RainFeature : ScriptableRendererFeature
{
    class RainPass : ScriptableRenderPass
    {
        private Material m_Material;
        private Rain m_Rain;
        private RenderTargetHandle m_Temp;
        private float m_Time = 0;

        public RainPass(Material material)
        {
            m_Material = material;
            m_Temp.Init("_RainTemp");
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            m_Rain = VolumeManager.instance.stack.GetComponent<Rain>();
            if (!m_Rain.IsActive()) return;
            var cmd = CommandBufferPool.Get(nameof(RainFeature));
            Apply(m_Rain);
            if (m_Rain.indoors == false && m_Rain.seed != 0) m_Material.SetTexture("_Noise", m_Rain.noise.value);
            var desc = renderingData.cameraData.cameraTargetDescriptor;
            cmd.GetTemporaryRT(m_Temp.id, desc);
            Blit(cmd, renderingData.cameraData.renderer.cameraColorTarget, m_Temp.Identifier(), m_Material, 0);
            Blit(cmd, m_Temp.Identifier(), renderingData.cameraData.renderer.cameraColorTarget);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        private void Apply(Rain rain)
        {
            m_Time += Time.deltaTime * rain.speed.value;
            m_Material.SetColor("_RainColor", rain.color.value);
            m_Material.SetVector("_Wind", rain.wind.value);
        }
    }

    public Material material;
    private RainPass m_Pass;

    public override void Create() => m_Pass = new RainPass(material) { renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing };

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (renderingData.cameraData.isPreviewCamera) return;
        renderer.EnqueuePass(m_Pass);
    }
}
