using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// A blur as of URP 8: identifiers, temporary textures, cmd.Blit. Written for limn's tests.
namespace Limn.Samples
{
    public class BlurOld : ScriptableRendererFeature
    {
        public enum Quality { Low = 1, High = 1 << 2, Both = Low | High }

        [System.Serializable]
        public class BlurSettings
        {
            [Header("Blur"), Tooltip("How often it is blurred.")]
            [Range(1, 8)] public int passes = 2;
            [Min(0.5f)] public float radius = 1.5f;
            public Quality quality = Quality.High;
            public RenderPassEvent when = RenderPassEvent.AfterRenderingTransparents - 1;
            public Color tint = new Color(1f, 0.5f, 0, 1);
            public LayerMask layers = -1;
            public Shader shader = null;
            public string targetName = "_Blurred";
            public AnimationCurve curve;
            [System.NonSerialized] public int frame;
            private int m_Hidden = 3;
        }

        class BlurPass : ScriptableRenderPass
        {
            const string k_Tag = "Blur \"old\"";
            static readonly int s_Tint = Shader.PropertyToID("_Tint");
            private Material material;
            private int passes, downsample = 2;
            private RenderTargetIdentifier source { get; set; }
            private RenderTargetHandle temporary;
            private RenderTargetHandle[] chain = new RenderTargetHandle[4];
            readonly List<ShaderTagId> tags = new List<ShaderTagId> { new ShaderTagId("UniversalForward"), new ShaderTagId("SRPDefaultUnlit") };

            public BlurPass(Material material, int passes)
            {
                this.material = material;
                this.passes = passes;
                profilingSampler = new ProfilingSampler(k_Tag);
            }

            public void Setup(RenderTargetIdentifier source) { this.source = source; }

            public override void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
            {
                cmd.GetTemporaryRT(temporary.id, cameraTextureDescriptor.width / downsample, -1, 0, FilterMode.Bilinear, RenderTextureFormat.ARGB32);
                ConfigureTarget(temporary.Identifier());
                ConfigureClear(ClearFlag.All, Color.black);
            }

            public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
            {
                if (renderingData.cameraData.isSceneViewCamera) return;
                CommandBuffer cmd = CommandBufferPool.Get($"{k_Tag} {renderingData.cameraData.camera.orthographicSize:0.0}");
                for (int i = 0; i < passes; i++)
                {
                    cmd.SetGlobalFloat("_Offset", 0.5f + i);
                    cmd.Blit(source, temporary.Identifier(), material, 0);
                    cmd.Blit(temporary.Identifier(), source);
                }
                cmd.SetRandomWriteTarget("_Nothing", null);
                cmd.FrobnicateTwice(1);
                context.ExecuteCommandBuffer(cmd);
                CommandBufferPool.Release(cmd);
                Wobble(cmd);
            }

            public override void FrameCleanup(CommandBuffer cmd)
            {
                cmd.ReleaseTemporaryRT(temporary.id); // ends with \
            }
        }

        public BlurSettings settings = new BlurSettings();
        BlurPass m_Pass;

        public override void Create()
        {
            var material = CoreUtils.CreateEngineMaterial(settings.shader);
            m_Pass = new BlurPass(material, settings.passes);
            m_Pass.renderPassEvent = settings.when;
        }

        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
        {
            m_Pass.Setup(renderer.cameraColorTarget);
            renderer.EnqueuePass(m_Pass);
        }
    }
}
