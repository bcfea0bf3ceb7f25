#include <algorithm>
#include <cmath>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Inspector.h>
#include <limn/features/SelectionOutlineRendererFeature.h>
#include <numbers>

namespace limn
{

namespace selection_outline // feature folders may be one translation unit
{
namespace
{

// passes of limn's own shader
constexpr int k_StencilPass = 0;
constexpr int k_BlurPass = 1;
constexpr int k_CompositePass = 2;
constexpr int k_CopyPass = 0;            // of CoreBlit.shader
constexpr float k_ArticlesWidth = 14.0f; // seven blurs of two pixels
constexpr EnumEntry k_Stencils[] = {{"DrawRenderer", 0}, {"HighlightLayer", 1}};

const ShaderPropertyId _Time{"_Time"};
const ShaderPropertyId _StartTime{"_StartTime"};
const ShaderPropertyId _VaryingColor{"_VaryingColor"};
const ShaderPropertyId _OffsetScale{"_OffsetScale"};
const ShaderPropertyId _OutlineStrength{"_OutlineStrength"};
const ShaderPropertyId _StencilTex{"_StencilTex"};
const ShaderPropertyId _BlurTex{"_BlurTex"};

/// A time at which sines of t/20, t, 2t and 3t are what they are at `seconds`, but small enough for
/// a float.
double WrapTime(double seconds)
{
    return std::fmod(seconds, 40.0 * std::numbers::pi);
}

/// Objects in another layer until the scope ends.
class InAnotherLayer
{
public:
    InAnotherLayer(const Scene& scene, const std::vector<const GameObject*>& objects, int layer)
    {
        m_Layers.reserve(objects.size());
        for (const auto& object : scene.objects())
        {
            if (std::ranges::binary_search(objects, object.get()))
            {
                m_Layers.emplace_back(object.get(), object->layer);
                object->layer = layer;
            }
        }
    }
    ~InAnotherLayer()
    {
        for (const auto& [object, layer] : m_Layers)
        {
            object->layer = layer;
        }
    }
    InAnotherLayer(const InAnotherLayer&) = delete;
    InAnotherLayer& operator=(const InAnotherLayer&) = delete;

private:
    std::vector<std::pair<GameObject*, int>> m_Layers;
};

/// Returns what a second camera sees that looks only at one layer, into which the objects are moved
/// meanwhile.
/// @param objects  sorted
/// @throws ContractError if there is no scene to cull
CullingResults CullInLayer(const RenderingData& renderingData,
                           const std::vector<const GameObject*>& objects, int layer)
{
    if (renderingData.scene == nullptr)
    {
        throw ContractError("HighlightLayer: there is no scene that a second camera could cull");
    }
    const auto& target = renderingData.cameraData.cameraTargetDescriptor;
    const float aspect = static_cast<float>(target.width) / static_cast<float>(target.height);
    Camera camera = *renderingData.cameraData.camera;
    camera.cullingMask = LayerMask::FromIndex(layer);
    CullingResults seen;
    {
        const InAnotherLayer moved(*renderingData.scene, objects, layer);
        seen = Cull(*renderingData.scene, camera, aspect);
    }
    // The first camera culls by the layers as they are now.
    Cull(*renderingData.scene, *renderingData.cameraData.camera, aspect);
    return seen;
}

} // namespace
} // namespace selection_outline

SelectionOutline::SelectionOutline()
{
    m_OutlineWidth.SetValue(selection_outline::k_ArticlesWidth);
}

float SelectionOutline::tapOffset() const
{
    return offsetScale.value() > 0.0f ? offsetScale.value()
                                      : m_OutlineWidth.value() / static_cast<float>(blurCount());
}

SelectionOutlineSettings::SelectionOutlineSettings()
    : startTimes(std::make_shared<std::unordered_map<const Transform*, double>>())
{
    m_RenderPassEvent = RenderPassEvent::BeforeRenderingPostProcessing;
}

void SelectionOutlineSettings::Describe(Inspector& inspector)
{
    OutlineSettings::Describe(inspector);
    DescribeGrouping(inspector, m_Grouping);
    inspector.Field("m_PhaseStep", m_PhaseStep,
                    "The seconds between the colours of one object and the next, for objects "
                    "without a start time");

    inspector.Header("Stencil");
    inspector.Field("m_Stencil", m_Stencil, selection_outline::k_Stencils,
                    "The way to draw the selected objects: by the pass itself, or by a second "
                    "camera that sees one layer");
    inspector.Field("m_HighlightingLayer", m_HighlightingLayer, ValueRange{0, 31},
                    "The layer of that camera, into which the objects are moved meanwhile");
    inspector.Field("m_OnlySelected", m_OnlySelected,
                    "On: other objects of that layer are left out; off: they get an edge, too");

    inspector.Header("Shaders");
    inspector.Field("m_StencilShader", m_StencilShader,
                    "A shader for the mask in place of limn's own");
    inspector.Field("m_BlurShader", m_BlurShader, "A shader for the blur in place of limn's own");
    inspector.Field(
        "m_CompositeShader", m_CompositeShader,
        "A shader for the composite in place of limn's own, which needs no copy of the picture");
}

OutlineEffect::OutlineEffect(const std::string& featureName,
                             const SelectionOutlineSettings& settings,
                             std::shared_ptr<const Shader> shader)
    : m_Settings(settings), m_Shader(std::move(shader))
{
    profilingSampler = ProfilingSampler(featureName);
    renderPassEvent = settings.m_RenderPassEvent;
    m_StencilStep = MakeStep(settings.m_StencilShader, selection_outline::k_StencilPass);
    m_BlurStep = MakeStep(settings.m_BlurShader, selection_outline::k_BlurPass);
    m_CompositeStep = MakeStep(settings.m_CompositeShader, selection_outline::k_CompositePass);
    if (settings.m_CompositeShader)
    {
        m_CopyMaterial = CoreUtils::CreateEngineMaterial(
            FindBuiltinShader("Hidden/Universal/CoreBlit", m_Shader->compiler()));
    }
    LayerMask::FromIndex(settings.m_HighlightingLayer); // refuses what is no layer
}

/// The pass of limn's own shader, or the first of the one that was given in its place.
OutlineEffect::Step OutlineEffect::MakeStep(const std::shared_ptr<const Shader>& given,
                                            int pass) const
{
    return given ? Step{CoreUtils::CreateEngineMaterial(given), 0}
                 : Step{CoreUtils::CreateEngineMaterial(m_Shader), pass};
}

std::string OutlineEffect::Setup(const SelectionOutline& volumeComponent,
                                 const RenderingData& renderingData)
{
    FindOutlinedObjects(renderingData, m_Settings, m_Settings.m_Grouping, m_Found);
    if (m_Found.objects.empty())
    {
        return m_Found.why;
    }
    FindGroupsByDepth(m_Found, renderingData.cameraData.viewMatrix, m_Groups);

    m_Width = renderingData.cameraData.cameraTargetDescriptor.width;
    m_Height = renderingData.cameraData.cameraTargetDescriptor.height;
    m_BlurCount = volumeComponent.blurCount();
    m_StencilStep.material->SetColor(OutlineShaderIDs::_OutlineColor,
                                     volumeComponent.m_OutlineColor.value());
    m_StencilStep.material->SetFloat(selection_outline::_VaryingColor,
                                     volumeComponent.m_VaryingColor.value() ? 1.0f : 0.0f);
    const float diagonal =
        std::ceil(std::hypot(static_cast<float>(m_Width), static_cast<float>(m_Height)));
    m_BlurStep.material->SetFloat(selection_outline::_OffsetScale,
                                  std::min(volumeComponent.tapOffset(), diagonal));
    m_CompositeStep.material->SetFloat(selection_outline::_OutlineStrength,
                                       volumeComponent.outlineStrength.value());
    return "";
}

void OutlineEffect::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const RTHandle& camera = renderingData.cameraData.renderer->cameraColorTargetHandle();
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    for (auto group = m_Groups.begin(); group != m_Groups.end(); ++group)
    {
        RenderStencil(context, *group, renderingData);
        RenderBlur(*cmd, *renderingData.temporaryTextures);
        // Nearer groups are not drawn over: they count as inside, too.
        for (auto nearer = group + 1; nearer != m_Groups.end(); ++nearer)
        {
            cmd->SetRenderTarget(m_StencilTex);
            DrawStencils(*cmd, nearer->objects, renderingData.time);
        }
        RenderComposite(*cmd, camera, renderingData);
        context.ExecuteCommandBuffer(*cmd);
        cmd->Clear();
    }
}

