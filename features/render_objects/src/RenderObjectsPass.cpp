#include <limn/base/NumberText.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/DrawError.h>
#include <limn/features/RenderObjectsPass.h>
#include <set>

namespace limn
{

namespace
{

std::vector<ShaderTagId> ToTags(const std::vector<std::string>& names)
{
    return names.empty() ? ForwardShaderTags()
                         : std::vector<ShaderTagId>(names.begin(), names.end());
}

} // namespace

RenderObjectsPass::RenderObjectsPass(
    const std::string& profilerTag, RenderPassEvent event,
    const std::vector<std::string>& shaderTags, RenderQueueType renderQueueType,
    LayerMask layerMask, const RenderObjectsSettings::CustomCameraSettings& cameraSettings)
    : m_RenderQueueType(renderQueueType),
      m_FilteringSettings(renderQueueType == RenderQueueType::Transparent
                              ? RenderQueueRange::transparent
                              : RenderQueueRange::opaque,
                          layerMask),
      m_CameraSettings(cameraSettings),
      m_ShaderTagIdList(ToTags(shaderTags)),
      m_TagsAreChosen(!shaderTags.empty())
{
    profilingSampler = ProfilingSampler(profilerTag);
    renderPassEvent = event;
}

void RenderObjectsPass::SetDepthState(bool writeEnabled, CompareFunction function)
{
    m_RenderStateBlock.mask |= RenderStateMask::Depth;
    m_RenderStateBlock.depthState = {writeEnabled, function};
}

void RenderObjectsPass::SetStencilState(int reference, CompareFunction compareFunction,
                                        StencilOp passOp, StencilOp failOp, StencilOp zFailOp)
{
    StencilState stencilState;
    stencilState.SetCompareFunction(compareFunction);
    stencilState.SetPassOperation(passOp);
    stencilState.SetFailOperation(failOp);
    stencilState.SetZFailOperation(zFailOp);
    m_RenderStateBlock.mask |= RenderStateMask::Stencil;
    m_RenderStateBlock.stencilReference = reference;
    m_RenderStateBlock.stencilState = stencilState;
}

void RenderObjectsPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    const SortingCriteria sortingCriteria = m_RenderQueueType == RenderQueueType::Transparent
                                                ? SortingCriteria::CommonTransparent
                                                : renderingData.cameraData.defaultOpaqueSortFlags;
    DrawingSettings drawingSettings =
        CreateDrawingSettings(m_ShaderTagIdList, renderingData, sortingCriteria);
    drawingSettings.overrideMaterial = overrideMaterial;
    drawingSettings.overrideMaterialPassIndex = overrideMaterialPassIndex;
    drawingSettings.overrideShader = overrideShader;
    drawingSettings.overrideShaderPassIndex = overrideShaderPassIndex;
    NoteUnknownTags(renderingData);

    const CameraData& cameraData = renderingData.cameraData;
    CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    if (m_CameraSettings.overrideCamera)
    {
        SetCamera(*cmd, cameraData);
        context.ExecuteCommandBuffer(*cmd);
        cmd->Clear();
    }
    context.DrawRenderers(renderingData.cullResults, drawingSettings, m_FilteringSettings,
                          m_RenderStateBlock);
    if (m_CameraSettings.overrideCamera && m_CameraSettings.restoreCamera)
    {
        RenderingUtils::SetViewAndProjectionMatrices(*cmd, cameraData.viewMatrix,
                                                     cameraData.gpuProjectionMatrix, false);
        context.ExecuteCommandBuffer(*cmd);
    }
}

void RenderObjectsPass::SetCamera(CommandBuffer& cmd, const CameraData& cameraData) const
{
    Camera camera = *cameraData.camera;
    camera.orthographic = false;
    camera.projectionMatrix.reset();
    camera.fieldOfView = m_CameraSettings.cameraFieldOfView;
    const RenderTextureDescriptor& target = cameraData.cameraTargetDescriptor;
    const float aspect = static_cast<float>(target.width) / static_cast<float>(target.height);
    glm::dmat4 view = cameraData.viewMatrix;
    view[3] += glm::dvec4(m_CameraSettings.offset);
    if (camera.nearClipPlane <= 0.0f)
    {
        throw DrawError(profilingSampler.name() +
                        ": cameraSettings.overrideCamera: its own camera has perspective, but the "
                        "scene's has the nearClipPlane " +
                        NumberText(static_cast<double>(camera.nearClipPlane)) +
                        "; more than 0 is needed");
    }
    RenderingUtils::SetViewAndProjectionMatrices(
        cmd, view, WithFlippedY(camera.gpuProjectionMatrix(aspect, cameraData.usesReversedZBuffer)),
        false);
}

/// A chosen name that no shader in view has is most often a typing mistake.
void RenderObjectsPass::NoteUnknownTags(const RenderingData& renderingData) const
{
    std::set<std::string_view> known;
    for (const RendererItem& item : renderingData.cullResults.items)
    {
        for (int pass = 0; pass < item.filter.shader->passCount(); ++pass)
        {
            known.insert(item.filter.shader->passLightMode(pass));
        }
    }
    if (!m_TagsAreChosen || known.empty())
    {
        return;
    }
    for (const ShaderTagId tag : m_ShaderTagIdList)
    {
        if (known.count(tag.name()) == 0)
        {
            renderingData.report->notes.push_back(
                profilingSampler.name() +
                ": filterSettings.PassNames: no shader in view has a pass with LightMode " +
                UnknownName(tag.name(), {known.begin(), known.end()}));
        }
    }
}

} // namespace limn
