using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.RenderGraphModule.Util;
using UnityEngine.Rendering.Universal;

// Settings of Unity's enums, and the newer operators of C#.
public class HazeFeature : ScriptableRendererFeature
{
    [Flags] public enum Layers { Near = 1, Far = 2 }

    [Serializable]
    public class Settings
    {
        public CameraType cameras = CameraType.Game | CameraType.SceneView;
        public FilterMode filter = FilterMode.Bilinear;
        public TextureWrapMode wrap = TextureWrapMode.Clamp;
        public RenderTextureFormat format = RenderTextureFormat.ARGBHalf;
        public CullMode cull = CullMode.Back;
        public BlendMode blend = BlendMode.One;
        public Layers layers = Layers.Near | Layers.Far;
        public int layer = 1;
        public string textureName = "_Haze";
        public RenderQueueRange range = RenderQueueRange.all;
        public Material material;
    }

    public Settings settings = new Settings();
    HazePass m_Pass;

    public override void Create()
    {
        m_Pass ??= new HazePass("Haze");
        m_Pass.settings = settings;
        m_Pass.renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (UniversalRenderer.IsOffscreenDepthTexture(ref renderingData.cameraData)
            || (renderingData.cameraData.cameraType & settings.cameras) == 0)
            return;
        renderer.EnqueuePass(m_Pass);
    }

    class HazePass : ScriptableRenderPass
    {
        const string k_Hint = "Haze: " + "assign a material, " + nameof(HazeFeature) + " needs one";
        public Settings settings;
        string m_Name;
        Material m_Other;
        FilteringSettings m_Filtering = FilteringSettings.defaultValue;

        class PassData { public TextureHandle target; public Material material; }

        public HazePass(string name, int level = 2, bool isWarm = true)
        {
            m_Name = name + level;
            profilingSampler = new ProfilingSampler(m_Name);
        }

        [Obsolete]
        public override void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
        {
            cmd.GetTemporaryRT(Shader.PropertyToID(settings.textureName), cameraTextureDescriptor);
        }

        float Falloff(float distance, float scale = 0.5f, int power = 2) => MathF.Pow(distance * scale, power);

        Matrix4x4 Turn(Camera camera, float angle)
        {
            var spin = Quaternion.AngleAxis(angle, Vector3.up) * Quaternion.identity;
            Matrix4x4 view = Matrix4x4.TRS(spin * Vector3.forward, spin, Vector3.one);
            view.SetRow(3, new Vector4(0, 0, 0, 1));
            view.SetColumn(0, view.GetColumn(0));
            Matrix4x4 lens = Matrix4x4.Perspective(60, camera.aspect, 0.1f, 100);
            lens = Matrix4x4.Ortho(0, 1, 0, 1, 0.1f, lens.m00 + lens.m32);
            Matrix4x4 whole = new Matrix4x4(view.GetRow(0), view.GetRow(1), view.GetRow(2), view.GetRow(3));
            return Matrix4x4.Inverse(Matrix4x4.Scale(Vector3.one) * Matrix4x4.Translate(Vector3.zero) * whole * lens);
        }

        void Pyramid(CommandBuffer cmd, RenderTargetIdentifier source, RTHandle target, int count)
        {
            var levels = new int[count];
            List<int> others = new List<int>();
            for (int i = 0; i < count; i++)
            {
                levels[i] = Shader.PropertyToID("_HazeLevel" + i);
                others.Add(Shader.PropertyToID("_HazeOther" + i));
                cmd.GetTemporaryRT(levels[i], 8 << i, 8 << i, 0, settings.filter, settings.format);
                int from = i > 0 ? levels[i - 1] : levels[i];
                cmd.Blit(from, levels[i], m_Other, 0);
            }
            CoreUtils.SetRenderTarget(cmd, source, RenderBufferLoadAction.DontCare, RenderBufferStoreAction.Store);
            CoreUtils.SetRenderTarget(cmd, target, RenderBufferLoadAction.Load, RenderBufferStoreAction.Store, ClearFlag.None, Color.clear);
        }

        int Groups(ComputeShader kernels, int width)
        {
            kernels.GetKernelThreadGroupSizes(0, out uint x, out _, out uint _);
            return Mathf.CeilToInt(width / (float)x);
        }

        void Ask(ScriptableRenderContext context)
        {
            context.Submit();
            uint mask = (uint)1 << settings.layer;
            m_Filtering = new FilteringSettings(RenderQueueRange.all, -1, mask);
            settings.range.lowerBound = 10;
            bool isNamed = !string.IsNullOrWhiteSpace(settings.textureName);
            bool isLinear = QualitySettings.activeColorSpace == ColorSpace.Linear;
            bool canBlend = SystemInfo.IsFormatSupported(GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormatUsage.Linear | GraphicsFormatUsage.Render);
            if (SystemInfo.supportsComputeShaders && isNamed && isLinear && canBlend)
                Shader.SetGlobalFloat("_HazeFar", float.MaxValue);
            Shader.SetGlobalInteger("_HazeOn", Convert.ToInt32(isNamed));
        }

        public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
        {
            var resourceData = frameData.Get<UniversalResourceData>();
            var stack = VolumeManager.instance?.stack;
            var material = settings.material ?? m_Other;
            if (material == null)
            {
                Debug.LogWarning(k_Hint);
                return;
            }
            m_Other ??= new Material(material.shader);
            var shader = m_Other?.shader;
            if (shader != null)
                material.SetFloat("_Falloff", Falloff(2f));
            TextureHandle motion = resourceData.motionVectorColor;
            if (motion.IsValid())
                return;
            var desc = resourceData.activeColorTexture.GetDescriptor(renderGraph);
            desc.name = material.name;
            desc.clearBuffer = false;
            TextureHandle haze = renderGraph.CreateTexture(desc);
            var blit = new RenderGraphUtils.BlitMaterialParameters(resourceData.activeColorTexture, haze, material, 0);
            blit.sourceTexturePropertyID = Shader.PropertyToID("_HazeSource");
            renderGraph.AddBlitPass(blit, passName: "Haze");
            using (var builder = renderGraph.AddUnsafePass<PassData>("Haze Copy", out var passData))
            {
                passData.target = haze;
                passData.material = material;
                builder.UseTexture(haze, AccessFlags.ReadWrite);
                builder.AllowPassCulling(false);
                builder.SetRenderFunc((PassData data, UnsafeGraphContext context) =>
                {
                    CommandBuffer cmd = CommandBufferHelpers.GetNativeCommandBuffer(context.cmd);
                    cmd.SetRenderTarget(data.target, RenderBufferLoadAction.Load, RenderBufferStoreAction.Store);
                });
            }
            renderGraph.AddBlitPass(haze, resourceData.activeColorTexture, Vector2.one, Vector2.zero, passName: "Haze Back");
        }
    }
}
