#include "ScreenSpaceAmbientOcclusionPass.h"

#include "BlueNoise.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <limn/core/CoreUtils.h>
#include <limn/core/ScriptableRenderer.h>

namespace limn
{

namespace
{

using Settings = ScreenSpaceAmbientOcclusionSettings;

enum ShaderPass
{
    Occlusion,
    BilateralHorizontal,
    BilateralVertical,
    BilateralFinal,
    BilateralAfterOpaque,
    GaussianHorizontal,
    GaussianVertical,
    GaussianAfterOpaque,
    Kawase,
    KawaseAfterOpaque
};

const ShaderPropertyId _SSAOParams{"_SSAOParams"};
const ShaderPropertyId _SourceSize{"_SourceSize"};
const ShaderPropertyId _ProjectionParams2{"_ProjectionParams2"};
const ShaderPropertyId _CameraViewTopLeftCorner{"_CameraViewTopLeftCorner"};
const ShaderPropertyId _CameraViewXExtent{"_CameraViewXExtent"};
const ShaderPropertyId _CameraViewYExtent{"_CameraViewYExtent"};
const ShaderPropertyId _CameraViewZExtent{"_CameraViewZExtent"};
const ShaderPropertyId _CameraViewProjections{"_CameraViewProjections"};
const ShaderPropertyId _BlueNoiseTexture{"_BlueNoiseTexture"};
const ShaderPropertyId _SSAOBlueNoiseParams{"_SSAOBlueNoiseParams"};
const ShaderPropertyId _KawaseBlurIteration{"_KawaseBlurIteration"};
const ShaderPropertyId _LastKawasePass{"_LastKawasePass"};
const ShaderPropertyId _ScreenSpaceOcclusionTexture{"_ScreenSpaceOcclusionTexture"};
const ShaderPropertyId _AmbientOcclusionParam{"_AmbientOcclusionParam"};
/// Returns the keyword with which shaders read the occlusion. It is made once, as making it needs
/// memory.
const GlobalKeyword& OcclusionKeyword()
{
    static const GlobalKeyword keyword("_SCREEN_SPACE_OCCLUSION");
    return keyword;
}
constexpr float k_BlueNoiseRadius = 1.5f; ///< URP 14's: most of its samples lie near the pixel
constexpr float k_Largest = 1e9f;         ///< of settings: products of them stay finite

int SizeDivisor(const Settings& settings)
{
    return settings.Downsample ? 2 : 1;
}

glm::ivec2 OcclusionSize(const Settings& settings, const CameraData& cameraData)
{
    const RenderTextureDescriptor& camera = cameraData.cameraTargetDescriptor;
    return glm::max(glm::ivec2(camera.width, camera.height) / SizeDivisor(settings), glm::ivec2(1));
}

/// @throws ContractError if the value is none of its enum's
template <typename Enum, std::size_t Count>
const char* Keyword(const char* setting, Enum value, const std::array<const char*, Count>& keywords)
{
    const auto index = static_cast<std::size_t>(value);
    if (index >= Count)
    {
        throw ContractError("ScreenSpaceAmbientOcclusion." + std::string(setting) + " is " +
                            std::to_string(static_cast<int>(value)) + "; it must be 0..." +
                            std::to_string(Count - 1));
    }
    return keywords[index];
}

} // namespace

void SetSsaoConstants(CommandBuffer& cmd, const Settings& settings, const CameraData& cameraData)
{
    // From the camera's place, along the axes of the world; in double, since far/near may be 1e9.
    glm::dmat4 view = cameraData.viewMatrix;
    view[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    const glm::dmat4 viewProjection = cameraData.GetProjectionMatrix() * view;
    const glm::dmat4 inverse = glm::inverse(viewProjection);
    const auto point = [&inverse](double x, double y, double z)
    {
        const glm::dvec4 place = inverse * glm::dvec4(x, y, z, 1.0);
        return glm::dvec3(place) / place.w;
    };
    const glm::dvec3 topLeft = point(-1.0, 1.0, -1.0);
    const auto set = [&cmd](ShaderPropertyId id, const glm::dvec3& value)
    {
        const glm::vec4 element(glm::vec3(value), 0.0f);
        cmd.SetGlobalVectorArray(id, {element, element}); // an eye each
    };
    set(_CameraViewTopLeftCorner, topLeft);
    set(_CameraViewXExtent, point(1.0, 1.0, -1.0) - topLeft);
    set(_CameraViewYExtent, point(-1.0, -1.0, -1.0) - topLeft);
    set(_CameraViewZExtent, point(0.0, 0.0, 1.0));
    const glm::mat4 floats(viewProjection);
    cmd.SetGlobalMatrixArray(_CameraViewProjections, {floats, floats});
    const double near = cameraData.camera->nearClipPlane;
    cmd.SetGlobalVector(_ProjectionParams2,
                        {near != 0.0 ? static_cast<float>(1.0 / near) : 0.0f, 0.0f, 0.0f, 0.0f});

    const bool isBlueNoise = settings.AOMethod == Settings::AOMethodOptions::BlueNoise;
    const float radius = settings.Radius * (isBlueNoise ? k_BlueNoiseRadius : 1.0f);
    cmd.SetGlobalVector(_SSAOParams,
                        {std::min(settings.Intensity, k_Largest), std::min(radius, k_Largest),
                         1.0f / static_cast<float>(SizeDivisor(settings)),
                         std::min(settings.Falloff, k_Largest)});
    const RenderTextureDescriptor& camera = cameraData.cameraTargetDescriptor;
    const glm::vec2 size(camera.width, camera.height);
    cmd.SetGlobalVector(_SourceSize, glm::vec4(size, 1.0f / size));
    const glm::vec2 repeats =
        glm::vec2(OcclusionSize(settings, cameraData)) / static_cast<float>(k_BlueNoiseSize);
    cmd.SetGlobalVector(_SSAOBlueNoiseParams, glm::vec4(repeats, 0.0f, 0.0f));
}

ScreenSpaceAmbientOcclusionPass::ScreenSpaceAmbientOcclusionPass(
    const std::string& featureName, std::shared_ptr<const Shader> shader)
    : m_Material(CoreUtils::CreateEngineMaterial(std::move(shader)))
{
    profilingSampler = ProfilingSampler(featureName);
    m_Material->SetFloat(_KawaseBlurIteration, 0.0f);
    m_Material->SetInt(_LastKawasePass, 1);
}

void ScreenSpaceAmbientOcclusionPass::Setup(const Settings& settings, const CameraData& cameraData)
{
    m_Settings = settings;
    renderPassEvent = settings.AfterOpaque ? RenderPassEvent::AfterRenderingOpaques
                                           : RenderPassEvent::AfterRenderingPrePasses + 1;
    ConfigureInput(settings.Source == Settings::DepthSource::DepthNormals
                       ? ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Normal
                       : ScriptableRenderPassInput::Depth);
    SetKeywords(cameraData.camera->orthographic);
}

void ScreenSpaceAmbientOcclusionPass::SetKeywords(bool isOrthographic)
{
    const bool isBlueNoise = m_Settings.AOMethod == Settings::AOMethodOptions::BlueNoise;
    const std::array<std::string_view, 4> wanted{
        Keyword("AOMethod", m_Settings.AOMethod,
                std::array{"_BLUE_NOISE", "_INTERLEAVED_GRADIENT"}),
        m_Settings.Source == Settings::DepthSource::DepthNormals
            ? "_SOURCE_DEPTH_NORMALS"
            : Keyword(
                  "NormalSamples", m_Settings.NormalSamples,
                  std::array{"_SOURCE_DEPTH_LOW", "_SOURCE_DEPTH_MEDIUM", "_SOURCE_DEPTH_HIGH"}),
        Keyword("Samples", m_Settings.Samples,
                std::array{"_SAMPLE_COUNT_HIGH", "_SAMPLE_COUNT_MEDIUM", "_SAMPLE_COUNT_LOW"}),
        isOrthographic ? "_ORTHOGRAPHIC" : ""};
    if (wanted == m_Keywords)
    {
        return;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        if (!m_Keywords[i].empty())
        {
            m_Material->DisableKeyword(std::string(m_Keywords[i]));
        }
        if (!wanted[i].empty())
        {
            m_Material->EnableKeyword(std::string(wanted[i]));
        }
    }
    m_Keywords = wanted;
    if (isBlueNoise)
    {
        m_Material->SetTexture(_BlueNoiseTexture, BlueNoise());
    }
}

void ScreenSpaceAmbientOcclusionPass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    const glm::ivec2 size = OcclusionSize(m_Settings, renderingData.cameraData);
    const bool isBilateral = m_Settings.BlurQuality == Settings::BlurQualityOptions::High;
    const bool isGaussian = m_Settings.BlurQuality == Settings::BlurQualityOptions::Medium;
    RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
    const auto allocate = [&descriptor](RTHandle& handle, const char* textureName)
    {
        RenderingUtils::ReAllocateIfNeeded(handle, descriptor, FilterMode::Bilinear,
                                           TextureWrapMode::Clamp, textureName);
    };
    descriptor.depthBufferBits = 0;
    descriptor.msaaSamples = 1;
    descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads them
    descriptor.graphicsFormat = GraphicsFormat::R8_UNorm;
    ResetTarget();
    if (!m_Settings.AfterOpaque)
    {
        allocate(m_Result, "_ScreenSpaceOcclusionTexture");
        ConfigureTarget(m_Result); // else the camera's would be cleared and stored too early
    }
    descriptor.width = size.x;
    descriptor.height = size.y;
    descriptor.graphicsFormat =
        isBilateral ? GraphicsFormat::R8G8B8A8_UNorm : GraphicsFormat::R8_UNorm;
    allocate(m_Occlusion, "_SSAO_OcclusionTexture0");
    if (isBilateral || isGaussian)
    {
        allocate(m_BlurredOnce, "_SSAO_OcclusionTexture1");
    }
    if (isBilateral)
    {
        allocate(m_BlurredTwice, "_SSAO_OcclusionTexture2");
    }
}

void ScreenSpaceAmbientOcclusionPass::Execute(ScriptableRenderContext& context,
                                              RenderingData& renderingData)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    SetSsaoConstants(*cmd, m_Settings, renderingData.cameraData);
    int lastPass = 0;
    const RTHandle& last = DrawUpToLastBlur(*cmd, lastPass);
    if (m_Settings.AfterOpaque)
    {
        const ScriptableRenderer& renderer = *renderingData.cameraData.renderer;
        m_Properties.Clear();
        m_Properties.SetTexture(Blitter::BlitShaderIDs::_BlitTexture, last.rt());
        m_Properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias,
                               glm::vec4(1.0f, 1.0f, 0.0f, 0.0f));
        CoreUtils::SetRenderTarget(*cmd, renderer.cameraColorTargetHandle(),
                                   renderer.cameraDepthTargetHandle());
        CoreUtils::DrawFullScreen(*cmd, m_Material, m_Properties, lastPass + 1);
    }
    else
    {
        Blitter::BlitCameraTexture(*cmd, last, m_Result, m_Material, lastPass);
        cmd->SetGlobalTexture(_ScreenSpaceOcclusionTexture, m_Result);
        cmd->SetGlobalVector(_AmbientOcclusionParam,
                             {1.0f, 0.0f, 0.0f, m_Settings.DirectLightingStrength});
        cmd->SetKeyword(OcclusionKeyword(), true);
    }
    context.ExecuteCommandBuffer(*cmd);
}

