#include "pipeline/CameraTextures.h"

#include "texture/ScaledTexture.h"

#include <algorithm>
#include <limn/core/SystemInfo.h>

namespace limn
{

namespace
{

using enum RenderPassEvent;

const ShaderPropertyId _CameraDepthTexture{"_CameraDepthTexture"};
const ShaderPropertyId _CameraNormalsTexture{"_CameraNormalsTexture"};
const ShaderPropertyId _CameraDepthNormalsTexture{"_CameraDepthNormalsTexture"};
const ShaderPropertyId _CameraOpaqueTexture{"_CameraOpaqueTexture"};
constexpr int k_NearestBlit = 0; // "Nearest" of CoreBlit.shader
constexpr int k_DepthBlit = 3;   // "Depth"
constexpr int k_DepthNormalsBlit = 4;

void Set(ScriptableRenderContext& context, ShaderPropertyId id, const RTHandle& texture)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    cmd->SetGlobalTexture(id, texture);
    context.ExecuteCommandBuffer(*cmd);
}

/// Unity: DepthNormalOnlyPass.GetGraphicsFormat (URP 14).
GraphicsFormat NormalsFormat()
{
    for (const auto format : {GraphicsFormat::R8G8B8A8_SNorm, GraphicsFormat::R16G16B16A16_SFloat})
    {
        if (SystemInfo::IsFormatSupported(format, FormatUsage::Render))
        {
            return format;
        }
    }
    return GraphicsFormat::R32G32B32A32_SFloat;
}

} // namespace

CameraTextures::CameraTextures(const std::shared_ptr<const Material>& blit)
    : m_DepthPrepass("DepthPrepass", BeforeRenderingPrePasses, {ShaderTagId("DepthOnly")},
                     RenderQueueRange::opaque, SortingCriteria::CommonOpaque),
      m_DepthNormalPrepass("DepthNormalPrepass", BeforeRenderingPrePasses,
                           {ShaderTagId("DepthNormals"), ShaderTagId("DepthNormalsOnly")},
                           RenderQueueRange::opaque, SortingCriteria::CommonOpaque),
      m_CopyDepth("CopyDepth", AfterRenderingTransparents, blit, k_DepthBlit),
      m_CopyColor("CopyColor", AfterRenderingSkybox, blit, k_NearestBlit),
      m_EncodeDepthNormals("EncodeDepthNormals", BeforeRenderingPrePasses, blit, k_DepthNormalsBlit)
{
    m_DepthPrepass.ConfigureClear(ClearFlag::All, Color::black);
    m_DepthNormalPrepass.ConfigureClear(ClearFlag::All, Color::black);
}

void CameraTextures::Setup(std::span<ScriptableRenderPass* const> queue, LayerMask opaqueLayers,
                           const RenderTextureDescriptor& camera, std::vector<std::string>& notes)
{
    using Input = ScriptableRenderPassInput;
    m_AsksForNormals = false;
    m_FirstDepthEvent = BeforeRenderingPostProcessing;
    m_IsDepthChosen = false;
    m_LastEvent = BeforeRendering;
    m_Places.clear();
    m_PrepassPlace.reset();
    m_ColorPlace.reset();
    for (const ScriptableRenderPass* pass : queue)
    {
        m_AsksForNormals = m_AsksForNormals || (pass->input() & Input::Normal);
        if (pass->input() & Input::Depth)
        {
            m_FirstDepthEvent = std::min(m_FirstDepthEvent, pass->renderPassEvent);
        }
        if (pass->input() & Input::Motion)
        {
            notes.push_back(pass->profilingSampler.name() +
                            ": it asks for motion vectors, but limn does not make them; "
                            "_MotionVectorTexture is gray");
        }
    }
    Allocate(camera);
    m_DepthPrepass.SetLayerMask(opaqueLayers);
    m_DepthNormalPrepass.SetLayerMask(opaqueLayers);
    m_DepthPrepass.ConfigureTarget(m_PrepassDepth);
    m_DepthNormalPrepass.ConfigureTarget(m_Normals, m_PrepassDepth);
}

