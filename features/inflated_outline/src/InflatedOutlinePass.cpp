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

/// Returns the distance of the nearest object along the view axis, to the middle of its bounds.
double DepthOf(std::span<const OutlinedObject> objects, const glm::dmat4& view)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const OutlinedObject& object : objects)
    {
        nearest = std::min(nearest, -(view * glm::dvec4(object.item.boundsCenter, 1.0)).z);
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
    FindOutlinedObjects(renderingData, m_Settings, m_Settings.m_Grouping, m_Found);
    if (!m_Found.why.empty())
    {
        return m_Found.why;
    }
    m_Groups.clear();
    const glm::dmat4 view = renderingData.cameraData.camera->viewMatrix();
    for (auto first = m_Found.objects.begin(); first != m_Found.objects.end();)
    {
        const auto end = std::find_if(first, m_Found.objects.end(),
                                      [&](const OutlinedObject& object)
                                      { return object.group != first->group; });
        const std::span<const OutlinedObject> objects(first, end);
        m_Groups.push_back({objects, DepthOf(objects, view)});
        first = end;
    }
    std::ranges::sort(
        m_Groups, [](const Group& a, const Group& b)
        { return a.depth != b.depth ? a.depth > b.depth : a.objects.data() < b.objects.data(); });
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
    for (const Group& group : m_Groups)
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

} // namespace limn
