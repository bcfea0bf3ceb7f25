#include <limn/features/DepthNormalsOutlineRendererFeature.h>

namespace limn
{

namespace
{

const ShaderPropertyId _OutlineThickness{"_OutlineThickness"};
const ShaderPropertyId _DepthThreshold{"_DepthThreshold"};
const ShaderPropertyId _AngleThreshold{"_AngleThreshold"};
const ShaderPropertyId _Softness{"_Softness"};
const ShaderPropertyId _DepthSensitivity{"_DepthSensitivity"};
const ShaderPropertyId _NormalsSensitivity{"_NormalsSensitivity"};

int PassOf(DepthNormalsTechnique technique)
{
    switch (technique)
    {
    case DepthNormalsTechnique::Article:
        return 0;
    case DepthNormalsTechnique::Hardened:
        return 1;
    }
    throw ContractError("DepthNormalsOutline.m_Technique is " +
                        std::to_string(static_cast<int>(technique)) +
                        "; it must be Hardened 0 or Article 1");
}

} // namespace

DepthNormalsOutlinePass::DepthNormalsOutlinePass(const std::string& featureName,
                                                 const OutlineSettings& settings,
                                                 std::shared_ptr<const Shader> shader)
    : OutlineTechniquePass(featureName, settings, std::move(shader)), m_Settings(settings)
{
    ConfigureInput(ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Normal);
}

std::string DepthNormalsOutlinePass::Setup(const DepthNormalsOutline& component,
                                           const RenderingData& renderingData)
{
    const RenderTextureDescriptor& camera = renderingData.cameraData.cameraTargetDescriptor;
    m_MaterialPass = PassOf(component.m_Technique.value());
    m_Material->SetColor(OutlineShaderIDs::_OutlineColor, component.m_OutlineColor.value());
    m_Material->SetFloat(_OutlineThickness, component.WidthWithin({camera.width, camera.height}));
    m_Material->SetFloat(_DepthThreshold, component.m_DepthThreshold.value());
    m_Material->SetFloat(_AngleThreshold, component.m_AngleThreshold.value());
    m_Material->SetFloat(_Softness, component.m_Softness.value());
    m_Material->SetFloat(_DepthSensitivity, component.m_DepthSensitivity.value());
    m_Material->SetFloat(_NormalsSensitivity, component.m_NormalsSensitivity.value());
    FindOutlinedObjects(renderingData, m_Settings, OutlineGrouping::Together, m_Found);
    return m_Found.why;
}

void DepthNormalsOutlinePass::Execute(ScriptableRenderContext& context,
                                      RenderingData& renderingData)
{
    DrawFiltered(context, renderingData, m_Settings.filtering(), m_MaterialPass);
}

void RegisterDepthNormalsOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<DepthNormalsOutlineRendererFeature>(
        "DepthNormalsOutlineRendererFeature",
        {{.name = "Depth and normals (article)",
          .summary = "the article on depth and normals, its formula",
          .isArticle = true,
          .noWidth = "its lines lie on both sides of an edge",
          .place = 90,
          .component = "DepthNormalsOutline",
          .settings = {"DepthNormalsOutline.m_Technique=Article"}},
         {.name = "Depth and normals",
          .summary = "depth and normals by metres and degrees",
          .noWidth = "its lines lie on both sides of an edge",
          .place = 100,
          .component = "DepthNormalsOutline"}});
    components.Register<DepthNormalsOutline>("DepthNormalsOutline");
}

} // namespace limn
