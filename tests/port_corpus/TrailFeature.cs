using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// URP 14: last frame's texture and this one's take turns, one pair a camera, in a format of its own.
public class TrailFeature : ScriptableRendererFeature
{
    [System.Serializable]
    public class TrailSettings
    {
        [Header("Trail"), Range(0f, 1f), Tooltip("What is left of the last frame.")]
        public float persistence = .9f;
        [Space(10)] public Vector4 drift = new Vector4(0, 0.001f, 0, 0);
        public Vector2 size = new Vector2(.5f, .5f);
        public GraphicsFormat format = GraphicsFormat.B10G11R11_UFloatPack32;
        [SerializeField] private int m_Version = 2;
        public int version => m_Version;
    }

    private class History
    {
        public RTHandle[] handles = new RTHandle[2];
        public int current;
        public bool isFilled = false;

        public RTHandle Write() => handles[current];
        public RTHandle Read() => handles[1 - current];
        public void Swap() { current = 1 - current; }
        public void Release()
        {
            foreach (var handle in handles) handle?.Release();
        }
    }

    public TrailSettings settings = new();
    [SerializeField] private Shader shader;
    private Material _material;
    private TrailPass _pass;

    public override void Create()
    {
        _pass = new TrailPass(settings);
        _pass.renderPassEvent = RenderPassEvent.BeforeRenderingPostProcessing - 1;
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        _material = _material != null ? _material : CoreUtils.CreateEngineMaterial(shader);
        _pass.Setup(_material);
        renderer.EnqueuePass(_pass);
    }

    protected override void Dispose(bool disposing)
    {
        _pass.Clear();
        CoreUtils.Destroy(_material);
    }

    class TrailPass : ScriptableRenderPass
    {
        private static class Ids
        {
            public static readonly int History = Shader.PropertyToID("_TrailHistory");
            public static readonly int Persistence = Shader.PropertyToID("_Persistence");
            public const int CombinePass = 0;
            public const int CopyPass = 1;
        }

        private readonly TrailSettings m_Settings;
        private readonly Dictionary<Camera, History> m_Histories = new Dictionary<Camera, History>();
        private History m_History;
        private Material m_Material;
        private int m_Pass = Ids.CopyPass;

        public TrailPass(TrailSettings settings) => m_Settings = settings;

        public void Setup(Material material) { m_Material = material; }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            var camera = renderingData.cameraData.camera;
            if (!m_Histories.TryGetValue(camera, out m_History))
            {
                m_History = new History();
                m_Histories.Add(camera, m_History);
            }
            var desc = renderingData.cameraData.cameraTargetDescriptor;
            desc.depthBufferBits = 0;
            desc.graphicsFormat = m_Settings.format;
            for (int i = 0; i < 2; i++)
                RenderingUtils.ReAllocateIfNeeded(ref m_History.handles[i], m_Settings.size, desc, FilterMode.Bilinear, TextureWrapMode.Mirror, name: $"_Trail{i}");
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var cmd = CommandBufferPool.Get("Trail");
            var color = renderingData.cameraData.renderer.cameraColorTargetHandle;
            m_Material.SetTexture(Ids.History, m_History.Read());
            m_Material.SetFloat(Ids.Persistence, m_Settings.persistence);
            Blitter.BlitCameraTexture(cmd, color, m_History.Write(), m_Material, Ids.CombinePass);
            Blitter.BlitCameraTexture(cmd, m_History.Write(), color, m_Material, m_Pass);
            m_History.Swap();
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public void Clear()
        {
            foreach (var pair in m_Histories) pair.Value.Release();
            m_Histories.Clear();
        }
    }
}
