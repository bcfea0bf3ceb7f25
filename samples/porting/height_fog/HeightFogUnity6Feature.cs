using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RenderGraphModule.Util;
using UnityEngine.Rendering.Universal;

// As one writes it for Unity 6: one blit, whose destination becomes the camera's colour.
public class HeightFogUnity6Feature : ScriptableRendererFeature
{
    class HeightFogPass : ScriptableRenderPass
    {
        static readonly int s_Density = Shader.PropertyToID("_FogDensity");
        static readonly int s_BaseHeight = Shader.PropertyToID("_FogBaseHeight");
        static readonly int s_Falloff = Shader.PropertyToID("_FogFalloff");
        static readonly int s_Color = Shader.PropertyToID("_FogColor");

        readonly Material m_Material;

        public HeightFogPass(Shader shader)
        {
            m_Material = CoreUtils.CreateEngineMaterial(shader);
            renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing;
            ConfigureInput(ScriptableRenderPassInput.Depth);
        }

        public void Setup(HeightFog fog)
        {
            m_Material.SetFloat(s_Density, fog.density.value);
            m_Material.SetFloat(s_BaseHeight, fog.baseHeight.value);
            m_Material.SetFloat(s_Falloff, fog.falloff.value);
            m_Material.SetColor(s_Color, fog.color.value);
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            UniversalResourceData resourceData = frameData.Get<UniversalResourceData>();
            if (resourceData.isActiveTargetBackBuffer)
            {
                return;
            }

            TextureHandle source = resourceData.activeColorTexture;
            TextureDesc descriptor = renderGraph.GetTextureDesc(source);
            descriptor.name = "_HeightFogColor";
            descriptor.clearBuffer = false;
            TextureHandle destination = renderGraph.CreateTexture(descriptor);

            RenderGraphUtils.BlitMaterialParameters parameters = new(source, destination, m_Material, 1);
            renderGraph.AddBlitPass(parameters, "Height Fog");
            resourceData.cameraColor = destination;
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
        HeightFog fog = VolumeManager.instance.stack.GetComponent<HeightFog>();
        if (!fog.IsActive() || !renderingData.cameraData.postProcessEnabled)
        {
            return;
        }
        m_Pass.Setup(fog);
        renderer.EnqueuePass(m_Pass);
    }
}
