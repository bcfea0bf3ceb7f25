#pragma once

#include <limn/core/ComputeShader.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/Mathf.h>
#include <limn/core/RendererList.h>
#include <limn/core/Scene.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace toolbox
{

using namespace limn;

// ToolboxFeature.cs, line by line. It is compiled, not drawn.
class ToolboxFeature final : public ScriptableRendererFeature
{
public:
    enum class Detail
    {
        Low,
        Middle,
        High = 8
    };

    struct ToolboxSettings
    {
        RenderPassEvent drawEvent = RenderPassEvent::AfterRenderingOpaques;
        RenderPassEvent blitEvent = RenderPassEvent::BeforeRenderingPostProcessing + 1;
        LayerMask layers = LayerMask::Everything();
        float strength = 0.5f;
        int copies = 3;
        bool half = true;
        Color tint = Color(0.25f, 0.5f, 1.0f);
        Vector4 offset = Vector4(1, 2, 3, 4);
        Detail detail = Detail::Middle;
        std::string passName = "Toolbox Draw";
        std::shared_ptr<const Shader> shader;
        std::shared_ptr<ComputeShader> compute;
        std::shared_ptr<const Mesh> mesh;
        CompareFunction compare = CompareFunction::LessEqual;
    };

    ToolboxSettings settings = ToolboxSettings();

private:
    class TargetsPass;
    class DrawPass;
    class BlitPass;

    std::shared_ptr<Material> m_Material;
    std::shared_ptr<GraphicsBuffer> m_Arguments;
    std::unique_ptr<TargetsPass> m_Targets;
    std::unique_ptr<DrawPass> m_Draw;
    std::unique_ptr<BlitPass> m_Blit;

public:
    void Create() override
    {
        m_Material = CoreUtils::CreateEngineMaterial(settings.shader);
        m_Arguments = std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::IndirectArguments, 5,
                                                       sizeof(std::uint32_t));
        m_Arguments->SetData(std::vector<std::uint32_t>{36, 4, 0, 0, 0});
        m_Targets = std::make_unique<TargetsPass>(settings);
        m_Draw = std::make_unique<DrawPass>(settings.passName, settings.drawEvent);
        m_Blit = std::make_unique<BlitPass>(settings.strength);
        m_Blit->renderPassEvent = settings.blitEvent;
    }

    void SetupRenderPasses(ScriptableRenderer& renderer,
                           [[maybe_unused]] const RenderingData& renderingData) override
    {
        m_Targets->Setup(renderer.cameraColorTargetHandle(), renderer.cameraDepthTargetHandle());
    }

    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        CameraData& cameraData = renderingData.cameraData;
        bool isShown = cameraData.cameraType == CameraType::Game || cameraData.isSceneViewCamera();
        if (!isShown || cameraData.isPreviewCamera() ||
            cameraData.renderType == CameraRenderType::Overlay)
        {
            return;
        }
        if (cameraData.postProcessEnabled && cameraData.renderScale < 1.0f &&
            cameraData.targetTexture == nullptr)
        {
            m_Blit->ConfigureInput(ScriptableRenderPassInput::Color |
                                   ScriptableRenderPassInput::Depth);
        }
        m_Draw->Setup(m_Material, settings.mesh, m_Arguments, settings.compute, settings.layers);
        renderer.EnqueuePass(*m_Targets);
        renderer.EnqueuePass(*m_Draw);
        renderer.EnqueuePass(*m_Blit);
    }

    void Dispose([[maybe_unused]] bool disposing) override
    {
        m_Targets->Dispose();
        m_Arguments->Release();
        CoreUtils::Destroy(m_Material);
    }

