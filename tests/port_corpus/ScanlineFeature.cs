using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

// A partial class, properties, interfaces, generics, delegates, overloads, names that C++ keeps.
public interface IScanline { float Speed { get; } void Tick(float delta); }

public delegate void ScanlineEvent(float row);

public partial class ScanlineFeature : ScriptableRendererFeature
{
    [SerializeField] float speed = 1.25f;
    [SerializeField] private Material material;
    public string name2 = "scan" + "line";
    public bool template, typename = true;
    public int register = 3, auto = 0x1F;
    public float union = 1e-3f, xor = -.5f, EOF = 2;
    public RenderPassEvent operatorEvent = (RenderPassEvent)300;
    public float? optional = null;
    public int[][] rows;
    public float[,] grid = new float[2, 2];
    public Func<float, float> curve = x => x * x;
    public static readonly Color s_Default = new Color(0, 1, 0);
    const float k_Half = 1f / 2f;
    const int k_Sum = 1 + 2 * 3;
    ScanlinePass pass;
    Queue<ScanlinePass> passes = new Queue<ScanlinePass>();
}

public partial class ScanlineFeature
{
    public enum NULL { and, or, not, assert }

    public NULL Null = NULL.not;

    ScanlineFeature() { }

    public float Speed
    {
        get { return speed; }
        set { speed = value < 0 ? 0 : value; }
    }

    public override void Create()
    {
        pass = new ScanlinePass(material, speed);
        pass.renderPassEvent = RenderPassEvent.AfterRendering;
    }

    public override void AddRenderPasses(ScriptableRenderer class_, ref RenderingData struct_)
    {
        class_.EnqueuePass(pass);
    }

    public void Dispose() { pass = null; }
    public void Set(Texture a) { }
    public void Set(Texture2D a) { }
    public void Set(Material a, float b = 1f) { }
    void Configure(bool on) { }
    static int Twice(int i) => i * 2;
    IEnumerator Run() { yield return null; }
    Material Find(string name, int index) { return material; }
    RenderQueueRange Range() { return RenderQueueRange.all; }
    RenderStateBlock Block() { return new RenderStateBlock(RenderStateMask.Nothing); }
    public static implicit operator bool(ScanlineFeature f) => f != null;
    public float this[int i] => i * speed;
    ~ScanlineFeature() { }

    class ScanlinePass : ScriptableRenderPass, IScanline
    {
        readonly Material material;
        readonly Stack<RTHandle> handles = new Stack<RTHandle>();
        RenderQueueRange range;
        RenderQueueRange opaque = RenderQueueRange.opaque;
        ProfilingSampler sampler, unnamed = new(nameof(ScanlinePass));
        ScriptableRenderer renderer;
        event ScanlineEvent onRow;
        float time;

        public float Speed { get; private set; } = 2f;
        protected internal virtual int count { get; set; }

        public ScanlinePass(Material material, float speed) : this(material)
        {
            Speed = speed;
        }

        ScanlinePass(Material material)
        {
            this.material = material;
            base.renderPassEvent = RenderPassEvent.BeforeRenderingSkybox + 2;
        }

        public void Tick(float delta) { time += delta; onRow?.Invoke(time); }
        public void Configure(RTHandle handle) { handles.Push(handle); }
        public bool Execute(ref RenderingData data, float when) { return when > 0; }
        bool Execute(string a, int b) => false;
        T Pick<T>(List<T> from) where T : class => from.Count > 0 ? from[0] : null;

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            var cmd = CommandBufferPool.Get($"Scanline {time:0.00} of {(count > 1 ? "many" : "one")}");
            cmd.SetGlobalFloat("_Time2", time);
            var verbatim = @"C:\temp\";
            var raw = """
                a "raw" text \
                """;
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }
    }
}
