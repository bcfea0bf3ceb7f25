#include <limn/features/FullScreenPassRendererFeature.h>

#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/Features.h>

namespace limn
{

namespace
{

constexpr int k_NearestBlitPass = 0; // "Nearest" of CoreBlit.shader
const glm::vec4 k_WholePicture{1.0f, 1.0f, 0.0f, 0.0f};

constexpr EnumEntry k_InjectionPoints[] = {{"BeforeRenderingTransparents", 450},
                                           {"BeforeRenderingPostProcessing", 550},
                                           {"AfterRenderingPostProcessing", 600}};
constexpr EnumEntry k_Requirements[] = {{"None", 0},  {"Depth", 1},  {"Normal", 2},
                                        {"Color", 4}, {"Motion", 8}, {"Everything", 15}};

} // namespace

/// The pass of FullScreenPassRendererFeature. Unity: FullScreenRenderPass (URP 14).
class FullScreenRenderPass final : public ScriptableRenderPass
{
public:
    explicit FullScreenRenderPass(const std::string& passName);

    /// @param material  must not be null
    void SetupMembers(std::shared_ptr<const Material> material, int passIndex,
                      bool fetchActiveColor, bool bindDepthStencilAttachment,
                      ScriptableRenderPassInput requirements);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    std::shared_ptr<const Material> m_Material;
    int m_PassIndex = 0;
    bool m_FetchActiveColor = true;
    bool m_BindDepthStencilAttachment = false;
    std::shared_ptr<const Material> m_CopyMaterial;
    RTHandle m_CopiedColor;
};

FullScreenRenderPass::FullScreenRenderPass(const std::string& passName)
{
    profilingSampler = ProfilingSampler(passName);
}

void FullScreenRenderPass::SetupMembers(std::shared_ptr<const Material> material, int passIndex,
                                        bool fetchActiveColor, bool bindDepthStencilAttachment,
                                        ScriptableRenderPassInput requirements)
{
    m_Material = std::move(material);
    m_PassIndex = passIndex;
    m_FetchActiveColor = fetchActiveColor;
    m_BindDepthStencilAttachment = bindDepthStencilAttachment;
    if (m_FetchActiveColor && !m_CopyMaterial)
    {
        m_CopyMaterial = CoreUtils::CreateEngineMaterial(
            FindBuiltinShader("Hidden/Universal/CoreBlit", m_Material->shader()->compiler()));
    }
    ConfigureInput(requirements);
}

void FullScreenRenderPass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    ResetTarget();
    if (m_FetchActiveColor)
    {
        RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
        descriptor.msaaSamples = 1;
        descriptor.depthBufferBits = 0;
        descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads them
        RenderingUtils::ReAllocateIfNeeded(m_CopiedColor, descriptor, FilterMode::Bilinear,
                                           TextureWrapMode::Clamp, "_FullscreenPassColorCopy");
    }
}

void FullScreenRenderPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const ScriptableRenderer& renderer = *renderingData.cameraData.renderer;
    const RTHandle& color = renderer.cameraColorTargetHandle();
    const RTHandle depth =
        m_BindDepthStencilAttachment ? renderer.cameraDepthTargetHandle() : RTHandle();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    if (m_FetchActiveColor)
    {
        Blitter::BlitCameraTexture(*cmd, color, m_CopiedColor, m_CopyMaterial, k_NearestBlitPass);
    }
    CoreUtils::SetRenderTarget(*cmd, color, depth);
    MaterialPropertyBlock properties;
    if (m_FetchActiveColor)
    {
        properties.SetTexture(Shader::PropertyToID("_BlitTexture"), m_CopiedColor.rt());
    }
    properties.SetVector(Shader::PropertyToID("_BlitScaleBias"), k_WholePicture);
    cmd->DrawProcedural(glm::mat4(1.0f), m_Material, m_PassIndex, 3, properties);
    context.ExecuteCommandBuffer(*cmd);
}

FullScreenPassRendererFeature::FullScreenPassRendererFeature()
{
    name = "FullScreenPassRendererFeature";
}

FullScreenPassRendererFeature::~FullScreenPassRendererFeature() = default;

void FullScreenPassRendererFeature::Describe(Inspector& inspector)
{
    inspector.Field("injectionPoint", injectionPoint, k_InjectionPoints,
                    "The event of the frame at which the pass is drawn");
    inspector.Field("fetchColorBuffer", fetchColorBuffer,
                    "Lets the shader read the picture so far as _BlitTexture");
    inspector.Field("requirements", requirements, k_Requirements,
                    "The other textures of the camera that the shader reads");
    inspector.Field("passMaterial", passMaterial,
                    "The material that is drawn over the whole picture");
    inspector.Field("passIndex", passIndex, ValueRange{0, 255},
                    "The index of the material's pass, from 0");
    inspector.Field("bindDepthStencilAttachment", bindDepthStencilAttachment,
                    "Lets the pass test the camera's depth and stencil");
}

void FullScreenPassRendererFeature::Create()
{
    m_FullScreenPass = std::make_unique<FullScreenRenderPass>(name);
}

void FullScreenPassRendererFeature::AddRenderPasses(ScriptableRenderer& renderer,
                                                    RenderingData& renderingData)
{
    std::vector<std::string>& notes = renderingData.report->notes;
    if (!passMaterial)
    {
        notes.push_back(name + ": it is not drawn; passMaterial is not assigned");
        return;
    }
    if (passIndex < 0 || passIndex >= passMaterial->passCount())
    {
        notes.push_back(name + ": it is not drawn; passIndex is " + std::to_string(passIndex) +
                        ", but the material '" + passMaterial->name() + "' has the passes 0..." +
                        std::to_string(passMaterial->passCount() - 1));
        return;
    }
    m_FullScreenPass->renderPassEvent =
        static_cast<RenderPassEvent>(static_cast<int>(injectionPoint));
    m_FullScreenPass->SetupMembers(passMaterial, passIndex, fetchColorBuffer,
                                   bindDepthStencilAttachment, requirements);
    renderer.EnqueuePass(*m_FullScreenPass);
}

void RegisterFullScreenPass(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<FullScreenPassRendererFeature>("FullScreenPassRendererFeature");
}

} // namespace limn
