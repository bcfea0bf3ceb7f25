#include "HighlightLayer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/OutlineEffect.h>
#include <limn/features/SelectionOutline.h>
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
constexpr int k_CopyPass = 0; // of CoreBlit.shader

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

} // namespace
} // namespace selection_outline

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
    FindGroups(renderingData);

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

void OutlineEffect::FindGroups(const RenderingData& renderingData)
{
    m_Groups.clear();
    for (auto first = m_Found.objects.begin(); first != m_Found.objects.end();)
    {
        const auto end = std::find_if(first, m_Found.objects.end(),
                                      [&](const OutlinedObject& object)
                                      { return object.group != first->group; });
        double depth = std::numeric_limits<double>::infinity();
        for (const OutlinedObject& object : std::span(first, end))
        {
            const glm::dvec4 place(object.item.boundsCenter, 1.0);
            depth = std::min(depth, -(renderingData.cameraData.viewMatrix * place).z);
        }
        m_Groups.push_back({std::span(first, end), depth});
        first = end;
    }
    std::ranges::sort(
        m_Groups, [](const Group& a, const Group& b)
        { return a.depth != b.depth ? a.depth > b.depth : a.objects.data() < b.objects.data(); });
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

void OutlineEffect::RenderStencil(ScriptableRenderContext& context, const Group& group,
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
    const HighlightLayer layer(renderingData, group.objects, m_Settings.m_HighlightingLayer);
    if (!m_Settings.m_OnlySelected)
    {
        context.ExecuteCommandBuffer(*cmd);
        cmd->Clear();
        context.DrawRenderers(layer.seen(),
                              CreateDrawingSettings(ForwardShaderTags(), renderingData,
                                                    SortingCriteria::CommonOpaque),
                              FilteringSettings());
    }
    for (const RendererItem& item : layer.seen().items)
    {
        if (layer.wasMoved(*item.object))
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

} // namespace limn
