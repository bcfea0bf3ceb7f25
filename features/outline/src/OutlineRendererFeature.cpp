#include <limn/core/CoreUtils.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

std::shared_ptr<const Shader> FindTechniqueShader(const ScriptableRenderer& renderer,
                                                  std::string_view name)
{
    const std::shared_ptr<ShaderCompiler> compiler = renderer.shaderCompiler();
    if (!compiler)
    {
        throw ContractError("the renderer has no shader compiler; UniversalRenderer has one");
    }
    return FindShippedShader(name, compiler);
}

OutlineTechniquePass::OutlineTechniquePass(const std::string& featureName,
                                           const OutlineSettings& settings,
                                           std::shared_ptr<const Shader> shader)
    : m_Material(CoreUtils::CreateEngineMaterial(std::move(shader)))
{
    profilingSampler = ProfilingSampler(featureName);
    renderPassEvent = settings.m_RenderPassEvent;
}

void OutlineTechniquePass::DrawFiltered(ScriptableRenderContext& context,
                                        const RenderingData& renderingData,
                                        const FilteringSettings& filtering, int shaderPass) const
{
    DrawingSettings drawing =
        CreateDrawingSettings(ForwardShaderTags(), renderingData, SortingCriteria::CommonOpaque);
    drawing.overrideMaterial = m_Material;
    drawing.overrideMaterialPassIndex = shaderPass;
    context.DrawRenderers(renderingData.cullResults, drawing, filtering);
}

void OutlineTechniquePass::EnableOneOf(std::span<const char* const> keywords, std::size_t chosen,
                                       std::string_view setting, std::string_view choices) const
{
    if (chosen >= keywords.size())
    {
        throw ContractError(std::string(setting) + " is " + std::to_string(chosen) +
                            "; it must be " + std::string(choices));
    }
    for (const char* keyword : keywords)
    {
        m_Material->DisableKeyword(keyword);
    }
    m_Material->EnableKeyword(keywords[chosen]);
}

} // namespace limn
