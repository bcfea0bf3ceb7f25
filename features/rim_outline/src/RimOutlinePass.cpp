#include <limn/features/RimOutlinePass.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <limn/core/CoreUtils.h>
#include <limn/features/OutlinedObjects.h>
#include <limn/features/RimOutlineRendererFeature.h>

namespace limn
{

namespace
{

const ShaderPropertyId _RimColor{"_RimColor"};
const ShaderPropertyId _RimWidth{"_RimWidth"};
const ShaderPropertyId _RimFalloff{"_RimFalloff"};
const ShaderPropertyId _RimCosine{"_RimCosine"};

constexpr const char* k_RimKeywords[] = {"_SOFT", "_THRESHOLD", "_PIXELS"}; // by RimVariant

} // namespace

RimOutlinePass::RimOutlinePass(const std::string& featureName, const RimOutlineSettings& settings,
                               std::shared_ptr<const Shader> shader)
    : m_Settings(settings), m_Material(CoreUtils::CreateEngineMaterial(std::move(shader)))
{
    profilingSampler = ProfilingSampler(featureName);
    renderPassEvent = settings.m_RenderPassEvent;
}

std::string RimOutlinePass::Setup(const RimOutline& component, const RenderingData& renderingData)
{
    const auto chosen = static_cast<std::size_t>(component.m_Variant.value());
    if (chosen >= std::size(k_RimKeywords))
    {
        throw ContractError("RimOutline.m_Variant is " + std::to_string(chosen) +
                            "; it must be Soft 0, Threshold 1 or Pixels 2");
    }
    FindOutlinedObjects(renderingData, m_Settings, OutlineGrouping::Together, m_Found);
    if (!m_Found.why.empty())
    {
        return m_Found.why;
    }
    for (const char* keyword : k_RimKeywords)
    {
        m_Material->DisableKeyword(keyword);
    }
    m_Material->EnableKeyword(k_RimKeywords[chosen]);
    const RenderTextureDescriptor& camera = renderingData.cameraData.cameraTargetDescriptor;
    const double angle = glm::radians(static_cast<double>(component.m_ThresholdAngle.value()));
    m_Material->SetColor(_RimColor, component.m_OutlineColor.value());
    m_Material->SetFloat(_RimWidth, component.WidthWithin({camera.width, camera.height}));
    m_Material->SetFloat(_RimFalloff, component.m_Falloff.value());
    m_Material->SetFloat(_RimCosine, static_cast<float>(std::cos(angle)));
    return "";
}

void RimOutlinePass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    DrawingSettings drawing =
        CreateDrawingSettings(ForwardShaderTags(), renderingData, SortingCriteria::CommonOpaque);
    drawing.overrideMaterial = m_Material;
    drawing.overrideMaterialPassIndex = 0;
    context.DrawRenderers(renderingData.cullResults, drawing, m_Settings.filtering());
}

} // namespace limn
