#include "StrokeDraws.h"

#include <array>
#include <limn/base/NumberText.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/features/StrokeOutlineRendererFeature.h>
#include <numeric>

namespace limn
{

namespace
{

constexpr int k_OwnDepthPass = 0;
constexpr int k_StrokePass = 1;
constexpr int k_CompositePass = 2;
constexpr int k_VerticesPerQuad = 6;
/// Pixels. What is thinner covers less of a pixel than half a step of 8 bits, and less than what
/// the borders of the objects are known to.
constexpr float k_LeastWidth = 1.0f / 512.0f;

constexpr EnumEntry k_Occlusions[] = {{"All", 0}, {"Visible", 1}, {"Hidden", 2}, {"SeeThrough", 3}};

const ShaderPropertyId _OccludedColor = Shader::PropertyToID("_OccludedColor");
const ShaderPropertyId _OutlineRegion = Shader::PropertyToID("_OutlineRegion");
const ShaderPropertyId _OutlinePicture = Shader::PropertyToID("_OutlinePicture");
const ShaderPropertyId _Strokes = Shader::PropertyToID("_Strokes");
const ShaderPropertyId _Tiles = Shader::PropertyToID("_Tiles");
const ShaderPropertyId _StrokeDepth = Shader::PropertyToID("_StrokeDepth");
const ShaderPropertyId _StrokeCoverage = Shader::PropertyToID("_StrokeCoverage");
const ShaderPropertyId _StrokeEdges = Shader::PropertyToID("_StrokeEdges");

/// Sets the opacity of strokes where the silhouette is visible, and where it is hidden.
void SetColors(Material& material, const StrokeOutline& component, OutlineOcclusion occlusion)
{
    Color visible = component.m_OutlineColor.value();
    Color hidden = visible;
    if (occlusion == OutlineOcclusion::SeeThrough)
    {
        hidden = component.m_OccludedColor.value();
    }
    visible.a = occlusion == OutlineOcclusion::Hidden ? 0.0f : visible.a;
    hidden.a = occlusion == OutlineOcclusion::Visible ? 0.0f : hidden.a;
    material.SetColor(OutlineShaderIDs::_OutlineColor, visible);
    material.SetColor(_OccludedColor, hidden);
}

void DrawQuads(CommandBuffer& cmd, const std::shared_ptr<Material>& material, int pass,
               ShaderPropertyId id, const ShaderArrays& arrays, MaterialPropertyBlock& properties)
{
    for (const std::vector<glm::vec4>& part : arrays.parts)
    {
        properties.Set(id, PropertyArray<glm::vec4>(std::span(part)));
        const int count = static_cast<int>(part.size()) / arrays.stride;
        cmd.DrawProcedural(glm::mat4(1.0f), material, pass, count * k_VerticesPerQuad, properties);
    }
}

} // namespace

void StrokeOutlineSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    inspector.Header("Strokes");
    DescribeGrouping(inspector, m_Grouping);
    inspector.Field("m_Occlusion", m_Occlusion, k_Occlusions,
                    "The treatment of the parts that something hides");
}

StrokeOutlinePass::StrokeOutlinePass(const std::string& featureName,
                                     const StrokeOutlineSettings& settings,
                                     std::shared_ptr<const Shader> shader)
    : OutlineTechniquePass(featureName, settings, std::move(shader)),
      m_Settings(settings),
      m_Finder(std::make_unique<SilhouetteFinder>())
{
    if (settings.m_Occlusion != OutlineOcclusion::All)
    {
        ConfigureInput(ScriptableRenderPassInput::Depth);
        m_Material->EnableKeyword("_STROKE_OCCLUSION");
    }
}

StrokeOutlinePass::~StrokeOutlinePass() = default;

std::string StrokeOutlinePass::Setup(const StrokeOutline& volumeComponent,
                                     const RenderingData& renderingData)
{
    if (volumeComponent.m_OutlineWidth.value() < k_LeastWidth)
    {
        return "StrokeOutline.m_OutlineWidth is less than " +
               NumberText(static_cast<double>(k_LeastWidth)) +
               " pixels, which is too little to be seen";
    }
    FindOutlinedObjects(renderingData, m_Settings, m_Settings.m_Grouping, m_Found);
    if (m_Found.objects.empty())
    {
        return m_Found.why;
    }
    const CameraData& camera = renderingData.cameraData;
    const glm::ivec2 picture(camera.cameraTargetDescriptor.width,
                             camera.cameraTargetDescriptor.height);
    const double width = volumeComponent.WidthWithin(picture);
    m_Material->SetFloat(OutlineShaderIDs::_OutlineWidth, static_cast<float>(width));
    SetColors(*m_Material, volumeComponent, m_Settings.m_Occlusion);

    const glm::dmat4 viewProjection = camera.reversedViewProjection();
    std::size_t used = 0;
    ForEachGroup(m_Found.objects,
                 [&](std::span<const OutlinedObject> objects)
                 {
                     m_Strokes.clear();
                     for (const OutlinedObject& object : objects)
                     {
                         const GameObject& gameObject = *object.item.object;
                         m_Finder->Append(gameObject.renderer->mesh, object.item.subMesh,
                                          viewProjection * gameObject.transform.worldMatrix(),
                                          picture, m_Strokes);
                     }
                     if (used == m_Groups.size())
                     {
                         m_Groups.push_back(std::make_unique<StrokeDraws>());
                     }
                     m_Groups[used]->objects = objects;
                     used += m_Groups[used]->Assign(m_Strokes, width, picture);
                 });
    m_Groups.resize(used);
    return used > 0 ? "" : "no silhouette of the objects is within reach of the picture";
}

