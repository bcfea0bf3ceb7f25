using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// Between the styles: identifiers inside RTHandles, methods with a base call, the old handle beside the new one.
public class VeilFeature : ScriptableRendererFeature
{
    private const string ShaderName = "Hidden/Veil";

    [SerializeField] private Shader shader;
    [Header("Timing")]
    [SerializeField] private RenderPassEvent passEvent = RenderPassEvent.BeforeRenderingPostProcessing;
    [SerializeField, Range(0, 4)] private int eventOffset = 0;
    [Header("Veil"), Space]
    [SerializeField, ColorUsage(true)] private Color tint = new(0.2f, 0.2f, 0.2f, 1f);
    [SerializeField, Min(0.01f)] private float distance = 20;

    private VeilPass veilPass;
    private Material veilMaterial;

    private void OnEnable() => shader = shader ? shader : Shader.Find(ShaderName);
    private void OnDisable() => CoreUtils.Destroy(veilMaterial);
    private void OnValidate() { distance = Mathf.Max(distance, 0.01f); }

    public override void Create()
    {
        veilPass = new VeilPass(shader, new Color(1, 1, 1));
        veilPass.renderPassEvent = passEvent + eventOffset;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (!TryPrepare(ref renderingData, out var reason)) { Debug.LogErrorFormat("{0}: {1}", name, reason); return; }
        veilPass.Prepare(veilMaterial, tint, distance);
        renderer.EnqueuePass(veilPass);
    }

    private bool TryPrepare(ref RenderingData renderingData, out string reason)
    {
        reason = renderingData.cameraData.requiresDepthTexture ? "" : "no depth texture";
        veilMaterial ??= CoreUtils.CreateEngineMaterial(shader);
        return reason.Length == 0;
    }

    private class VeilPass : ScriptableRenderPass
    {
        private static readonly int TintId = Shader.PropertyToID("_Tint");
        private static readonly int DistanceId = Shader.PropertyToID("_Distance");
        private readonly int tempId = Shader.PropertyToID("_VeilTemp");
        private static readonly GlobalKeyword s_Keyword = GlobalKeyword.Create("_VEIL");
        private LocalKeyword local;
        private Material material;
        private Shader shader;
        private RenderTargetIdentifier tempTarget;

        public VeilPass(Shader shader, Color start)
        {
            this.shader = shader;
            tempTarget = new RenderTargetIdentifier(tempId);
            profilingSampler = new ProfilingSampler(ShaderName);
        }

        public void Prepare(Material material, Color tint, float distance)
        {
            this.material = material;
            material.SetColor(TintId, tint);
            material.SetFloat(DistanceId, distance);
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            base.OnCameraSetup(cmd, ref renderingData);
            var desc = renderingData.cameraData.cameraTargetDescriptor;
            Allocate(cmd, tempId, desc, FilterMode.Bilinear);
        }

        private static void Allocate(CommandBuffer cmd, int nameID, RenderTextureDescriptor desc, FilterMode mode)
        {
            desc.depthBufferBits = 0;
            desc.msaaSamples = 1;
            cmd.GetTemporaryRT(nameID, desc, mode);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (material is null) return;
            CommandBuffer cmd = CommandBufferPool.Get(ShaderName);
            CoreUtils.SetKeyword(cmd, "_VEIL_ORTHO", renderingData.cameraData.camera.orthographic);
            cmd.Blit(renderingData.cameraData.renderer.cameraColorTarget, tempTarget, material);
            cmd.Blit(tempTarget, BuiltinRenderTextureType.CameraTarget);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public override void OnCameraCleanup(CommandBuffer cmd) => cmd.ReleaseTemporaryRT(tempId);
        public override void OnFinishCameraStackRendering(CommandBuffer cmd) { material = null; }
    }
}