void OutlineEffect::RenderStencil(ScriptableRenderContext& context, const OutlinedGroup& group,
                                  RenderingData& renderingData)
{
    m_StencilTex = renderingData.temporaryTextures->GetTemporary(
        m_Width, m_Height, 0, RenderTextureFormat::ARGB32, RenderTextureReadWrite::Linear);
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    cmd->SetRenderTarget(m_StencilTex);
    cmd->ClearRenderTarget(ClearFlag::All, Color::clear);
    if (m_Settings.m_Stencil == SelectionStencil::DrawRenderer)
    {
        DrawStencils(*cmd, group.objects, renderingData.time);
        context.ExecuteCommandBuffer(*cmd);
        return;
    }
    std::vector<const GameObject*> moved;
    for (const OutlinedObject& object : group.objects)
    {
        moved.push_back(object.item.object);
    }
    std::ranges::sort(moved);
    const CullingResults seen =
        selection_outline::CullInLayer(renderingData, moved, m_Settings.m_HighlightingLayer);
    if (!m_Settings.m_OnlySelected)
    {
        context.ExecuteCommandBuffer(*cmd);
        cmd->Clear();
        context.DrawRenderers(seen,
                              CreateDrawingSettings(ForwardShaderTags(), renderingData,
                                                    SortingCriteria::CommonOpaque),
                              FilteringSettings());
    }
    for (const RendererItem& item : seen.items)
    {
        if (std::ranges::binary_search(moved, item.object))
        {
            DrawStencil(*cmd, item, renderingData.time);
        }
    }
    context.ExecuteCommandBuffer(*cmd);
}