const RTHandle& ScreenSpaceAmbientOcclusionPass::DrawUpToLastBlur(CommandBuffer& cmd, int& lastPass)
{
    const auto blur = [&](const RTHandle& source, const RTHandle& target, ShaderPass pass)
    {
        Blitter::BlitCameraTexture(cmd, source, target, m_Material, pass);
    };
    CoreUtils::SetRenderTarget(cmd, m_Occlusion);
    m_Properties.Clear();
    m_Properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias,
                           glm::vec4(1.0f, 1.0f, 0.0f, 0.0f));
    CoreUtils::DrawFullScreen(cmd, m_Material, m_Properties, Occlusion);
    switch (m_Settings.BlurQuality)
    {
    case Settings::BlurQualityOptions::High:
        blur(m_Occlusion, m_BlurredOnce, BilateralHorizontal);
        blur(m_BlurredOnce, m_BlurredTwice, BilateralVertical);
        lastPass = BilateralFinal;
        return m_BlurredTwice;
    case Settings::BlurQualityOptions::Medium:
        blur(m_Occlusion, m_BlurredOnce, GaussianHorizontal);
        lastPass = GaussianVertical;
        return m_BlurredOnce;
    case Settings::BlurQualityOptions::Low:
        lastPass = Kawase;
        return m_Occlusion;
    }
    throw ContractError("ScreenSpaceAmbientOcclusion.BlurQuality is " +
                        std::to_string(static_cast<int>(m_Settings.BlurQuality)) +
                        "; it must be High 0, Medium 1 or Low 2");
}

void ScreenSpaceAmbientOcclusionPass::OnCameraCleanup(CommandBuffer& cmd)
{
    cmd.SetKeyword(OcclusionKeyword(), false);
}

} // namespace limn
