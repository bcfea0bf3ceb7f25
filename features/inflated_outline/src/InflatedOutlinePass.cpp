#include <limn/features/InflatedOutlinePass.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limn/core/Camera.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/InflatedOutlineRendererFeature.h>

namespace limn
{

namespace
{

const ShaderPropertyId _InflatedColor{"_InflatedColor"};
const ShaderPropertyId _InflatedWidth{"_InflatedWidth"};

/// Returns the distance of the nearest item along the view axis, measured to the middle of its
/// bounds.
double DepthOf(const std::vector<RendererItem>& items, const glm::dmat4& view)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const RendererItem& item : items)
    {
        nearest = std::min(nearest, -(view * glm::dvec4(item.boundsCenter, 1.0)).z);
    }
    return nearest;
}

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

InflatedOutlinePass::InflatedOutlinePass(const std::string& featureName,
                                         const InflatedOutlineSettings& settings,
                                         std::shared_ptr<const Shader> shader)
    : m_Settings(settings), m_Material(CoreUtils::CreateEngineMaterial(std::move(shader)))
{
    profilingSampler = ProfilingSampler(featureName);
    renderPassEvent = settings.m_RenderPassEvent;
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
    OutlinedObjects found = FindOutlinedObjects(renderingData, m_Settings, m_Settings.m_Grouping);
    if (!found.why.empty())
    {
        return found.why;
    }
    m_Groups.assign(static_cast<std::size_t>(found.groupCount), {});
    for (OutlinedObject& object : found.objects)
    {
        m_Groups[static_cast<std::size_t>(object.group)].push_back(std::move(object.item));
    }
    const glm::dmat4 view = renderingData.cameraData.camera->viewMatrix();
    std::ranges::stable_sort(m_Groups, std::ranges::greater{},
                             [&view](const Items& items) { return DepthOf(items, view); });
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
    for (const Items& items : m_Groups)
    {
        for (const RendererItem& item : items)
        {
            cmd->DrawRenderer(*item.object, m_Material, item.subMesh, m_HullPass);
        }
        for (const RendererItem& item : items)
        {
            DrawForward(*cmd, item);
        }
    }
    context.ExecuteCommandBuffer(*cmd);
    m_Groups.clear();
}

} // namespace limn
