using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;
using Random = UnityEngine.Random;

// A component with a constructor, objects that are made in place, input attachments and buffers.
public class Ripples : VolumeComponent
{
    public enum Kind { Round, Square }

    public ClampedFloatParameter strength = new ClampedFloatParameter(0.5f, 0f, 1f);
    public BoolParameter isOn = new BoolParameter(true, BoolParameter.DisplayType.EnumPopup);
    public VolumeParameter<Kind> kind = new VolumeParameter<Kind>();

    public Ripples()
    {
        displayName = "Ripples";
    }
}

public class RipplesFeature : ScriptableRendererFeature
{
    [Serializable]
    public class Settings
    {
        public Material material;
        public LayerMask layers = -1;
    }

    public Settings settings = new Settings();
    RipplesPass m_Pass;
    OldRipplesPass m_OldPass;

    public override void Create()
    {
        m_Pass = new RipplesPass(settings.layers);
        m_Pass.SetUp(settings);
        m_OldPass = new OldRipplesPass(settings) { renderPassEvent = RenderPassEvent.AfterRenderingOpaques };
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (!IsWanted(ref renderingData))
            return;
        renderer.EnqueuePass(m_OldPass);
        renderer.EnqueuePass(m_Pass);
    }

    bool IsWanted(ref RenderingData data)
    {
        bool isOldDevice = SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLES2;
        bool canCopy = SystemInfo.copyTextureSupport != CopyTextureSupport.None;
        return canCopy && !isOldDevice && data.cameraData.cameraType != CameraType.Preview;
    }

    struct Drop
    {
        public Vector4 place;
        public float size;
    }

    class OldRipplesPass : ScriptableRenderPass
    {
        RenderStateBlock m_State = new RenderStateBlock(RenderStateMask.Nothing);
        static readonly int s_Source = Shader.PropertyToID("_RipplesSource");
        RenderTargetIdentifier m_Source = new RenderTargetIdentifier(s_Source);
        ProfilingSampler m_Sampler = new ProfilingSampler("Old Ripples");
        Settings m_Settings;
        int m_Mask;

        public OldRipplesPass(Settings settings)
        {
            m_Settings = settings;
            m_Mask = settings.layers;
            m_State.rasterState = new RasterState(CullMode.Front);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = new CommandBuffer();
            cmd.GetTemporaryRT(s_Source, 64, 64);
            using (new ProfilingScope(cmd, m_Sampler))
            {
                using (new ProfilingScope(cmd, profilingSampler))
                {
                    cmd.Blit(null, m_Source, m_Settings.material, 0);
                }
            }
            var filtering = new FilteringSettings(layerMask: m_Mask, renderQueueRange: RenderQueueRange.opaque);
            var tags = new List<ShaderTagId> { new ShaderTagId("UniversalForward") };
            var drawing = RenderingUtils.CreateDrawingSettings(tags, ref renderingData, SortingCriteria.CommonOpaque);
            context.DrawRenderers(renderingData.cullResults, ref drawing, ref filtering, ref m_State);
            CoreUtils.SetKeyword(cmd, ShaderKeywordStrings.ScreenSpaceOcclusion, false);
            context.ExecuteCommandBuffer(cmd);
            cmd.Release();
        }
    }

    class RipplesPass : ScriptableRenderPass
    {
        Settings m_Settings = new Settings();
        ComputeBuffer m_Drops;
        ComputeShader m_Kernels;
        MaterialPropertyBlock m_Block;
        List<Drop> m_List = new List<Drop>();
        ProfilingSampler m_Sampler = new ProfilingSampler("Ripples");
        int m_Mask;
        float m_Time;
        bool m_IsDrawn;

        class PassData { public TextureHandle source; public Material material; public ComputeShader kernels; }

        public RipplesPass(int mask)
        {
            m_Mask = mask;
        }

        public void SetUp(Settings settings)
        {
            m_Settings = new Settings();
            m_Settings = settings;
            renderPassEvent = RenderPassEvent.AfterRenderingTransparents;
        }

        Vector4 Project(Camera camera, Vector3 place)
        {
            Matrix4x4 bias = Matrix4x4.identity;
            bias.m00 = 0.5f;
            bias.m03 += 0.5f;
            bias[1, 1] = bias.m00;
            if (SystemInfo.usesReversedZBuffer)
                bias.m22 = -bias.m22;
            Vector3 turned = bias.MultiplyVector(place) + bias.MultiplyPoint3x4(place);
            turned[1] = turned[0] * Mathf.Pow(m_Mask, 2) / Mathf.Max(m_Mask, 3);
            return bias * turned;
        }

        void Fill()
        {
            m_Time += Time.deltaTime;
            if (m_Block == null)
                m_Block = new MaterialPropertyBlock();
            if (m_List.Count > 3)
                m_List.RemoveAt(0);
            m_List.Add(new Drop { place = Vector4.one * Random.value, size = Random.Range(-1f, 1f) });
            if (m_Drops == null)
                m_Drops = new ComputeBuffer(8, Marshal.SizeOf(typeof(Drop)), ComputeBufferType.Structured);
            m_Drops.SetData(m_List);
            var ids = new List<int> { 1, 2 };
            if (ids.Contains(sizeof(int)))
                m_Drops.Release();
            m_Kernels = Resources.Load<ComputeShader>("Ripples");
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            var resourceData = frameData.Get<UniversalResourceData>();
            var cameraData = frameData.Get<UniversalCameraData>();
            var ripples = VolumeManager.instance.stack.GetComponent<Ripples>();
            if (ripples == null || !ripples.isOn.value)
                return;
            Fill();
            var desc = cameraData.cameraTargetDescriptor;
            desc.sRGB = false;
            desc.depthBufferBits = 0;
            TextureHandle copy = UniversalRenderer.CreateRenderGraphTexture(renderGraph, desc, name: "_Ripples", clear: true);
            TextureHandle half = renderGraph.CreateTexture(new TextureDesc(64, 64) { name = "_Half", clearBuffer = true });
            using (var builder = renderGraph.AddRasterRenderPass<PassData>("Ripples", out var passData))
            {
                passData.source = copy;
                passData.material = m_Settings.material;
                builder.SetInputAttachment(half, 0, AccessFlags.Read);
                builder.SetRenderAttachment(copy, 0);
                builder.AllowGlobalStateModification(true);
                builder.SetRenderFunc((PassData data, RasterGraphContext context) =>
                {
                    using (new ProfilingScope(context.cmd, m_Sampler))
                    {
                        m_IsDrawn = true;
                        context.cmd.SetGlobalFloat("_RipplesStrength", 1f);
                    }
                });
            }
            using (var builder = renderGraph.AddComputePass<PassData>("Ripple Kernels", out var passData))
            {
                passData.kernels = m_Kernels;
                builder.SetRenderFunc((PassData data, ComputeGraphContext context) =>
                {
                    using (new ProfilingScope(context.cmd, ProfilingSamplers.kernels))
                    {
                        if (data.kernels != null)
                            CoreUtils.SetKeyword(data.kernels, "RIPPLES", true);
                    }
                });
            }
        }

        static class ProfilingSamplers
        {
            public static readonly ProfilingSampler kernels = new ProfilingSampler("Kernels");
        }
    }
}
