#include <limn/features/MaskDifferenceOutlineRendererFeature.h>

#include <algorithm>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>

namespace limn
{

namespace
{

/// The names of the shader's inputs, the article's first, and of its passes.
struct MaskDifferenceNames
{
    ShaderPropertyId t_tex0{"t_tex0"};
    ShaderPropertyId t_tex1{"t_tex1"};
    ShaderPropertyId u_rt_size{"u_rt_size"};
    ShaderPropertyId width{"width"};
    ShaderPropertyId outline_depth_threshold_clip_player{"outline_depth_threshold_clip_player"};
    ShaderPropertyId _MaskValue{"_MaskValue"};
    ShaderPropertyId _BlitScaleBias{"_BlitScaleBias"};

    static constexpr int k_MaskPass = 0;
    static constexpr int k_OutlinePass = 1;
    static constexpr int k_FramebufferFetchPass = 2;
    static constexpr int k_NearestBlitPass = 0; ///< "Nearest" of CoreBlit.shader
};
const MaskDifferenceNames k_MaskDifference;

/// The depth of what is so far away from the camera's plane: 0 near plane ... 1 far plane.
double MaskDifferenceDepthAt(double distance, const Camera& camera)
{
    const glm::dmat4 projection(camera.gpuProjectionMatrix(1.0f)); // depth knows no shape
    const glm::dvec4 clip = projection * glm::dvec4(0.0, 0.0, -distance, 1.0);
    return clip.z < clip.w ? 1.0 - std::max(clip.z / clip.w, 0.0) : 0.0;
}

float MaskDifferenceThreshold(const MaskDifferenceOutline& component, const Camera& camera)
{
    const float threshold = component.outline_depth_threshold_clip_player.value();
    const float distance = component.m_ClipDistance.value();
    return distance > 0.0f
               ? std::min(threshold, static_cast<float>(MaskDifferenceDepthAt(distance, camera)))
               : threshold;
}

} // namespace

float MaskDifferenceOutline::reach() const
{
    return std::min(std::round(m_OutlineWidth.value()), k_WidestWidth);
}

void MaskDifferenceOutlineSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    inspector.Header("Mask Settings");
    DescribeGrouping(inspector, m_Grouping);
    inspector.Field("m_ColorByGroup", m_ColorByGroup,
                    "Gives each group a colour of its own in place of the volume's");
    inspector.Field("m_FramebufferFetch", m_FramebufferFetch,
                    "Adds the line in place, without a copy of the picture");
}

MaskDifferenceOutlinePass::MaskDifferenceOutlinePass(const std::string& featureName,
                                                     const MaskDifferenceOutlineSettings& settings,
                                                     std::shared_ptr<const Shader> shader)
    : OutlineTechniquePass(featureName, settings, shader), m_Settings(settings)
{
    if (shader->usesReversedZBuffer())
    {
        m_Material->EnableKeyword("USE_REVERSED_Z");
    }
    if (!settings.m_FramebufferFetch)
    {
        m_CopyMaterial = CoreUtils::CreateEngineMaterial(
            FindBuiltinShader("Hidden/Universal/CoreBlit", shader->compiler()));
    }
}

std::string MaskDifferenceOutlinePass::Setup(const MaskDifferenceOutline& component,
                                             const RenderingData& renderingData)
{
    FindOutlinedObjects(renderingData, m_Settings, m_Settings.m_Grouping, m_Found);
    if (m_Found.objects.empty())
    {
        return m_Found.why;
    }
    const float threshold = MaskDifferenceThreshold(component, *renderingData.cameraData.camera);
    if (threshold <= 0.0f)
    {
        return "every depth is clipped";
    }
    const auto region =
        FindOutlineRegion(m_Found.objects, renderingData.cameraData, component.reach());
    if (!region)
    {
        return "no line reaches the picture";
    }
    m_Color = component.m_OutlineColor.value();
    if (!m_Settings.m_ColorByGroup && m_Color.r <= 0.0f && m_Color.g <= 0.0f && m_Color.b <= 0.0f)
    {
        return "MaskDifferenceOutline.m_OutlineColor is black, which adds nothing";
    }
    m_Region = *region;
    const glm::vec2 size(m_Region.size);
    m_Material->SetVector(k_MaskDifference.u_rt_size, {size, 1.0f / size});
    m_Material->SetFloat(k_MaskDifference.width, component.reach());
    m_Material->SetFloat(k_MaskDifference.outline_depth_threshold_clip_player, threshold);
    const bool clipsDepth = threshold <= 1.0f; // the largest there is
    clipsDepth ? m_Material->DisableKeyword("_NO_DEPTH_CLIP")
               : m_Material->EnableKeyword("_NO_DEPTH_CLIP");
    ConfigureInput(clipsDepth ? ScriptableRenderPassInput::Depth : ScriptableRenderPassInput::None);
    return "";
}

