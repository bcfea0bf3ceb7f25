#include "graph/RenderGraphCamera.h"

#include "graph/RenderGraphRun.h"
#include "passes/MakeDrawingSettings.h"
#include "passes/RunPassCode.h"
#include <limn/base/NumberText.h>

namespace limn
{

namespace
{

constexpr int k_IdleFrames = 15; ///< that a texture outlives nobody asking for it

std::string SizeOf(const RTHandle& texture)
{
    const auto samples = static_cast<std::size_t>(texture.rt()->descriptor().msaaSamples);
    return texture.rt()->DescribeSize() + " with " + CountText(samples, "sample") + " per texel";
}

} // namespace

void UniversalResourceData::Reset()
{
    cameraColor = {};
    cameraDepth = {};
    cameraDepthTexture = {};
    cameraNormalsTexture = {};
    cameraOpaqueTexture = {};
    mainShadowsTexture = {};
    additionalShadowsTexture = {};
}

DrawingSettings RenderingUtils::CreateDrawingSettings(std::span<const ShaderTagId> shaderTagIdList,
                                                      const UniversalRenderingData&,
                                                      const UniversalCameraData& cameraData,
                                                      const UniversalLightData&,
                                                      SortingCriteria sortingCriteria)
{
    return MakeDrawingSettings(shaderTagIdList, *cameraData.camera, sortingCriteria);
}

DrawingSettings RenderingUtils::CreateDrawingSettings(ShaderTagId shaderTagId,
                                                      const UniversalRenderingData&,
                                                      const UniversalCameraData& cameraData,
                                                      const UniversalLightData&,
                                                      SortingCriteria sortingCriteria)
{
    return MakeDrawingSettings(std::span(&shaderTagId, 1), *cameraData.camera, sortingCriteria);
}

DrawingSettings RenderingUtils::CreateDrawingSettings(std::span<const ShaderTagId> shaderTagIdList,
                                                      const RenderingData& renderingData,
                                                      SortingCriteria sortingCriteria)
{
    return MakeDrawingSettings(shaderTagIdList, *renderingData.cameraData.camera, sortingCriteria);
}

DrawingSettings RenderingUtils::CreateDrawingSettings(ShaderTagId shaderTagId,
                                                      const RenderingData& renderingData,
                                                      SortingCriteria sortingCriteria)
{
    return CreateDrawingSettings(std::span(&shaderTagId, 1), renderingData, sortingCriteria);
}

RTHandle RenderGraphCamera::Record(ScriptableRenderPass& pass, ScriptableRenderContext& context,
                                   const RenderingData& renderingData, const Targets& targets)
{
    m_HasRecorded = true;
    RenderGraphState& state = *m_Graph.m_State;
    state.copy = targets.copy;
    FillFrameData(context, renderingData, targets);
    const ScriptableRenderer& renderer = *renderingData.cameraData.renderer;
    RunPassCode(renderer, pass, "RecordRenderGraph",
                [&] { pass.RecordRenderGraph(m_Graph, m_FrameData); });
    if (!pass.m_RecordsGraph)
    {
        return targets.color;
    }
    RenderGraphRun run(m_Graph, state, context, *renderingData.report);
    for (; state.ran < state.passes.size(); ++state.ran)
    {
        RenderGraphPass& graphPass = state.passes[state.ran];
        RunPassCode(renderer, pass, graphPass.name.name(), "the render function",
                    [&] { run.Run(graphPass); });
    }
    context.SetPassName(pass.profilingSampler.sampleName());
    const TextureHandle& color = m_FrameData.Get<UniversalResourceData>().cameraColor;
    const RenderGraphCall subject{"pass '", pass.profilingSampler.name(), "': cameraColor"};
    m_Graph.ExpectOfFrame(color, subject);
    const RTHandle& result = color;
    if (!result.rt()->HasSizeOf(*targets.color.rt()))
    {
        throw ContractError(subject.text() + " is set to '" + result.rt()->name() + "', " +
                            SizeOf(result) + "; the camera's colour is " + SizeOf(targets.color));
    }
    return result;
}

void RenderGraphCamera::FillFrameData(const ScriptableRenderContext& context,
                                      const RenderingData& renderingData, const Targets& targets)
{
    auto& resources = m_FrameData.GetOrCreate<UniversalResourceData>();
    for (RenderGraphTexture& texture : m_Graph.m_State->textures)
    {
        texture.handle = {}; // the camera's colour may be another one now
    }
    resources.cameraColor = Import(targets.color, "resourceData.activeColorTexture()");
    resources.cameraDepth = Import(targets.depth, "resourceData.activeDepthTexture()");
    const CameraData& camera = renderingData.cameraData;
    const bool isBase = camera.renderType == CameraRenderType::Base;
    SayCleared(targets.color, isBase, camera.backgroundColor);
    SayCleared(targets.depth, isBase || camera.clearDepth, Color());
    const auto global = [&](ShaderPropertyId id, std::string_view handle)
    {
        return Import(RenderGraphRun::GlobalTexture(context, id), handle);
    };
    resources.cameraDepthTexture = global("_CameraDepthTexture", "resourceData.cameraDepthTexture");
    resources.cameraNormalsTexture =
        global("_CameraNormalsTexture", "resourceData.cameraNormalsTexture");
    resources.cameraOpaqueTexture =
        global("_CameraOpaqueTexture", "resourceData.cameraOpaqueTexture");
    resources.mainShadowsTexture =
        global("_MainLightShadowmapTexture", "resourceData.mainShadowsTexture");
    resources.additionalShadowsTexture =
        global("_AdditionalLightsShadowmapTexture", "resourceData.additionalShadowsTexture");
    static_cast<CameraData&>(m_FrameData.GetOrCreate<UniversalCameraData>()) =
        renderingData.cameraData;
    m_FrameData.GetOrCreate<UniversalRenderingData>().Set(renderingData);
    static_cast<LightData&>(m_FrameData.GetOrCreate<UniversalLightData>()) =
        renderingData.lightData;
    static_cast<ShadowData&>(m_FrameData.GetOrCreate<UniversalShadowData>()) =
        renderingData.shadowData;
}

TextureHandle RenderGraphCamera::Import(const RTHandle& texture, std::string_view handle)
{
    if (!texture)
    {
        return {};
    }
    TextureHandle imported = m_Graph.ImportTexture(texture);
    m_Graph.m_State->Find(*texture.rt())->handle = handle;
    return imported;
}

void RenderGraphCamera::SayCleared(const RTHandle& texture, bool isCleared, const Color& color)
{
    RenderGraphTexture* known = texture ? m_Graph.m_State->Find(*texture.rt()) : nullptr;
    if (known != nullptr && !known->isMade && !known->isWritten)
    {
        known->clears = isCleared;
        known->clearColor = color;
        known->isWritten = true;
    }
}

void RenderGraphCamera::End()
{
    if (!std::exchange(m_HasRecorded, false))
    {
        return;
    }
    m_FrameData.Dispose();
    RenderGraphState& state = *m_Graph.m_State;
    ++state.frame;
    state.ran = 0;
    state.textures.clear();
    state.rendererLists.clear();
    state.passes.clear();
    state.copy = nullptr;
    state.buffers.clear();
    const auto isIdle = [](auto& kept)
    {
        kept.idleFrames = kept.isTaken ? 0 : kept.idleFrames + 1;
        kept.isTaken = false;
        return kept.idleFrames > k_IdleFrames;
    };
    std::erase_if(state.keptBuffers, isIdle);
    std::erase_if(state.kept, isIdle);
}

void ScriptableRenderer::RecordRenderGraph(ScriptableRenderPass& pass,
                                           ScriptableRenderContext& context,
                                           RenderingData& renderingData)
{
    if (!m_RenderGraph)
    {
        m_RenderGraph = std::make_shared<RenderGraphCamera>();
    }
    const RTHandle color = m_RenderGraph->Record(pass, context, renderingData,
                                                 {m_CameraColor, m_CameraDepth, copyMaterial()});
    if (color != m_CameraColor)
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        SetCameraColor(*cmd, color);
        context.ExecuteCommandBuffer(*cmd);
    }
}

} // namespace limn