void CameraTextures::Allocate(const RenderTextureDescriptor& camera)
{
    const auto allocate =
        [&](RTHandle& handle, const char* name, GraphicsFormat format, int depthBits = 0)
    {
        AllocateTransient(handle, {camera.width, camera.height, format, depthBits}, name,
                          FilterMode::Point);
    };
    allocate(m_PrepassDepth, "_CameraDepthTexture", GraphicsFormat::None, camera.depthBufferBits);
    allocate(m_CopiedDepth, "_CameraDepthTexture", GraphicsFormat::R32_SFloat);
    allocate(m_Normals, "_CameraNormalsTexture", NormalsFormat());
    allocate(m_DepthNormals, "_CameraDepthNormalsTexture", GraphicsFormat::R8G8B8A8_UNorm);
    allocate(m_OpaqueColor, "_CameraOpaqueTexture", camera.graphicsFormat);
}

void CameraTextures::BeforePass(ScriptableRenderContext& context, RenderPassEvent next,
                                const ScriptableRenderer::PassPlace& place, const RTHandle& color)
{
    if (context.Reads(*m_CopiedDepth.rt()))
    {
        m_FirstDepthEvent = std::min(m_FirstDepthEvent, m_LastEvent);
    }
    m_LastEvent = next;
    m_Places.push_back({next, place});
    if (!m_PrepassPlace && next > BeforeRenderingPrePasses)
    {
        m_PrepassPlace = place;
        Set(context, _CameraDepthTexture, m_PrepassDepth);
        Set(context, _CameraNormalsTexture, m_Normals);
        Set(context, _CameraDepthNormalsTexture, m_DepthNormals);
    }
    // Passes up to here read the depth of the prepass; later ones read it, too, if it is chosen
    // here.
    if (!m_IsDepthChosen && next > BeforeRenderingOpaques)
    {
        m_IsDepthChosen = true;
        if (!TakesDepthFromPrepass(context))
        {
            Set(context, _CameraDepthTexture, m_CopiedDepth);
        }
    }
    if (!m_ColorPlace && next > AfterRenderingSkybox)
    {
        m_ColorPlace = place;
        m_ColorThere = color;
        Set(context, _CameraOpaqueTexture, m_OpaqueColor);
    }
}

bool CameraTextures::TakesDepthFromPrepass(const ScriptableRenderContext& context) const
{
    return m_AsksForNormals || m_FirstDepthEvent <= BeforeRenderingOpaques ||
           context.Reads(*m_PrepassDepth.rt()) || context.Reads(*m_Normals.rt()) ||
           context.Reads(*m_DepthNormals.rt());
}

std::span<const CameraTextures::LatePass>
CameraTextures::Needed(const ScriptableRenderContext& context, const RTHandle& depth)
{
    m_Late.clear();
    if (context.Reads(*m_OpaqueColor.rt()))
    {
        m_CopyColor.SetTargets(m_ColorThere, m_OpaqueColor);
        AddLate({m_ColorPlace.value(), &m_CopyColor});
    }
    if (context.Reads(*m_CopiedDepth.rt()))
    {
        AddLate(CopyDepth(depth));
    }
    const bool readsDepth = context.Reads(*m_PrepassDepth.rt());
    const bool readsBoth = context.Reads(*m_DepthNormals.rt());
    if (readsBoth)
    {
        m_EncodeDepthNormals.SetTargets(m_Normals, m_DepthNormals, m_PrepassDepth);
        AddLate({m_PrepassPlace.value(), &m_EncodeDepthNormals});
    }
    if (readsBoth || context.Reads(*m_Normals.rt()) || (readsDepth && m_AsksForNormals))
    {
        AddLate({m_PrepassPlace.value(), &m_DepthNormalPrepass});
    }
    else if (readsDepth)
    {
        AddLate({m_PrepassPlace.value(), &m_DepthPrepass});
    }
    return m_Late;
}

void CameraTextures::AddLate(const LatePass& pass)
{
    const auto isBefore = [](const LatePass& a, const LatePass& b)
    {
        return a.place.pass > b.place.pass;
    };
    m_Late.insert(std::upper_bound(m_Late.begin(), m_Late.end(), pass, isBefore), pass);
}

CameraTextures::LatePass CameraTextures::CopyDepth(const RTHandle& depth)
{
    m_CopyDepth.renderPassEvent = std::min(AfterRenderingTransparents, m_FirstDepthEvent - 1);
    m_CopyDepth.SetTargets(depth, m_CopiedDepth);
    const auto place = std::ranges::find_if(m_Places, [&](const auto& p)
                                            { return p.next > m_CopyDepth.renderPassEvent; });
    return {place->place, &m_CopyDepth};
}

} // namespace limn
