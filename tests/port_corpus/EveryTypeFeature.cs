using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

// Every type that limn carries over, as a field, a list, a parameter and a result.
public class EveryTypeFeature : ScriptableRendererFeature
{
    [System.Serializable] public class Own { public int a; public Own next; public List<Own> more; public Kind kind; }
    public enum Kind { One, Two }
    [System.Serializable] public struct Value { public float x; public Own shared; }
    public class Derived : Own { public float b = 1; public Value[] values = { new Value(), new Value() }; }
    public static class Numbers { public const int A = 1; public static int B = A; public static readonly Vector3 C = new Vector3(0, 1, 2); }

    public Own own = new Own();
    public Derived derived = new Derived();
    public Value[] valueArray = new Value[] { new Value() };
    public List<Own> ownList = new List<Own> { new Own(), new Own() };
    public Kind kind = Kind.Two;
    public int number = Numbers.A + 1;
    public RenderQueueType queueType = RenderQueueType.Transparent;
    public StencilStateData stencilData = new StencilStateData();
    public Vector2 tiling = new Vector2(1, 2);
    public Vector3 wind = Vector3.up;
    public Texture2D noise;
    public Cubemap sky;
    public RenderTexture target;
    public ComputeShader kernels;
    EveryPass m_Pass;

    public override void Create() { m_Pass = new EveryPass(new Own(), own, default, 3); }
    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData) { renderer.EnqueuePass(m_Pass); }
    void Take(EveryPass.Inner inner, EveryPass pass) { }

    class EveryPass : ScriptableRenderPass
    {
        public struct Inner { public int id; public Own own; public EveryPass pass; }

        Own made = new Own();
        Own shared;
        Inner inner;
        Value value = new Value { x = 2 };
        int i; uint u; float f; double d; bool b; string s; long l; byte y; char c; object o;
        Color color; Color32 color32; Vector2 v2; Vector3 v3; Vector4 v4; Vector2Int v2i; Vector3Int v3i; Matrix4x4 m; Quaternion q; Rect r; Bounds bounds;
        LayerMask layers; RenderingLayerMask renderingLayers; RenderPassEvent when; RenderQueueRange queues;
        Material material; Shader shader; Texture texture; Texture2D texture2D; Texture3D texture3D; Cubemap cube; RenderTexture renderTexture; Mesh mesh;
        ComputeShader compute; GraphicsBuffer buffer; ComputeBuffer computeBuffer; MaterialPropertyBlock block;
        RTHandle handle; RenderTargetIdentifier identifier; RenderTargetHandle oldHandle; RendererList list;
        TextureHandle textureHandle; BufferHandle bufferHandle; RendererListHandle listHandle; TextureDesc desc; RenderTextureDescriptor descriptor;
        FilteringSettings filtering; DrawingSettings drawing; SortingSettings sorting; SortingCriteria criteria; RenderStateBlock state;
        StencilState stencil; DepthState depth; BlendState blend; RasterState raster; BlendMode mode; CullMode cull; CompareFunction compare; StencilOp op;
        ShaderTagId tag; FilterMode filter; TextureWrapMode wrap; GraphicsFormat format; RenderTextureFormat oldFormat; ClearFlag clear; CameraType cameraType;
        ScriptableRenderPassInput inputs; ProfilingSampler sampler; Camera camera; Light light; Transform transform; GameObject gameObject; AnimationCurve curve;
        static RTHandle s_Handle; static Material s_Material; static readonly ShaderTagId[] s_Tags = { new ShaderTagId("A") }; static ProfilingSampler s_Sampler = new ProfilingSampler("S");
        RTHandle[] handles = new RTHandle[4]; List<ShaderTagId> tags = new(); Material[] materials; List<RenderTargetIdentifier> targets; List<List<float>> nested; Dictionary<int, Own> map;
        RenderQueueRange[] ranges; ProfilingSampler[] samplers; bool[] flags = { true, false }; string[] names = { "a", "b" }; Color[] colors = new[] { Color.red };

        public EveryPass(Own a, Own b, Value v, in int n)
        {
            shared = b;
            made = a;
            value = v;
            i = n;
            renderPassEvent = shared.kind == Kind.One ? RenderPassEvent.AfterRendering : RenderPassEvent.BeforeRendering;
            when = RenderPassEvent.AfterRenderingOpaques + shared.a;
        }

        void Classes(CommandBuffer a, ScriptableRenderContext b, RenderingData c, CameraData d, ScriptableRenderer e, RenderGraph f, ContextContainer g, Camera h) { }
        void Graph(UniversalResourceData a, UniversalCameraData b, UniversalRenderingData c, UniversalLightData d, RasterCommandBuffer e, UnsafeGraphContext f) { }
        void Values(Color a, Vector4 b, Matrix4x4 c, LayerMask d, RenderingLayerMask e, RenderPassEvent f, RenderQueueRange g, string h, uint i, double j, bool k) { }
        void References(ref Color a, out Material b, ref Own c, in Own d, out RTHandle e, ref List<float> f, ref int g, out RenderTargetIdentifier h) { b = null; e = null; h = default; }
        void Objects(Material a, Shader b, Texture2D c, RenderTexture d, Mesh e, ComputeShader f, GraphicsBuffer g, MaterialPropertyBlock h, Material[] i, List<Own> j) { }
        void Settings(FilteringSettings a, DrawingSettings b, SortingSettings c, RenderStateBlock d, StencilState e, TextureDesc f, RenderTextureDescriptor g, ProfilingSampler h) { }
        RTHandle A() => handle; Material B() => material; RenderQueueRange C() => queues; RenderStateBlock D() => state; TextureDesc E() => desc; DrawingSettings F() => drawing;
        ProfilingSampler G() => sampler; MaterialPropertyBlock H() => block; Own I() => shared; Kind J() => Kind.One; List<Own> K() => null; RenderTargetIdentifier L() => identifier;
        SortingSettings M() => sorting; RenderTargetHandle N() => oldHandle; StencilState O() => stencil; Vector3 P() => v3; Matrix4x4 Q() => m; string R() => s; bool S() => b; Value T() => value;
        RendererList U() => list; TextureHandle V() => textureHandle; FilteringSettings W() => filtering; LayerMask X() => layers; Color Y() => color; BlendState Z() => blend;
    }
}