void OutlineEffect::DrawStencils(CommandBuffer& cmd, std::span<const OutlinedObject> objects,
                                 double time)
{
    for (const OutlinedObject& object : objects)
    {
        DrawStencil(cmd, object.item, time);
    }
}

/// Draws the item in the colour that it has at that time. A float is too coarse for large times, so
/// both the time and the object's start are passed as less than one turn of the shader's function.
void OutlineEffect::DrawStencil(CommandBuffer& cmd, const RendererItem& item, double time)
{
    const double t = selection_outline::WrapTime(time);
    m_Properties.SetVector(selection_outline::_Time, glm::vec4(t / 20.0, t, t * 2.0, t * 3.0));
    m_Properties.SetFloat(selection_outline::_StartTime,
                          static_cast<float>(Phase(StartTimeOf(item))));
    cmd.DrawRenderer(*item.object, m_StencilStep.material, item.subMesh, m_StencilStep.pass,
                     m_Properties);
}

double OutlineEffect::StartTimeOf(const RendererItem& item) const
{
    const Transform* transform = &item.object->transform;
    for (; transform != nullptr; transform = transform->parent)
    {
        const auto known = m_Settings.startTimes->find(transform);
        if (known != m_Settings.startTimes->end())
        {
            return known->second;
        }
    }
    return static_cast<double>(m_Settings.m_PhaseStep) * item.objectIndex;
}

double OutlineEffect::Phase(double seconds)
{
    return std::fmod(2.0 * seconds, 2.0 * std::numbers::pi);
}

void OutlineEffect::RenderBlur(CommandBuffer& cmd, RenderTexturePool& pool)
{
    const auto getTemporary = [&]
    {
        return pool.GetTemporary(m_Width, m_Height, 0, RenderTextureFormat::ARGB32,
                                 RenderTextureReadWrite::Linear);
    };
    const auto& [material, pass] = m_BlurStep;
    m_BlurTex = getTemporary();
    TemporaryTexture temp = getTemporary();
    cmd.Blit(m_StencilTex, m_BlurTex, material, pass);
    for (int i = 1; i < m_BlurCount; i += 2)
    {
        cmd.Blit(m_BlurTex, temp, material, pass);
        cmd.Blit(temp, m_BlurTex, material, pass);
    }
    RenderTexturePool::ReleaseTemporary(temp);
}

/// Draws in place if the shader blends. A shader that reads the picture gets a copy of it.
void OutlineEffect::RenderComposite(CommandBuffer& cmd, const RTHandle& destination,
                                    RenderingData& renderingData)
{
    const auto& [material, pass] = m_CompositeStep;
    material->SetTexture(selection_outline::_StencilTex, m_StencilTex.rt());
    if (m_CopyMaterial)
    {
        material->SetTexture(selection_outline::_BlurTex, m_BlurTex.rt());
        RenderTextureDescriptor descriptor = destination.rt()->descriptor();
        descriptor.msaaSamples = 1;
        const TemporaryTexture source = renderingData.temporaryTextures->GetTemporary(descriptor);
        Blitter::BlitCameraTexture(cmd, destination, source, m_CopyMaterial,
                                   selection_outline::k_CopyPass);
        cmd.Blit(source, destination, material, pass);
    }
    else
    {
        cmd.Blit(m_BlurTex, destination, material, pass);
    }
    RenderTexturePool::ReleaseTemporary(m_StencilTex);
    RenderTexturePool::ReleaseTemporary(m_BlurTex);
}

void OutlineEffect::OnCameraCleanup(CommandBuffer&)
{
    m_StencilTex.Release(); // where something threw in between
    m_BlurTex.Release();
    m_Groups.clear();
    m_Found.objects.clear();
}

void SelectionOutlineRendererFeature::SetStartTime(const GameObject& object, double seconds)
{
    if (!std::isfinite(seconds))
    {
        throw ContractError(name + ": the start time of '" + object.name + "' is not finite");
    }
    (*settings().startTimes)[&object.transform] = seconds;
}

void SelectionOutlineRendererFeature::ClearStartTimes()
{
    settings().startTimes->clear();
}

void RegisterSelectionOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<SelectionOutlineRendererFeature>(
        "SelectionOutlineRendererFeature",
        {{.name = "Selection",
          .summary = "the article on selection: blurred mask, composite",
          .isArticle = true,
          .place = 70,
          .component = "SelectionOutline",
          .settings = {"SelectionOutline.m_VaryingColor=false"}}});
    components.Register<SelectionOutline>("SelectionOutline");
}

} // namespace limn
