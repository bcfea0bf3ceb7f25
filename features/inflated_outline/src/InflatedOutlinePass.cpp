#include <limn/features/InflatedOutlineRendererFeature.h>

#include <limn/core/Inspector.h>

namespace limn
{

namespace
{

const ShaderPropertyId _InflatedColor{"_InflatedColor"};
const ShaderPropertyId _InflatedWidth{"_InflatedWidth"};

/// Draws the item with its own material, as DrawRenderers does.
void DrawForward(CommandBuffer& cmd, const RendererItem& item)
{
    for (const ShaderTagId tag : ForwardShaderTags())
    {
        const int pass = item.material->shader()->FindPassByLightMode(tag);
        if (pass >= 0)
        {
            cmd.DrawRenderer(*item.object, item.material, item.subMesh, pass);
        }
    }
}

} // namespace

void InflatedOutlineSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    DescribeGrouping(inspector, m_Grouping);
}

std::string InflatedOutlinePass::Setup(const InflatedOutline& component,
                                       const RenderingData& renderingData)
{
    m_HullPass = static_cast<int>(component.m_WidthUnit.value());
    if (m_HullPass < 0 || m_HullPass > 1)
    {
        throw ContractError("InflatedOutline.m_WidthUnit is " + std::to_string(m_HullPass) +
                            "; it must be Pixels 0 or Metres 1");
    }
    if (m_HullPass == 1 && component.m_WidthInMetres.value() <= 0.0f)
    {
        return "InflatedOutline.m_WidthInMetres is 0";
    }
    FindOutlinedObjects(renderingData, m_Settings, m_Settings.m_Grouping, m_Found);
    if (!m_Found.why.empty())
    {
        return m_Found.why;
    }
    FindGroupsByDepth(m_Found, renderingData.cameraData.viewMatrix, m_Groups);
    const RenderTextureDescriptor& camera = renderingData.cameraData.cameraTargetDescriptor;
    m_Material->SetColor(_InflatedColor, component.m_OutlineColor.value());
    m_Material->SetFloat(_InflatedWidth, m_HullPass == 0
                                             ? component.WidthWithin({camera.width, camera.height})
                                             : component.m_WidthInMetres.value());
    return "";
}

void InflatedOutlinePass::Execute(ScriptableRenderContext& context, RenderingData&)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    for (const OutlinedGroup& group : m_Groups)
    {
        for (const OutlinedObject& object : group.objects)
        {
            cmd->DrawRenderer(*object.item.object, m_Material, object.item.subMesh, m_HullPass);
        }
        for (const OutlinedObject& object : group.objects)
        {
            DrawForward(*cmd, object.item);
        }
    }
    context.ExecuteCommandBuffer(*cmd);
    m_Groups.clear();
}

void RegisterInflatedOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<InflatedOutlineRendererFeature>(
        "InflatedOutlineRendererFeature", {{.name = "Inflated",
                                            .summary = "vertices moved outwards in pixels",
                                            .place = 50,
                                            .component = "InflatedOutline",
                                            .settings = {"Outline.m_Grouping=Together"},
                                            .hiddenAt = HiddenAt::Point}});
    components.Register<InflatedOutline>("InflatedOutline");
}

} // namespace limn
