using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

[Serializable, VolumeComponentMenu("Post-processing/Height Fog")]
public class HeightFog : VolumeComponent, IPostProcessComponent
{
    public ClampedFloatParameter density = new ClampedFloatParameter(0f, 0f, 1f);
    public FloatParameter baseHeight = new FloatParameter(0f);
    public MinFloatParameter falloff = new MinFloatParameter(0.5f, 0.001f);
    public ColorParameter color = new ColorParameter(Color.gray);

    public bool IsActive()
    {
        return density.value > 0f;
    }

    public bool IsTileCompatible()
    {
        return false;
    }
}

// As one wrote it for URP 12: a volume component, the depth texture, and the picture there and back.
public class HeightFogFeature : ScriptableRendererFeature
{
    class HeightFogPass : ScriptableRenderPass
    {
        static readonly int s_Density = Shader.PropertyToID("_FogDensity");
        static readonly int s_BaseHeight = Shader.PropertyToID("_FogBaseHeight");
        static readonly int s_Falloff = Shader.PropertyToID("_FogFalloff");
        static readonly int s_Color = Shader.PropertyToID("_FogColor");

        readonly ProfilingSampler m_ProfilingSampler = new ProfilingSampler("Height Fog");
        readonly Material m_Material;
        RenderTargetHandle m_Temporary;

        public HeightFogPass(Shader shader)
        {
            m_Material = CoreUtils.CreateEngineMaterial(shader);
            m_Temporary.Init("_HeightFogTemporary");
            renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing;
            ConfigureInput(ScriptableRenderPassInput.Depth);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            VolumeStack stack = VolumeManager.instance.stack;
            HeightFog fog = stack.GetComponent<HeightFog>();
            if (!fog.IsActive() || !renderingData.cameraData.postProcessEnabled)
            {
                return;
            }

            m_Material.SetFloat(s_Density, fog.density.value);
            m_Material.SetFloat(s_BaseHeight, fog.baseHeight.value);
            m_Material.SetFloat(s_Falloff, fog.falloff.value);
            m_Material.SetColor(s_Color, fog.color.value);

            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, m_ProfilingSampler))
            {
                RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
                descriptor.depthBufferBits = 0;
                descriptor.msaaSamples = 1;
                RenderTargetIdentifier source = renderingData.cameraData.renderer.cameraColorTarget;
                cmd.GetTemporaryRT(m_Temporary.id, descriptor, FilterMode.Point);
                Blit(cmd, source, m_Temporary.Identifier(), m_Material, 0);
                Blit(cmd, m_Temporary.Identifier(), source);
                cmd.ReleaseTemporaryRT(m_Temporary.id);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
    }

    public Shader shader;
    HeightFogPass m_Pass;

    public override void Create()
    {
        m_Pass = new HeightFogPass(shader);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        renderer.EnqueuePass(m_Pass);
    }
}
