using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RendererUtils;
using UnityEngine.Rendering.Universal;

// Each call of URP 14 that a render feature makes, once at least. It draws nothing that makes sense.
// Written for limn's tests.
public class ToolboxFeature : ScriptableRendererFeature
{
    public enum Detail { Low, Middle, High = 8 }

    [Serializable]
    public class ToolboxSettings
    {
        [Header("When")]
        public RenderPassEvent drawEvent = RenderPassEvent.AfterRenderingOpaques;
        public RenderPassEvent blitEvent = RenderPassEvent.BeforeRenderingPostProcessing + 1;
        [Header("What"), Tooltip("Layers that are drawn.")] public LayerMask layers = ~0;
        [Range(0f, 2f)] public float strength = 0.5f;
        [Min(1)] public int copies = 3;
        public bool half = true;
        public Color tint = new Color(0.25f, 0.5f, 1f);
        public Vector4 offset = new Vector4(1, 2, 3, 4);
        public Detail detail = Detail.Middle;
        public string passName = "Toolbox Draw";
        public Shader shader;
        public ComputeShader compute;
        public Mesh mesh;
        public CompareFunction compare = CompareFunction.LessEqual;
    }

    public ToolboxSettings settings = new ToolboxSettings();

    Material m_Material;
    GraphicsBuffer m_Arguments;
    TargetsPass m_Targets;
    DrawPass m_Draw;
    BlitPass m_Blit;