private:
    // Handles, descriptors, formats, store actions.
    class TargetsPass final : public ScriptableRenderPass
    {
        static constexpr const char* k_Name = "Toolbox Targets";

        const ToolboxSettings& m_Settings;
        RTHandle m_Half;
        RTHandle m_Float;
        RTHandle m_Wrapped;
        RTHandle m_Source;
        RTHandle m_Depth;

    public:
        TargetsPass(const ToolboxSettings& toolbox) : m_Settings(toolbox)
        {
            renderPassEvent = RenderPassEvent::BeforeRenderingOpaques;
            profilingSampler = ProfilingSampler(k_Name);
        }

        void Setup(const RTHandle& source, const RTHandle& depth)
        {
            m_Source = source;
            m_Depth = depth;
        }

        void OnCameraSetup([[maybe_unused]] CommandBuffer& cmd,
                           RenderingData& renderingData) override
        {
            RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
            descriptor.depthBufferBits = 0;
            descriptor.msaaSamples = m_Settings.copies > 0 ? 1 : 2;
            descriptor.graphicsFormat = GraphicsFormat::R16G16_SFloat;
            descriptor.useMipMap = true;
            descriptor.autoGenerateMips = false;
            descriptor.enableRandomWrite = true;
            descriptor.bindMS = false;
            descriptor.dimension = TextureDimension::Tex2D;
            descriptor.volumeDepth = 1;
            descriptor.memoryless = RenderTextureMemoryless::None;
            descriptor.shadowSamplingMode = ShadowSamplingMode::None;
            RenderingUtils::ReAllocateIfNeeded(m_Float, descriptor, FilterMode::Bilinear,
                                               TextureWrapMode::Clamp, "_Float");
            descriptor.SetColorFormat(RenderTextureFormat::ARGBHalf);
            RenderingUtils::ReAllocateIfNeeded(m_Half, Vector2(1) * 0.5f, descriptor,
                                               FilterMode::Trilinear, TextureWrapMode::Mirror,
                                               "_Half");
            if (m_Wrapped == nullptr)
            {
                m_Wrapped =
                    RTHandles::Alloc(std::make_shared<const RenderTexture>("_Wrapped", descriptor));
            }
            ConfigureTarget(std::vector<RTHandle>{m_Source, m_Half}, m_Depth);
            ConfigureColorStoreAction(RenderBufferStoreAction::Store, 0);
            ConfigureDepthStoreAction(RenderBufferStoreAction::DontCare);
            ConfigureClear(ClearFlag::Color | ClearFlag::Depth, Color::black);
        }

        void Execute(ScriptableRenderContext& context,
                     [[maybe_unused]] RenderingData& renderingData) override
        {
            auto cmd = CommandBufferPool::Get();
            {
                const ProfilingScope scope(*cmd, profilingSampler);
                Vector2Int size = m_Half.GetScaledSize(Vector2Int(64, 32));
                bool scales = m_Half.useScaling() && m_Half.scaleFactor().x < 1.0f;
                cmd->SetGlobalVector("_HalfSize",
                                     Vector4(size.x, size.y, scales ? 1 : 0,
                                             m_Half.rtHandleProperties().rtHandleScale.x));
                cmd->CopyTexture(m_Float.nameID(), m_Wrapped.nameID());
                cmd->GenerateMips(m_Half.rt());
                CoreUtils::SetRenderTarget(*cmd, m_Source, m_Depth, ClearFlag::None);
                cmd->SetRenderTarget(m_Half, RenderBufferLoadAction::DontCare,
                                     RenderBufferStoreAction::Store);
                cmd->SetRenderTarget(std::vector<RenderTargetIdentifier>{m_Source, m_Half},
                                     m_Depth);
                cmd->ClearRenderTarget(RTClearFlags::All, Color::clear, 1.0f, 0);
            }
            context.ExecuteCommandBuffer(*cmd);
            cmd->Clear();
            CommandBufferPool::Release(cmd);
        }

        void Dispose()
        {
            m_Half.Release();
            m_Float.Release();
            m_Wrapped.Release();
        }
    };

    // Meshes, lists, states, keywords, properties.
    class DrawPass final : public ScriptableRenderPass
    {
        static inline const ShaderPropertyId s_Tint = Shader::PropertyToID("_Tint");
        static inline const ShaderTagId s_Tag = ShaderTagId("UniversalForward");
        static inline const GlobalKeyword s_Global = GlobalKeyword::Create("TOOLBOX_ON");

        const List<ShaderTagId> m_Tags = {ShaderTagId("UniversalForward"),
                                          ShaderTagId("SRPDefaultUnlit")};
        const std::vector<glm::mat4> m_Matrices = std::vector<glm::mat4>(4);
        MaterialPropertyBlock m_Block = MaterialPropertyBlock();
        std::shared_ptr<Material> m_Material;
        std::shared_ptr<const Mesh> m_Mesh;
        std::shared_ptr<GraphicsBuffer> m_Arguments;
        std::shared_ptr<ComputeShader> m_Compute;
        LayerMask m_Layers;
        std::string m_Name;

    public:
        DrawPass(const std::string& name, RenderPassEvent when)
        {
            m_Name = name;
            renderPassEvent = when;
            profilingSampler = ProfilingSampler(name);
        }

        void Setup(std::shared_ptr<Material> material, std::shared_ptr<const Mesh> mesh,
                   std::shared_ptr<GraphicsBuffer> arguments,
                   std::shared_ptr<ComputeShader> compute, LayerMask layers)
        {
            m_Material = material;
            m_Mesh = mesh;
            m_Arguments = arguments;
            m_Compute = compute;
            m_Layers = layers;
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            auto cmd = CommandBufferPool::Get(m_Name);
            SetGlobals(*cmd, renderingData.cameraData);
            SetKeywords(*cmd);
            DrawMeshes(*cmd, *renderingData.cameraData.camera);
            DrawLists(*cmd, context, renderingData);
            Compute(*cmd);
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }

        void SetGlobals(CommandBuffer& cmd, CameraData& cameraData)
        {
            glm::dmat4 projection = cameraData.GetGPUProjectionMatrix();
            cmd.SetGlobalFloat("_Strength", 0.5f);
            cmd.SetGlobalInt("_Count", 3);
            cmd.SetGlobalInteger("_Index", 2);
            cmd.SetGlobalVector("_Offset", Vector4(1));
            cmd.SetGlobalColor(s_Tint, Color::red.linear());
            cmd.SetGlobalMatrix("_ViewProjection", projection * cameraData.GetViewMatrix());
            cmd.SetGlobalTexture("_Source", RenderTargetIdentifier("_CameraOpaqueTexture"));
            cmd.SetGlobalTexture("_Main", RenderTargetIdentifier(m_Material->mainTexture()));
            cmd.SetGlobalFloatArray("_Weights", std::vector<float>{0.25f, 0.5f, 0.25f});
            cmd.SetGlobalVectorArray("_Points", std::vector<Vector4>{Vector4(0), Vector4(1)});
            cmd.SetGlobalMatrixArray("_Boxes", m_Matrices);
            cmd.SetGlobalBuffer("_Arguments", m_Arguments);
            cmd.SetGlobalConstantBuffer(m_Arguments, Shader::PropertyToID("_Block"), 0, 16);
            Shader::SetGlobalFloat("_Strength", 0.5f);
            Shader::SetGlobalInt("_Count", 3);
            Shader::SetGlobalVector("_Offset", Vector4(1));
            Shader::SetGlobalColor(s_Tint, Color::white);
            Shader::SetGlobalMatrix("_View", cameraData.camera->worldToCameraMatrix());
            Shader::SetGlobalTexture("_Source", m_Material->GetTexture("_MainTex"));
            Shader::SetGlobalFloatArray("_Weights", std::vector<float>{1.0f});
            Shader::SetGlobalVectorArray("_Points", std::vector<Vector4>{Vector4(0)});
            Shader::SetGlobalMatrixArray("_Boxes", m_Matrices);
            Shader::SetGlobalBuffer("_Arguments", m_Arguments);
        }

        void SetKeywords(CommandBuffer& cmd)
        {
            LocalKeyword local = LocalKeyword(*m_Material->shader(), "TOOLBOX_LOCAL");
            cmd.EnableShaderKeyword("TOOLBOX_NAMED");
            cmd.DisableShaderKeyword("TOOLBOX_NAMED");
            cmd.EnableKeyword(s_Global);
            cmd.SetKeyword(m_Material, local, true);
            cmd.DisableKeyword(m_Material, local);
            CoreUtils::SetKeyword(cmd, "TOOLBOX_ON", true);
            CoreUtils::SetKeyword(*m_Material, "TOOLBOX_LOCAL", false);
            m_Material->EnableKeyword("TOOLBOX_LOCAL");
            m_Material->DisableKeyword("TOOLBOX_LOCAL");
            if (m_Material->IsKeywordEnabled("TOOLBOX_LOCAL") ||
                Shader::IsKeywordEnabled("TOOLBOX_ON"))
            {
                Shader::DisableKeyword("TOOLBOX_ON");
            }
            if (m_Material->HasProperty(s_Tint) && m_Material->HasFloat("_Strength") &&
                m_Material->FindPass("Draw") >= 0)
            {
                m_Material->SetColor(s_Tint, m_Material->GetColor(s_Tint) *
                                                 m_Material->GetFloat("_Strength"));
            }
            if (m_Material->HasColor(s_Tint) && m_Material->HasVector("_Offset") &&
                m_Material->HasTexture("_MainTex") && m_Material->HasInt("_Count"))
            {
                m_Material->SetVector("_Offset",
                                      m_Material->GetVector("_Offset") *
                                          static_cast<float>(m_Material->GetInt("_Count")));
            }
            m_Material->SetMatrix("_Box", m_Material->GetMatrix("_Box"));
            m_Material->SetFloatArray("_Weights", m_Material->GetFloatArray("_Weights"));
            m_Material->SetTextureScale("_MainTex", m_Material->GetTextureScale("_MainTex"));
            m_Material->SetBuffer("_Arguments", m_Arguments);
            m_Material->SetShaderPassEnabled("ShadowCaster", false);
            std::string tag = m_Material->GetTag("RenderType", false, "Opaque");
            bool isLast = m_Material->GetPassName(m_Material->passCount() - 1) == tag;
            m_Material->SetRenderQueue(isLast ? static_cast<int>(RenderQueue::Transparent) : 2000);
        }

        void DrawMeshes(CommandBuffer& cmd, const Camera& camera)
        {
            m_Block.Clear();
            m_Block.SetColor(s_Tint, Color::green);
            m_Block.SetFloat("_Strength",
                             camera.orthographic ? camera.orthographicSize : camera.fieldOfView);
            m_Block.SetVectorArray("_Points", std::vector<Vector4>{Vector4(0)});
            cmd.SetViewport(ViewportRect{0, 0, 32, 32});
            cmd.EnableScissorRect(ViewportRect{8, 8, 16, 16});
            cmd.SetInvertCulling(true);
            cmd.SetGlobalDepthBias(1.0f, 2.0f);
            cmd.DrawMesh(m_Mesh, glm::mat4(1), m_Material, 0, 0, m_Block);
            cmd.DrawMeshInstanced(m_Mesh, 0, m_Material, 0, m_Matrices, 4, m_Block);
            cmd.DrawMeshInstancedIndirect(m_Mesh, 0, m_Material, 0, m_Arguments, 0, m_Block);
            cmd.DrawMeshInstancedProcedural(m_Mesh, 0, m_Material, 0, 4, m_Block);
            cmd.DrawProcedural(glm::mat4(1), m_Material, 1, MeshTopology::Triangles, 3, 2, m_Block);
            cmd.DrawProceduralIndirect(glm::mat4(1), m_Material, 1, MeshTopology::LineStrip,
                                       m_Arguments, 0);
            cmd.DisableScissorRect();
            cmd.SetInvertCulling(false);
            cmd.SetGlobalDepthBias(0.0f, 0.0f);
            CoreUtils::DrawFullScreen(cmd, m_Material, m_Block, 0);
            cmd.DrawMesh(RenderingUtils::fullscreenMesh(), glm::mat4(1), m_Material);
        }

        void DrawLists(CommandBuffer& cmd, ScriptableRenderContext& context,
                       RenderingData& renderingData)
        {
            SortingCriteria criteria = renderingData.cameraData.defaultOpaqueSortFlags;
            DrawingSettings drawing = CreateDrawingSettings(m_Tags, renderingData, criteria);
            drawing.overrideMaterial = m_Material;
            drawing.overrideMaterialPassIndex = 1;
            drawing.SetShaderPassName(2, s_Tag);
            FilteringSettings filtering = FilteringSettings(RenderQueueRange::opaque, m_Layers);
            filtering.renderingLayerMask = RenderingLayerMask::FromIndex(2);
            RenderStateBlock block =
                RenderStateBlock(RenderStateMask::Depth | RenderStateMask::Stencil);
            block.depthState = DepthState(false, CompareFunction::Greater);
            StencilState stencil = StencilState::defaultValue;
            stencil.SetCompareFunction(CompareFunction::Equal);
            stencil.SetPassOperation(StencilOp::Replace);
            block.stencilState = stencil;
            block.stencilReference = 3;
            block.blendState.blendStates[0] =
                RenderTargetBlendState{.writeMask = ColorWriteMask::All,
                                       .sourceColorBlendMode = BlendMode::One,
                                       .destinationColorBlendMode = BlendMode::OneMinusSrcAlpha};
            context.DrawRenderers(renderingData.cullResults, drawing, filtering, block);
            RendererListParams parameters =
                RendererListParams(renderingData.cullResults, drawing, filtering);
            RendererList list = context.CreateRendererList(parameters);
            cmd.DrawRendererList(list);
            RendererListDesc desc = RendererListDesc(s_Tag, renderingData.cullResults,
                                                     *renderingData.cameraData.camera);
            desc.sortingCriteria = SortingCriteria::CommonTransparent;
            desc.renderQueueRange = RenderQueueRange::transparent;
            desc.layerMask = m_Layers;
            desc.overrideMaterial = m_Material;
            CoreUtils::DrawRendererList(context, cmd, context.CreateRendererList(desc));
        }

        void DrawOne(CommandBuffer& cmd, GameObject& one)
        {
            one.renderer->GetPropertyBlock(m_Block);
            one.renderer->SetPropertyBlock(m_Block);
            cmd.DrawRenderer(one, m_Material, 0, -1);
        }

        void Compute(CommandBuffer& cmd)
        {
            int kernel = m_Compute->FindKernel("Main");
            std::uint32_t x = 0;
            std::uint32_t y = 0;
            std::uint32_t z = 0;
            m_Compute->GetKernelThreadGroupSizes(kernel, x, y, z);
            cmd.SetComputeFloatParam(m_Compute, "_Strength", 1.0f);
            cmd.SetComputeIntParam(m_Compute, "_Count", 4);
            cmd.SetComputeIntParams(m_Compute, "_Size", 64, 32);
            cmd.SetComputeVectorParam(m_Compute, "_Offset", Vector4(1));
            cmd.SetComputeMatrixParam(m_Compute, "_Box", glm::mat4(1));
            cmd.SetComputeTextureParam(m_Compute, kernel, "_Result",
                                       RenderTargetIdentifier("_Float"));
            cmd.SetComputeBufferParam(m_Compute, kernel, "_Arguments", m_Arguments);
            cmd.DispatchCompute(m_Compute, kernel, Mathf::CeilToInt(64.0f / static_cast<float>(x)),
                                Mathf::CeilToInt(32.0f / static_cast<float>(y)),
                                static_cast<int>(z));
            cmd.DispatchCompute(m_Compute, kernel, m_Arguments, 0);
        }
    };

    // Temporary textures and blits, as before RTHandles.
    class BlitPass final : public ScriptableRenderPass
    {
        static inline const ShaderPropertyId s_Temporary =
            Shader::PropertyToID("_ToolboxTemporary");
        RenderTargetHandle m_Handle;
        std::shared_ptr<Material> m_Material;
        float m_Strength;

    public:
        BlitPass(float strength)
        {
            m_Strength = strength * 2.0f;
            m_Handle.Init("_ToolboxHandle");
            profilingSampler = ProfilingSampler("BlitPass");
        }

        void Configure(CommandBuffer& cmd,
                       const RenderTextureDescriptor& cameraTextureDescriptor) override
        {
            cmd.GetTemporaryRT(m_Handle.id, cameraTextureDescriptor, FilterMode::Bilinear);
            cmd.GetTemporaryRT(s_Temporary, cameraTextureDescriptor.width / 2,
                               cameraTextureDescriptor.height / 2, 0, FilterMode::Point,
                               RenderTextureFormat::DefaultHDR);
            ConfigureTarget(m_Handle.Identifier());
        }

        void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
        {
            auto cmd = CommandBufferPool::Get("Toolbox Blit");
            ScriptableRenderer& renderer = *renderingData.cameraData.renderer;
            RenderTargetIdentifier source = renderer.cameraColorTarget();
            RenderTargetIdentifier temporary = RenderTargetIdentifier(s_Temporary);
            RenderTargetIdentifier camera = BuiltinRenderTextureType::CameraTarget;
            cmd->BeginSample("Toolbox");
            cmd->SetGlobalFloat("_Strength", m_Strength);
            cmd->Blit(source, temporary);
            cmd->Blit(temporary, m_Handle.Identifier(), m_Material, 1);
            cmd->SetGlobalTexture("_Blurred", m_Handle.Identifier());
            Blit(*cmd, s_Temporary, source, m_Material);
            Blit(*cmd, renderingData, m_Material, 0);
            Blitter::BlitCameraTexture(*cmd, renderer.cameraColorTargetHandle(),
                                       renderer.cameraColorTargetHandle(), m_Material, 0);
            Blitter::BlitTexture(*cmd, renderer.cameraColorTargetHandle(), Vector4(1, 1, 0, 0),
                                 m_Material, 0);
            cmd->SetRenderTarget(camera, RenderBufferLoadAction::Load,
                                 RenderBufferStoreAction::Store, temporary,
                                 RenderBufferLoadAction::Load, RenderBufferStoreAction::DontCare);
            cmd->SetViewProjectionMatrices(renderingData.cameraData.GetViewMatrix(),
                                           renderingData.cameraData.GetProjectionMatrix());
            cmd->EndSample("Toolbox");
            context.ExecuteCommandBuffer(*cmd);
            CommandBufferPool::Release(cmd);
        }

        void OnCameraCleanup(CommandBuffer& cmd) override
        {
            cmd.ReleaseTemporaryRT(s_Temporary);
            cmd.ReleaseTemporaryRT(m_Handle.id);
        }
    };

    // What a mesh is made of.
    static std::shared_ptr<Mesh> MakeQuad()
    {
        MeshData mesh;
        mesh.vertices = List<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.uv4 = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}};
        mesh.uv = std::vector<Vector2>{{0, 0}, {1, 0}, {0, 1}};
        mesh.uv8 = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.SetColors(std::vector<Color32>{Color32(255, 0, 0, 255), Color32(0, 255, 0, 255),
                                            Color32(0, 0, 255, 255)});
        mesh.triangles = {0, 1, 2};
        return std::make_shared<Mesh>("Quad", mesh);
    }

    void Describe([[maybe_unused]] Inspector& inspector) override {}
};

} // namespace toolbox
