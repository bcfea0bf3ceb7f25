using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 8: a pyramid of temporary textures, whose names stand in an array and a list of ints.
public class DualBlurFeature : ScriptableRendererFeature
{
    [Serializable]
    public struct Settings
    {
        [Range(0.0f, 15.0f)] public float blurRadius;
        [Range(1, 10)] public int iteration;
        [Min(1f)] public float downScaling;
        public RenderPassEvent passEvent;
        public Shader shader;
    }

    struct Level
    {
        internal int down;
        internal int up;
    }

    class DualBlurPass : ScriptableRenderPass
    {
        const int k_MaxPyramidSize = 16;
        const string k_Tag = "Dual Blur";
        readonly Settings settings;
        readonly Material material;
        Level[] pyramid;
        int[] downNames = new int[k_MaxPyramidSize];
        List<int> upNames = new List<int>();
        int offsetId;
        RenderTargetIdentifier source;

        public DualBlurPass(Settings settings, Material material, int offsetName)
        {
            this.settings = settings;
            this.material = material;
            offsetId = offsetName;
            renderPassEvent = settings.passEvent;
            pyramid = new Level[k_MaxPyramidSize];
            for (int i = 0; i < k_MaxPyramidSize; i++)
            {
                downNames[i] = Shader.PropertyToID("_BlurMipDown" + i);
                upNames.Add(Shader.PropertyToID("_BlurMipUp" + i));
                pyramid[i] = new Level { down = downNames[i], up = upNames[i] };
            }
        }

        public void Setup(RenderTargetIdentifier source) => this.source = source;

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get(k_Tag);
            var desc = renderingData.cameraData.cameraTargetDescriptor;
            int tw = (int)(desc.width / settings.downScaling);
            int th = (int)(desc.height / settings.downScaling);
            material.SetFloat(offsetId, settings.blurRadius);
            RenderTargetIdentifier last = source;
            for (int i = 0; i < settings.iteration; i++)
            {
                GetLevel(cmd, pyramid[i].down, tw, th);
                GetLevel(cmd, pyramid[i].up, tw, th);
                cmd.Blit(last, pyramid[i].down, material, 0);
                last = pyramid[i].down;
                tw = Mathf.Max(tw / 2, 1);
                th = Mathf.Max(th / 2, 1);
            }
            for (int i = settings.iteration - 2; i >= 0; i--)
            {
                cmd.Blit(last, pyramid[i].up, material, 1);
                last = pyramid[i].up;
            }
            cmd.Blit(last, source, material, 1);
            for (int i = 0; i < settings.iteration; i++)
            {
                cmd.ReleaseTemporaryRT(pyramid[i].down);
                cmd.ReleaseTemporaryRT(pyramid[i].up);
            }
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        static void GetLevel(CommandBuffer cmd, int name, int width, int height)
        {
            cmd.GetTemporaryRT(name, width, height, 0, FilterMode.Bilinear, RenderTextureFormat.DefaultHDR);
        }
    }

    public Settings settings = new Settings { iteration = 4, downScaling = 2f };
    private DualBlurPass pass;
    private Material material;

    public override void Create()
    {
        material = CoreUtils.CreateEngineMaterial(settings.shader);
        pass = new DualBlurPass(settings, material, Shader.PropertyToID("_Offset"));
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        pass.Setup(renderer.cameraColorTarget);
        renderer.EnqueuePass(pass);
    }
}
