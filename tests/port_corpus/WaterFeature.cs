using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Game.Rendering.Water
{
    // Settings in settings, defaults of all sorts, passes of a base class of their own.
    [DisallowMultipleRendererFeature("Water")]
    public class WaterFeature : ScriptableRendererFeature
    {
        [Serializable]
        public class Caustics
        {
            [Header("Caustics")]
            [Range(0f, 1f), SerializeField] internal float strength = 0.25f;
            [Tooltip("Metres\nbelow the \"surface\".")] public float depth = 3e1f;
            public Texture2D texture;
            public Gradient ramp = new Gradient();
            public Noise noise = new Noise { scale = 3 };
        }

        [Serializable]
        public struct Noise
        {
            public float scale;
            public Vector2 speed;
            public Vector2Int cells;
        }

        [Serializable]
        public class Surface
        {
            [Min(0)] public int waves = 4;
            [Range(-180, 180)] public int direction = -45;
            public Color shallow = new Color(0.1f, 0.6f, 0.7f, 1.0f), deep = Color.black;
            public AnimationCurve foam = AnimationCurve.Linear(0, 0, 1, 1);
            public double tide = 0.5;
            public long seed = 12345678901L;
            public char letter = 'w';
            public string @class = "water";
            public Mode mode = Mode.Ocean;
            public Mode[] modes = { Mode.Lake, Mode.Ocean };
        }

        public enum Mode { Lake, River = 5, Ocean }

        public Surface surface = new Surface();
        public Caustics caustics = new Caustics();
        [SerializeField] private WaterResources m_Resources = null;
        private SurfacePass m_SurfacePass;
        private CausticsPass m_CausticsPass;
        public event Action<Camera> onRendered;
        public static WaterFeature instance { get; private set; }
        public bool isReady => m_SurfacePass != null;

        public override void Create()
        {
            instance = this;
            m_SurfacePass = new SurfacePass(surface, RenderPassEvent.BeforeRenderingTransparents);
            m_CausticsPass = new CausticsPass(caustics, caustics.noise);
        }

        public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
        {
            if (surface.waves > 0) renderer.EnqueuePass(m_SurfacePass);
            if (caustics.strength > 0f)
            {
                m_CausticsPass.ConfigureInput(ScriptableRenderPassInput.Depth | ScriptableRenderPassInput.Normal);
                renderer.EnqueuePass(m_CausticsPass);
            }
            onRendered?.Invoke(renderingData.cameraData.camera);
        }
    }

    [CreateAssetMenu(menuName = "Water/Resources")]
    public class WaterResources : ScriptableObject
    {
        public Shader surface;
        public Mesh grid;
    }

    abstract class WaterPass : ScriptableRenderPass
    {
        protected readonly string m_Name;
        protected static readonly Plane k_Plane = new Plane(Vector3.up, 0f);
        protected WaterPass(string name, RenderPassEvent when)
        {
            m_Name = name;
            renderPassEvent = when;
            profilingSampler = new ProfilingSampler(name);
        }
        protected abstract void Draw(CommandBuffer cmd, ref RenderingData renderingData);
        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var cmd = CommandBufferPool.Get(m_Name);
            Draw(cmd, ref renderingData);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
    }

    class SurfacePass : WaterPass
    {
        WaterFeature.Surface surface;
        public SurfacePass(WaterFeature.Surface surface, RenderPassEvent when) : base("Water Surface", when) { this.surface = surface; }
        protected override void Draw(CommandBuffer cmd, ref RenderingData renderingData) => cmd.SetGlobalInt("_Waves", surface.waves);
    }

    class CausticsPass : WaterPass
    {
        readonly WaterFeature.Caustics caustics;
        readonly WaterFeature.Noise noise;
        public CausticsPass(WaterFeature.Caustics caustics, WaterFeature.Noise noise) : base("Water Caustics", RenderPassEvent.AfterRenderingOpaques)
        {
            this.caustics = caustics;
            this.noise = noise;
        }
        protected override void Draw(CommandBuffer cmd, ref RenderingData renderingData) => cmd.SetGlobalFloat("_Caustics", caustics.strength * noise.scale);
    }
}
