#define WITH_FOG
using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

/* A fog as of URP 14: RTHandles, a volume component, Blitter. Written for limn's tests. */
public enum FogMode { Linear, Exponential }

[Serializable]
public sealed class FogModeParameter : VolumeParameter<FogMode>
{
    public FogModeParameter(FogMode value, bool overrideState = false) : base(value, overrideState) { }
}

[Serializable, VolumeComponentMenuForRenderPipeline("Custom/Height Fog", typeof(UniversalRenderPipeline))]
public class HeightFog : VolumeComponent, IPostProcessComponent
{
    [Tooltip("How thick.")] public ClampedFloatParameter density = new ClampedFloatParameter(0f, 0f, 1f);
    public FloatParameter height = new FloatParameter(10);
    public ColorParameter color = new ColorParameter(Color.grey, true, false, true);
    public FogModeParameter mode = new FogModeParameter(FogMode.Exponential);
    public MinIntParameter steps = new(4, 1, overrideState: true);
    public TextureParameter noise = new TextureParameter(null);

    public bool IsActive() => density.value > 0f && (height.value != 0f || !active);
    public bool IsTileCompatible() { return false; }
}

public class HeightFogFeature : ScriptableRendererFeature
{
    [SerializeField] private RenderPassEvent m_Event = RenderPassEvent.BeforeRenderingPostProcessing;
    [SerializeField, Range(0f, 1f)] float m_Strength = .5f;
    [SerializeField] bool m_InSceneView;
    [SerializeField] Material m_Material;
    [SerializeField] string[] m_Tags = { "UniversalForward" };
    [SerializeField] Vector3 m_Wind = new Vector3(1, 0, 0);
    private HeightFogPass m_FogPass;

    public override void Create()
    {
        m_FogPass = new HeightFogPass(m_Event, m_Strength, "Height Fog") { };
#if UNITY_6000_0_OR_NEWER
        m_FogPass.requiresIntermediateTexture = true;
#elif WITH_FOG && UNITY_2021_2_OR_NEWER
        m_FogPass.ConfigureInput(ScriptableRenderPassInput.Depth | ScriptableRenderPassInput.Color);
#else
        unbalanced { here
#endif
    }

    public override void SetupRenderPasses(ScriptableRenderer renderer, in RenderingData renderingData)
    {
        m_FogPass.SetTarget(renderer.cameraColorTargetHandle);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        var fog = VolumeManager.instance.stack.GetComponent<HeightFog>();
        if (renderingData.cameraData.cameraType == CameraType.Preview || fog == null || !fog.IsActive()) return;
        m_FogPass.fog = fog;
        renderer.EnqueuePass(m_FogPass);
    }

    protected override void Dispose(bool disposing) => m_FogPass?.Dispose();
}

public class HeightFogPass : ScriptableRenderPass
{
    public HeightFog fog;
    private readonly float strength;
    private RTHandle m_Target, m_Copy;
    private Material m_Material;
    private static readonly int FogColor = Shader.PropertyToID("_FogColor");

    public HeightFogPass(RenderPassEvent renderPassEvent, float strength, string name)
    {
        this.renderPassEvent = renderPassEvent + 1;
        this.strength = strength * 2;
        profilingSampler = new ProfilingSampler(nameof(HeightFogPass));
    }

    public void SetTarget(RTHandle target) => m_Target = target;

    public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
    {
        RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
        descriptor.depthBufferBits = (int)DepthBits.None;
        RenderingUtils.ReAllocateIfNeeded(ref m_Copy, descriptor, FilterMode.Point, name: "_FogCopy");
    }

    public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
    {
        var cmd = CommandBufferPool.Get();
        using (new ProfilingScope(cmd, profilingSampler))
        {
            m_Material.SetColor(FogColor, fog.color.value);
            m_Material.SetVector("_Parameters", new Vector4(fog.density.value, fog.height.value, Time.time, 0));
            CoreUtils.SetKeyword(m_Material, "_LINEAR", fog.mode.value == FogMode.Linear);
            Blitter.BlitCameraTexture(cmd, m_Target, m_Copy);
            Blitter.BlitCameraTexture(cmd, m_Copy, m_Target, m_Material, 0);
            cmd.DrawProcedural(Matrix4x4.identity, m_Material, 0, MeshTopology.Quads, 4, 1);
        }
        context.ExecuteCommandBuffer(cmd);
        CommandBufferPool.Release(cmd);
    }

    public void Dispose() { m_Copy?.Release(); }
}

public class FogVolumeGizmo : MonoBehaviour
{
    void Update() { transform.position = Vector3.zero; }
}