    public override void Create()
    {
        m_Material = CoreUtils.CreateEngineMaterial(settings.shader);
        m_Arguments = new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments, 5, sizeof(uint));
        m_Arguments.SetData(new uint[] { 36, 4, 0, 0, 0 });
        m_Targets = new TargetsPass(settings);
        m_Draw = new DrawPass(settings.passName, settings.drawEvent);
        m_Blit = new BlitPass(settings.strength) { renderPassEvent = settings.blitEvent };
    }

    public override void SetupRenderPasses(ScriptableRenderer renderer, in RenderingData renderingData)
    {
        m_Targets.Setup(renderer.cameraColorTargetHandle, renderer.cameraDepthTargetHandle);
    }

    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        CameraData cameraData = renderingData.cameraData;
        bool isShown = cameraData.cameraType == CameraType.Game || cameraData.isSceneViewCamera;
        if (!isShown || cameraData.isPreviewCamera || cameraData.renderType == CameraRenderType.Overlay)
            return;
        if (cameraData.postProcessEnabled && cameraData.renderScale < 1.0f && cameraData.targetTexture == null)
            m_Blit.ConfigureInput(ScriptableRenderPassInput.Color | ScriptableRenderPassInput.Depth);
        m_Draw.Setup(m_Material, settings.mesh, m_Arguments, settings.compute, settings.layers);
        renderer.EnqueuePass(m_Targets);
        renderer.EnqueuePass(m_Draw);
        renderer.EnqueuePass(m_Blit);
    }

    protected override void Dispose(bool disposing)
    {
        m_Targets.Dispose();
        m_Arguments?.Release();
        CoreUtils.Destroy(m_Material);
    }

    // Handles, descriptors, formats, store actions.
    class TargetsPass : ScriptableRenderPass
    {
        const string k_Name = "Toolbox Targets";

        readonly ToolboxSettings m_Settings;
        RTHandle m_Half;
        RTHandle m_Float;
        RTHandle m_Wrapped;
        RTHandle m_Source;
        RTHandle m_Depth;

        public TargetsPass(ToolboxSettings toolbox)
        {
            m_Settings = toolbox;
            renderPassEvent = RenderPassEvent.BeforeRenderingOpaques;
            profilingSampler = new ProfilingSampler(k_Name);
        }

        public void Setup(RTHandle source, RTHandle depth)
        {
            m_Source = source;
            m_Depth = depth;
        }

        public override void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
        {
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = m_Settings.copies > 0 ? 1 : 2;
            descriptor.graphicsFormat = GraphicsFormat.R16G16_SFloat;
            descriptor.useMipMap = true;
            descriptor.autoGenerateMips = false;
            descriptor.enableRandomWrite = true;
            descriptor.bindMS = false;
            descriptor.sRGB = false;
            descriptor.dimension = TextureDimension.Tex2D;
            descriptor.volumeDepth = 1;
            descriptor.memoryless = RenderTextureMemoryless.None;
            descriptor.shadowSamplingMode = ShadowSamplingMode.None;
            RenderingUtils.ReAllocateIfNeeded(ref m_Float, descriptor, FilterMode.Bilinear, TextureWrapMode.Clamp, name: "_Float");
            descriptor.colorFormat = RenderTextureFormat.ARGBHalf;
            RenderingUtils.ReAllocateIfNeeded(ref m_Half, Vector2.one * 0.5f, descriptor, FilterMode.Trilinear, TextureWrapMode.Mirror, name: "_Half");
            if (m_Wrapped == null)
                m_Wrapped = RTHandles.Alloc(new RenderTexture(descriptor));
            ConfigureTarget(new RTHandle[] { m_Source, m_Half }, m_Depth);
            ConfigureColorStoreAction(RenderBufferStoreAction.Store, 0);
            ConfigureDepthStoreAction(RenderBufferStoreAction.DontCare);
            ConfigureClear(ClearFlag.Color | ClearFlag.Depth, Color.black);
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get();
            using (new ProfilingScope(cmd, profilingSampler))
            {
                Vector2Int size = m_Half.GetScaledSize(new Vector2Int(64, 32));
                bool scales = m_Half.useScaling && m_Half.scaleFactor.x < 1.0f;
                cmd.SetGlobalVector("_HalfSize", new Vector4(size.x, size.y, scales ? 1 : 0, m_Half.rtHandleProperties.rtHandleScale.x));
                cmd.CopyTexture(m_Float.nameID, m_Wrapped.nameID);
                cmd.CopyTexture(m_Float, 0, 0, m_Wrapped, 0, 0);
                cmd.GenerateMips(m_Half.rt);
                CoreUtils.SetRenderTarget(cmd, m_Source, m_Depth, ClearFlag.None);
                cmd.SetRenderTarget(m_Half, RenderBufferLoadAction.DontCare, RenderBufferStoreAction.Store);
                cmd.SetRenderTarget(new RenderTargetIdentifier[] { m_Source, m_Half }, m_Depth);
                cmd.ClearRenderTarget(RTClearFlags.All, Color.clear, 1.0f, 0);
            }
            context.ExecuteCommandBuffer(cmd);
            cmd.Clear();
            CommandBufferPool.Release(cmd);
        }

        public void Dispose()
        {
            m_Half?.Release();
            m_Float?.Release();
            m_Wrapped?.Release();
        }
    }

    // Meshes, lists, states, keywords, properties.
    class DrawPass : ScriptableRenderPass
    {
        static readonly int s_Tint = Shader.PropertyToID("_Tint");
        static readonly ShaderTagId s_Tag = new ShaderTagId("UniversalForward");
        static readonly GlobalKeyword s_Global = GlobalKeyword.Create("TOOLBOX_ON");

        readonly List<ShaderTagId> m_Tags = new List<ShaderTagId> { new ShaderTagId("UniversalForward"), new ShaderTagId("SRPDefaultUnlit") };
        readonly Matrix4x4[] m_Matrices = new Matrix4x4[4];
        readonly MaterialPropertyBlock m_Block = new MaterialPropertyBlock();
        Material m_Material;
        Mesh m_Mesh;
        GraphicsBuffer m_Arguments;
        ComputeShader m_Compute;
        LayerMask m_Layers;
        string m_Name;

        public DrawPass(string name, RenderPassEvent when)
        {
            m_Name = name;
            renderPassEvent = when;
            profilingSampler = new ProfilingSampler(name);
        }

        public void Setup(Material material, Mesh mesh, GraphicsBuffer arguments, ComputeShader compute, LayerMask layers)
        {
            m_Material = material;
            m_Mesh = mesh;
            m_Arguments = arguments;
            m_Compute = compute;
            m_Layers = layers;
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get(m_Name);
            SetGlobals(cmd, ref renderingData.cameraData);
            SetKeywords(cmd);
            DrawMeshes(cmd, renderingData.cameraData.camera);
            DrawLists(cmd, context, ref renderingData);
            Compute(cmd);
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        void SetGlobals(CommandBuffer cmd, ref CameraData cameraData)
        {
            Matrix4x4 projection = cameraData.GetGPUProjectionMatrix();
            cmd.SetGlobalFloat("_Strength", 0.5f);
            cmd.SetGlobalInt("_Count", 3);
            cmd.SetGlobalInteger("_Index", 2);
            cmd.SetGlobalVector("_Offset", Vector4.one);
            cmd.SetGlobalColor(s_Tint, Color.red.linear);
            cmd.SetGlobalMatrix("_ViewProjection", projection * cameraData.GetViewMatrix());
            cmd.SetGlobalTexture("_Source", new RenderTargetIdentifier("_CameraOpaqueTexture"));
            cmd.SetGlobalTexture("_Main", new RenderTargetIdentifier(m_Material.mainTexture));
            cmd.SetGlobalFloatArray("_Weights", new float[] { 0.25f, 0.5f, 0.25f });
            cmd.SetGlobalVectorArray("_Points", new Vector4[] { Vector4.zero, Vector4.one });
            cmd.SetGlobalMatrixArray("_Boxes", m_Matrices);
            cmd.SetGlobalBuffer("_Arguments", m_Arguments);
            cmd.SetGlobalConstantBuffer(m_Arguments, Shader.PropertyToID("_Block"), 0, 16);
            Shader.SetGlobalFloat("_Strength", 0.5f);
            Shader.SetGlobalInt("_Count", 3);
            Shader.SetGlobalVector("_Offset", Vector4.one);
            Shader.SetGlobalColor(s_Tint, Color.white);
            Shader.SetGlobalMatrix("_View", cameraData.camera.worldToCameraMatrix);
            Shader.SetGlobalTexture("_Source", m_Material.GetTexture("_MainTex"));
            Shader.SetGlobalFloatArray("_Weights", new float[] { 1.0f });
            Shader.SetGlobalVectorArray("_Points", new Vector4[] { Vector4.zero });
            Shader.SetGlobalMatrixArray("_Boxes", m_Matrices);
            Shader.SetGlobalBuffer("_Arguments", m_Arguments);
        }

        void SetKeywords(CommandBuffer cmd)
        {
            LocalKeyword local = new LocalKeyword(m_Material.shader, "TOOLBOX_LOCAL");
            cmd.EnableShaderKeyword("TOOLBOX_NAMED");
            cmd.DisableShaderKeyword("TOOLBOX_NAMED");
            cmd.EnableKeyword(s_Global);
            cmd.SetKeyword(m_Material, local, true);
            cmd.DisableKeyword(m_Material, local);
            CoreUtils.SetKeyword(cmd, "TOOLBOX_ON", true);
            CoreUtils.SetKeyword(m_Material, "TOOLBOX_LOCAL", false);
            m_Material.EnableKeyword("TOOLBOX_LOCAL");
            m_Material.DisableKeyword("TOOLBOX_LOCAL");
            if (m_Material.IsKeywordEnabled("TOOLBOX_LOCAL") || Shader.IsKeywordEnabled("TOOLBOX_ON"))
                Shader.DisableKeyword("TOOLBOX_ON");
            if (m_Material.HasProperty(s_Tint) && m_Material.HasFloat("_Strength") && m_Material.FindPass("Draw") >= 0)
                m_Material.SetColor(s_Tint, m_Material.GetColor(s_Tint) * m_Material.GetFloat("_Strength"));
            if (m_Material.HasColor(s_Tint) && m_Material.HasVector("_Offset") && m_Material.HasTexture("_MainTex") && m_Material.HasInt("_Count"))
                m_Material.SetVector("_Offset", m_Material.GetVector("_Offset") * m_Material.GetInt("_Count"));
            m_Material.SetMatrix("_Box", m_Material.GetMatrix("_Box"));
            m_Material.SetFloatArray("_Weights", m_Material.GetFloatArray("_Weights"));
            m_Material.SetTextureScale("_MainTex", m_Material.GetTextureScale("_MainTex"));
            m_Material.SetBuffer("_Arguments", m_Arguments);
            m_Material.SetShaderPassEnabled("ShadowCaster", false);
            string tag = m_Material.GetTag("RenderType", false, "Opaque");
            bool isLast = m_Material.GetPassName(m_Material.passCount - 1) == tag;
            m_Material.renderQueue = isLast ? (int)RenderQueue.Transparent : 2000;
        }

        void DrawMeshes(CommandBuffer cmd, Camera camera)
        {
            m_Block.Clear();
            m_Block.SetColor(s_Tint, Color.green);
            m_Block.SetFloat("_Strength", camera.orthographic ? camera.orthographicSize : camera.fieldOfView);
            m_Block.SetVectorArray("_Points", new Vector4[] { Vector4.zero });
            cmd.SetViewport(new Rect(0, 0, 32, 32));
            cmd.EnableScissorRect(new Rect(8, 8, 16, 16));
            cmd.SetInvertCulling(true);
            cmd.SetGlobalDepthBias(1.0f, 2.0f);
            cmd.DrawMesh(m_Mesh, Matrix4x4.identity, m_Material, 0, 0, m_Block);
            cmd.DrawMeshInstanced(m_Mesh, 0, m_Material, 0, m_Matrices, 4, m_Block);
            cmd.DrawMeshInstancedIndirect(m_Mesh, 0, m_Material, 0, m_Arguments, 0, m_Block);
            cmd.DrawMeshInstancedProcedural(m_Mesh, 0, m_Material, 0, 4, m_Block);
            cmd.DrawProcedural(Matrix4x4.identity, m_Material, 1, MeshTopology.Triangles, 3, 2, m_Block);
            cmd.DrawProceduralIndirect(Matrix4x4.identity, m_Material, 1, MeshTopology.LineStrip, m_Arguments, 0);
            cmd.DisableScissorRect();
            cmd.SetInvertCulling(false);
            cmd.SetGlobalDepthBias(0.0f, 0.0f);
            CoreUtils.DrawFullScreen(cmd, m_Material, m_Block, 0);
            cmd.DrawMesh(RenderingUtils.fullscreenMesh, Matrix4x4.identity, m_Material);
        }

        void DrawLists(CommandBuffer cmd, ScriptableRenderContext context, ref RenderingData renderingData)
        {
            SortingCriteria criteria = renderingData.cameraData.defaultOpaqueSortFlags;
            DrawingSettings drawing = CreateDrawingSettings(m_Tags, ref renderingData, criteria);
            drawing.overrideMaterial = m_Material;
            drawing.overrideMaterialPassIndex = 1;
            drawing.SetShaderPassName(2, s_Tag);
            FilteringSettings filtering = new FilteringSettings(RenderQueueRange.opaque, m_Layers);
            filtering.renderingLayerMask = 1u << 2;
            RenderStateBlock block = new RenderStateBlock(RenderStateMask.Depth | RenderStateMask.Stencil);
            block.depthState = new DepthState(false, CompareFunction.Greater);
            StencilState stencil = StencilState.defaultValue;
            stencil.SetCompareFunction(CompareFunction.Equal);
            stencil.SetPassOperation(StencilOp.Replace);
            block.stencilState = stencil;
            block.stencilReference = 3;
            block.blendState = new BlendState { blendState0 = new RenderTargetBlendState(ColorWriteMask.All, BlendMode.One, BlendMode.OneMinusSrcAlpha) };
            context.DrawRenderers(renderingData.cullResults, ref drawing, ref filtering, ref block);
            RendererListParams parameters = new RendererListParams(renderingData.cullResults, drawing, filtering);
            RendererList list = context.CreateRendererList(ref parameters);
            cmd.DrawRendererList(list);
            RendererListDesc desc = new RendererListDesc(s_Tag, renderingData.cullResults, renderingData.cameraData.camera)
            {
                sortingCriteria = SortingCriteria.CommonTransparent,
                renderQueueRange = RenderQueueRange.transparent,
                layerMask = m_Layers,
                overrideMaterial = m_Material,
            };
            CoreUtils.DrawRendererList(context, cmd, context.CreateRendererList(desc));
        }

        public void DrawOne(CommandBuffer cmd, Renderer one)
        {
            one.GetPropertyBlock(m_Block);
            one.SetPropertyBlock(m_Block);
            cmd.DrawRenderer(one, m_Material, 0, -1);
        }

        void Compute(CommandBuffer cmd)
        {
            int kernel = m_Compute.FindKernel("Main");
            m_Compute.GetKernelThreadGroupSizes(kernel, out uint x, out uint y, out uint z);
            cmd.SetComputeFloatParam(m_Compute, "_Strength", 1.0f);
            cmd.SetComputeIntParam(m_Compute, "_Count", 4);
            cmd.SetComputeIntParams(m_Compute, "_Size", 64, 32);
            cmd.SetComputeVectorParam(m_Compute, "_Offset", Vector4.one);
            cmd.SetComputeMatrixParam(m_Compute, "_Box", Matrix4x4.identity);
            cmd.SetComputeTextureParam(m_Compute, kernel, "_Result", new RenderTargetIdentifier("_Float"));
            cmd.SetComputeBufferParam(m_Compute, kernel, "_Arguments", m_Arguments);
            cmd.DispatchCompute(m_Compute, kernel, Mathf.CeilToInt(64 / (float)x), Mathf.CeilToInt(32 / (float)y), (int)z);
            cmd.DispatchCompute(m_Compute, kernel, m_Arguments, 0);
        }
    }

    // Temporary textures and blits, as before RTHandles.
    class BlitPass : ScriptableRenderPass
    {
        static readonly int s_Temporary = Shader.PropertyToID("_ToolboxTemporary");
        RenderTargetHandle m_Handle;
        Material m_Material;
        float m_Strength;

        public BlitPass(float strength)
        {
            m_Strength = strength * 2f;
            m_Handle.Init("_ToolboxHandle");
            base.profilingSampler = new ProfilingSampler(nameof(BlitPass));
        }

        public override void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
        {
            cmd.GetTemporaryRT(m_Handle.id, cameraTextureDescriptor, FilterMode.Bilinear);
            cmd.GetTemporaryRT(s_Temporary, cameraTextureDescriptor.width / 2, cameraTextureDescriptor.height / 2, 0, FilterMode.Point, RenderTextureFormat.DefaultHDR);
            ConfigureTarget(m_Handle.Identifier());
        }

        public override void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
        {
            CommandBuffer cmd = CommandBufferPool.Get("Toolbox Blit");
            ScriptableRenderer renderer = renderingData.cameraData.renderer;
            RenderTargetIdentifier source = renderer.cameraColorTarget;
            RenderTargetIdentifier temporary = new RenderTargetIdentifier(s_Temporary);
            RenderTargetIdentifier camera = BuiltinRenderTextureType.CameraTarget;
            cmd.BeginSample("Toolbox");
            cmd.SetGlobalFloat("_Strength", m_Strength);
            cmd.Blit(source, temporary);
            cmd.Blit(temporary, m_Handle.Identifier(), m_Material, 1);
            cmd.SetGlobalTexture("_Blurred", m_Handle.Identifier());
            Blit(cmd, s_Temporary, source, m_Material);
            Blit(cmd, ref renderingData, m_Material, 0);
            Blitter.BlitCameraTexture(cmd, renderer.cameraColorTargetHandle, renderer.cameraColorTargetHandle, m_Material, 0);
            Blitter.BlitTexture(cmd, renderer.cameraColorTargetHandle, new Vector4(1, 1, 0, 0), m_Material, 0);
            cmd.SetRenderTarget(camera, RenderBufferLoadAction.Load, RenderBufferStoreAction.Store, temporary, RenderBufferLoadAction.Load, RenderBufferStoreAction.DontCare);
            cmd.SetViewProjectionMatrices(renderingData.cameraData.GetViewMatrix(), renderingData.cameraData.GetProjectionMatrix());
            cmd.EndSample("Toolbox");
            context.ExecuteCommandBuffer(cmd);
            CommandBufferPool.Release(cmd);
        }

        public override void OnCameraCleanup(CommandBuffer cmd)
        {
            cmd.ReleaseTemporaryRT(s_Temporary);
            cmd.ReleaseTemporaryRT(m_Handle.id);
        }
    }

    // What a mesh is made of.
    static Mesh MakeQuad()
    {
        Mesh mesh = new Mesh();
        mesh.vertices = new Vector3[] { Vector3.zero, Vector3.right, Vector3.up };
        mesh.SetUVs(3, new List<Vector2> { Vector2.zero, Vector2.right, Vector2.up });
        mesh.uv = new Vector2[] { Vector2.zero, Vector2.right, Vector2.up };
        mesh.uv8 = mesh.uv;
        mesh.colors32 = new Color32[] { new Color32(255, 0, 0, 255), new Color32(0, 255, 0, 255), new Color32(0, 0, 255, 255) };
        mesh.triangles = new int[] { 0, 1, 2 };
        mesh.RecalculateNormals();
        mesh.RecalculateBounds();
        return mesh;
    }
}
