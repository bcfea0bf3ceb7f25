#include <limn/features/RimOutlineRendererFeature.h>

#include <cmath>
#include <glm/trigonometric.hpp>

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

std::string RimOutlinePass::Setup(const RimOutline& component, const RenderingData& renderingData)
{
    EnableOneOf(k_RimKeywords, static_cast<std::size_t>(component.m_Variant.value()),
                "RimOutline.m_Variant", "Soft 0, Threshold 1 or Pixels 2");
    FindOutlinedObjects(renderingData, m_Settings, OutlineGrouping::Together, m_Found);
    if (!m_Found.why.empty())
    {
        return m_Found.why;
    }
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
    DrawFiltered(context, renderingData, m_Settings.filtering(), 0);
}

void RegisterRimOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<RimOutlineRendererFeature>(
        "RimOutlineRendererFeature",
        {{.name = "Rim",
          .summary = "where normal and view are at right angles",
          .noWidth = "its rim lies within the object and is as wide as the object is curved",
          .place = 120,
          .component = "RimOutline"}});
    components.Register<RimOutline>("RimOutline");
}

} // namespace limn
