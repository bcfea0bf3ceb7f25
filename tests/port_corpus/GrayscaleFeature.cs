using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Effects
{
    // URP 7: Shader.Find, numbers of properties in static ints, a volume component of the stack.
    public class GrayscaleFeature : ScriptableRendererFeature
    {
        GrayscalePass grayscalePass;

        public override void Create()
        {
            grayscalePass = new GrayscalePass(RenderPassEvent.BeforeRenderingPostProcessing);
        }

        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
        {
            grayscalePass.Setup(renderer.cameraColorTarget);
            renderer.EnqueuePass(grayscalePass);
        }
    }

    [System.Serializable, VolumeComponentMenu("Effects/Grayscale")]
    public class Grayscale : VolumeComponent, IPostProcessComponent
    {
        [Tooltip("What, all of it??! 1 is gray.")]
        public ClampedFloatParameter blend = new ClampedFloatParameter(0f, 0f, 1f);
        public ColorParameter tint = new ColorParameter(Color.white);

        public bool IsActive() => blend.value > 0f && blend.overrideState;
        public bool IsTileCompatible() => false;
    }

    public class GrayscalePass : ScriptableRenderPass
    {
        static readonly string k_RenderTag = "Render Grayscale";
        static readonly int MainTexId = Shader.PropertyToID("_MainTex");
        static readonly int TempTargetId = Shader.PropertyToID("_TempTargetGrayscale");
        static readonly int BlendId = Shader.PropertyToID("_Blend");
        Grayscale grayscale;
        Material grayscaleMaterial;
        RenderTargetIdentifier currentTarget;

        public GrayscalePass(RenderPassEvent evt)
        {
            renderPassEvent = evt;
            var shader = Shader.Find("PostEffect/Grayscale");
            if (shader == null)
            {
                Debug.LogError("Shader not found.");
                return;
            }
            grayscaleMaterial = CoreUtils.CreateEngineMaterial(shader);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            if (grayscaleMaterial == null || !renderingData.cameraData.postProcessEnabled) return;
            var stack = VolumeManager.instance.stack;
            grayscale = stack.GetComponent<Grayscale>();
            if (grayscale == null || !grayscale.IsActive()) { return; }
            var cmd = CommandBufferPool.Get(k_RenderTag);
            Render(cmd, ref renderingData);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public void Setup(in RenderTargetIdentifier currentTarget)
        {
            this.currentTarget = currentTarget;
        }

        void Render(CommandBuffer cmd, ref RenderingData renderingData)
        {
            ref var cameraData = ref renderingData.cameraData;
            var source = currentTarget;
            int destination = TempTargetId;
            var w = cameraData.camera.scaledPixelWidth;
            var h = cameraData.camera.scaledPixelHeight;
            grayscaleMaterial.SetFloat(BlendId, grayscale.blend.value);
            cmd.SetGlobalTexture(MainTexId, source);
            cmd.GetTemporaryRT(destination, w, h, 0, FilterMode.Point, RenderTextureFormat.Default);
            cmd.Blit(source, destination);
            cmd.Blit(destination, source, grayscaleMaterial, 0);
        }
    }
}