void MaskDifferenceOutlinePass::OnCameraSetup(CommandBuffer&, RenderingData& renderingData)
{
    const bool tellsApart = m_Settings.m_Grouping != OutlineGrouping::Together;
    m_Region.Allocate(m_Mask,
                      tellsApart ? GraphicsFormat::R32G32B32A32_SFloat
                                 : GraphicsFormat::R16G16B16A16_SFloat,
                      "t_tex0");
    m_Material->SetTexture(k_MaskDifference.t_tex0, m_Mask.rt());
    if (tellsApart) // the nearest of several is the one that counts
    {
        m_Region.Allocate(m_MaskDepth, GraphicsFormat::D32_SFloat, "MaskDepth");
    }
    if (!m_Settings.m_FramebufferFetch)
    {
        RenderTextureDescriptor descriptor = renderingData.cameraData.cameraTargetDescriptor;
        descriptor.depthBufferBits = 0;
        descriptor.msaaSamples = 1;
        descriptor.memoryless = RenderTextureMemoryless::Color; // no next frame reads them
        RenderingUtils::ReAllocateIfNeeded(m_SceneColor, descriptor, FilterMode::Point,
                                           TextureWrapMode::Clamp, "t_tex1");
        m_Material->SetTexture(k_MaskDifference.t_tex1, m_SceneColor.rt());
    }
}

void MaskDifferenceOutlinePass::DrawMask(CommandBuffer& cmd, const CameraData& camera)
{
    CoreUtils::SetRenderTarget(cmd, m_Mask, m_MaskDepth, ClearFlag::All, Color::clear);
    SetRegionProjection(cmd, m_Region, camera);
    const glm::vec4 color = CoreUtils::ConvertSRGBToActiveColorSpace(m_Color).vector();
    m_Properties.Clear();
    for (const OutlinedObject& object : m_Found.objects)
    {
        const glm::vec3 rgb =
            m_Settings.m_ColorByGroup ? ColorOfGroup(object.group) : glm::vec3(color);
        m_Properties.SetVector(k_MaskDifference._MaskValue,
                               glm::vec4(rgb * color.a, IdOfGroup(object.group)));
        cmd.DrawRenderer(*object.item.object, m_Material, object.item.subMesh,
                         MaskDifferenceNames::k_MaskPass, m_Properties);
    }
    SetCameraProjection(cmd, camera);
}

void MaskDifferenceOutlinePass::Execute(ScriptableRenderContext& context,
                                        RenderingData& renderingData)
{
    const CameraData& camera = renderingData.cameraData;
    const RTHandle& color = camera.renderer->cameraColorTargetHandle();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    DrawMask(*cmd, camera);
    if (!m_Settings.m_FramebufferFetch)
    {
        Blitter::BlitCameraTexture(*cmd, color, m_SceneColor, m_CopyMaterial,
                                   MaskDifferenceNames::k_NearestBlitPass);
    }
    CoreUtils::SetRenderTarget(*cmd, color);
    cmd->SetViewport(m_Region.InPicture());
    m_Properties.Clear();
    m_Properties.SetVector(k_MaskDifference._BlitScaleBias, m_Region.ScaleBias());
    cmd->DrawProcedural(glm::mat4(1.0f), m_Material,
                        m_Settings.m_FramebufferFetch ? MaskDifferenceNames::k_FramebufferFetchPass
                                                      : MaskDifferenceNames::k_OutlinePass,
                        3, m_Properties);
    context.ExecuteCommandBuffer(*cmd);
}

void RegisterMaskDifferenceOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<MaskDifferenceOutlineRendererFeature>(
        "MaskDifferenceOutlineRendererFeature",
        {{.name = "Mask difference",
          .summary = "the article on post-processing: five samples of a mask",
          .isArticle = true,
          .place = 80,
          .component = "MaskDifferenceOutline",
          .settings = {"Outline.m_Grouping=Together"}}});
    components.Register<MaskDifferenceOutline>("MaskDifferenceOutline");
}

} // namespace limn