void StrokeOutlinePass::OnCameraSetup(CommandBuffer&, RenderingData&)
{
    for (const auto& group : m_Groups)
    {
        const OutlineRegion& region = group->region;
        region.Allocate(group->depth, GraphicsFormat::D32_SFloat, "_StrokeDepth");
        region.Allocate(group->coverage, GraphicsFormat::R16G16B16A16_SFloat, "_StrokeCoverage");
        // Red is what edges correct, alpha what is covered by what is seen.
        const bool hasOcclusion = m_Settings.m_Occlusion != OutlineOcclusion::All;
        region.Allocate(group->edges,
                        hasOcclusion ? GraphicsFormat::R16G16B16A16_SFloat
                                     : GraphicsFormat::R16_SFloat,
                        "_StrokeEdges");
    }
}

void StrokeOutlinePass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    {
        const ProfilingScope scope{*cmd, profilingSampler};
        for (const auto& group : m_Groups)
        {
            DrawGroup(*cmd, *group, renderingData.cameraData);
        }
    }
    context.ExecuteCommandBuffer(*cmd);
}

void StrokeOutlinePass::DrawGroup(CommandBuffer& cmd, const StrokeDraws& group,
                                  const CameraData& camera)
{
    DrawOwnDepth(cmd, group, camera);

    const OutlineRegion& region = group.region;
    MaterialPropertyBlock& properties = m_Properties;
    properties.Clear();
    properties.SetVector(_OutlineRegion, glm::vec4(region.corner, region.size));
    properties.SetVector(_OutlinePicture, glm::vec4(region.picture, 0, 0));
    properties.SetTexture(_StrokeDepth, group.depth.rt());
    CoreUtils::SetRenderTarget(cmd, std::array{group.coverage, group.edges}, {}, ClearFlag::Color,
                               Color::clear);
    DrawQuads(cmd, m_Material, k_StrokePass, _Strokes, group.strokes, properties);

    properties.Remove(_Strokes);
    properties.SetTexture(_StrokeCoverage, group.coverage.rt());
    properties.SetTexture(_StrokeEdges, group.edges.rt());
    CoreUtils::SetRenderTarget(cmd, camera.renderer->cameraColorTargetHandle());
    DrawQuads(cmd, m_Material, k_CompositePass, _Tiles, group.tiles, properties);
}

void StrokeOutlinePass::DrawOwnDepth(CommandBuffer& cmd, const StrokeDraws& group,
                                     const CameraData& camera)
{
    CoreUtils::SetRenderTarget(cmd, group.depth, ClearFlag::Depth);
    SetRegionProjection(cmd, group.region, camera);
    for (const OutlinedObject& object : group.objects)
    {
        cmd.DrawRenderer(*object.item.object, m_Material, object.item.subMesh, k_OwnDepthPass);
    }
    SetCameraProjection(cmd, camera);
}

double StrokeOutlinePass::strokeArea() const
{
    return std::accumulate(m_Groups.begin(), m_Groups.end(), 0.0,
                           [](double sum, const auto& group) { return sum + group->strokeArea; });
}

int StrokeOutlinePass::edgeCount() const
{
    return std::accumulate(m_Groups.begin(), m_Groups.end(), 0,
                           [](int sum, const auto& group) { return sum + group->edgeCount; });
}

void RegisterStrokeOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<StrokeOutlineRendererFeature>(
        "StrokeOutlineRendererFeature", {{.name = "Strokes",
                                          .summary = "silhouette edges drawn as geometry",
                                          .place = 10,
                                          .component = "StrokeOutline",
                                          .settings = {"Outline.m_Grouping=Together"},
                                          .occlusion = "Outline.m_Occlusion"}});
    components.Register<StrokeOutline>("StrokeOutline");
}

} // namespace limn
