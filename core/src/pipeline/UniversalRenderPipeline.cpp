#include "passes/CameraUniforms.h"
#include "pipeline/AdditionalLights.h"
#include "shadows/AdditionalLightsShadowCasterPass.h"
#include "shadows/MainLightShadowCasterPass.h"
#include "texture/ScaledTexture.h"

#include <algorithm>
#include <cmath>
#include <limn/base/NumberText.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/CurrentCamera.h>
#include <limn/core/UniversalRenderPipeline.h>

namespace limn
{

namespace
{

constexpr double k_MaxTime = 1e38;

void ExpectRenderable(const RenderRequest& request)
{
    if (request.scene == nullptr || request.camera == nullptr)
    {
        throw ContractError("RenderSingleCamera: scene and camera must be given");
    }
    if (request.camera->renderType != CameraRenderType::Base)
    {
        throw ContractError("RenderSingleCamera: the camera's renderType is Overlay; it is drawn "
                            "by a base camera that has it in its cameraStack");
    }
    if (const RenderTexture* target = request.camera->targetTexture.get();
        target != nullptr && IsDepthFormat(target->graphicsFormat()))
    {
        throw ContractError("RenderSingleCamera: the camera's targetTexture '" + target->name() +
                            "' is a depth texture; it must be a colour");
    }
    if (request.width <= 0 || request.height <= 0)
    {
        throw ContractError("RenderSingleCamera: the size is " + std::to_string(request.width) +
                            "x" + std::to_string(request.height) + "; both must be greater than 0");
    }
    if (!(std::abs(request.time) <= k_MaxTime))
    {
        throw ContractError("RenderSingleCamera: the time is " + NumberText(request.time) +
                            " s; shaders get three times that as a float, so at most 1e38");
    }
    for (std::size_t i = 0; i < request.alsoReadBack.size(); ++i)
    {
        if (!request.alsoReadBack[i])
        {
            throw ContractError("RenderSingleCamera: alsoReadBack[" + std::to_string(i) +
                                "] is an empty handle");
        }
    }
}

/// @param range  what it must be: "from 0 to 8"
template <typename Number>
void ExpectSetting(bool isRight, const char* setting, Number value, const char* range)
{
    if (!isRight)
    {
        std::string text;
        if constexpr (std::is_integral_v<Number>)
        {
            text = std::to_string(value);
        }
        else
        {
            text = NumberText(static_cast<double>(value));
        }
        throw ContractError(std::string("UniversalRenderPipeline: ") + setting + " is " + text +
                            "; it must be " + range);
    }
}

void ExpectSettings(const UniversalRenderPipeline& pipeline)
{
    const int samples = pipeline.msaaSampleCount;
    ExpectSetting(samples == 1 || samples == 2 || samples == 4 || samples == 8, "msaaSampleCount",
                  samples, "1, 2, 4 or 8");
    const float scale = pipeline.renderScale;
    ExpectSetting(scale >= 0.1f && scale <= 2.0f, "renderScale", scale, "from 0.1 to 2");
    const int lights = pipeline.maxAdditionalLightsCount;
    ExpectSetting(lights >= 0 && lights <= k_MaxPerObjectLights, "maxAdditionalLightsCount", lights,
                  "from 0 to 8");
    const int version = pipeline.pipelineVersion;
    ExpectSetting(version >= 7 && version <= 17, "pipelineVersion", version, "from 7 to 17");
}

/// Returns the scale of this camera's target. Unity:
/// UniversalRenderPipeline.InitializeStackedCameraData (URP 14).
float RenderScaleOf(const Camera& camera, float renderScale)
{
    constexpr float k_Threshold = 0.05f;
    return camera.cameraType != CameraType::Game || std::abs(1.0f - renderScale) < k_Threshold
               ? 1.0f
               : renderScale;
}

/// Unity: UniversalRenderPipeline.InitializeAdditionalCameraData (URP 14).
float MaxShadowDistance(const Camera& camera, const ShadowSettings& shadows)
{
    const float distance = std::min(shadows.shadowDistance, camera.farClipPlane);
    return shadows.mainLightShadowsSupported && distance >= camera.nearClipPlane ? distance : 0.0f;
}

glm::ivec2 PictureSize(const RenderRequest& request)
{
    const RenderTexture* target = request.camera->targetTexture.get();
    return target != nullptr ? glm::ivec2(target->width(), target->height())
                             : glm::ivec2(request.width, request.height);
}

/// Returns the number of samples that the device supports for both colour and depth.
int SupportedSampleCount(const GraphicsDevice& device, RenderTextureDescriptor camera)
{
    RenderTextureDescriptor color = camera;
    color.depthBufferBits = 0;
    color.msaaSamples = device.GetRenderTextureSupportedMSAASampleCount(camera);
    const int both = device.GetRenderTextureSupportedMSAASampleCount(color);
    camera.msaaSamples = both;
    return both == color.msaaSamples ? both : SupportedSampleCount(device, camera);
}

/// Returns the format of a camera's colour that goes to the output.
/// Unity: UniversalRenderPipeline.MakeRenderTextureGraphicsFormat (URP 14).
GraphicsFormat ColorFormat(bool isHdr, HDRColorBufferPrecision precision,
                           const GraphicsDevice& device, RenderReport& report)
{
    constexpr GraphicsFormat k_Of32Bits = GraphicsFormat::B10G11R11_UFloatPack32;
    if (!isHdr)
    {
        return SystemInfo::GetGraphicsFormat(DefaultFormat::LDR);
    }
    if (precision == HDRColorBufferPrecision::_32Bits)
    {
        if (device.IsFormatSupported(k_Of32Bits, FormatUsage::Render) &&
            device.IsFormatSupported(k_Of32Bits, FormatUsage::Blend))
        {
            return k_Of32Bits;
        }
        report.notes.push_back("the camera's colour has 64 bits a pixel in place of 32 "
                               "(hdrColorBufferPrecision): the device cannot draw and blend " +
                               std::string(ToString(k_Of32Bits)));
    }
    return GraphicsFormat::R16G16B16A16_SFloat;
}

RenderTextureDescriptor CameraTargetDescriptor(const RenderRequest& request, float renderScale,
                                               int msaaSampleCount, GraphicsFormat colorFormat,
                                               const GraphicsDevice& device, RenderReport& report)
{
    const Camera& camera = *request.camera;
    const glm::ivec2 size =
        glm::max(glm::ivec2(glm::vec2(PictureSize(request)) * renderScale), glm::ivec2(1));
    if (camera.targetTexture)
    {
        const RenderTextureDescriptor& target = camera.targetTexture->descriptor();
        RenderTextureDescriptor ofTarget(size.x, size.y, target.graphicsFormat, 32);
        ofTarget.msaaSamples = camera.allowMSAA && msaaSampleCount > 1 ? target.msaaSamples : 1;
        return ofTarget;
    }
    RenderTextureDescriptor descriptor(size.x, size.y, colorFormat, 32);
    if (!camera.allowMSAA || msaaSampleCount == 1)
    {
        return descriptor;
    }
    descriptor.msaaSamples = msaaSampleCount;
    descriptor.msaaSamples = SupportedSampleCount(device, descriptor);
    if (descriptor.msaaSamples != msaaSampleCount)
    {
        report.notes.push_back(
            "the camera is drawn with " +
            CountText(static_cast<std::size_t>(descriptor.msaaSamples), "sample") +
            " per texel in place of " + std::to_string(msaaSampleCount) +
            " (msaaSampleCount): the device supports no more for its format");
    }
    return descriptor;
}

bool UsesReversedZBuffer(const ScriptableRenderer& renderer)
{
    const std::shared_ptr<ShaderCompiler> compiler = renderer.shaderCompiler();
    return !compiler || compiler->usesReversedZBuffer();
}

SortingCriteria OpaqueSortFlags(const Camera& camera)
{
    return camera.opaqueSortMode == OpaqueSortMode::NoDistanceSort
               ? SortingCriteria::SortingLayer | SortingCriteria::RenderQueue |
                     SortingCriteria::OptimizeStateChanges | SortingCriteria::CanvasOrder
               : SortingCriteria::CommonOpaque;
}

RenderingData MakeRenderingData(const RenderRequest& request, const Camera& camera,
                                ScriptableRenderer& renderer,
                                const RenderTextureDescriptor& descriptor, RenderReport& report)
{
    const glm::vec2 size(descriptor.width, descriptor.height);
    const glm::ivec2 picture = PictureSize(request);
    const float aspect = static_cast<float>(picture.x) / static_cast<float>(picture.y);
    RenderingData data;
    data.cameraData.pixelWidth = picture.x;
    data.cameraData.pixelHeight = picture.y;
    data.cameraData.aspectRatio = aspect;
    data.cameraData.renderType = camera.renderType;
    data.cameraData.clearDepth = camera.clearDepth;
    data.cameraData.targetTexture = request.camera->targetTexture;
    data.cameraData.renderOrigin = request.camera->renderOrigin();
    data.cameraData.camera = &camera;
    data.cameraData.cameraTargetDescriptor = descriptor;
    data.cameraData.renderer = &renderer;
    data.cameraData.cameraType = request.camera->cameraType;
    data.cameraData.postProcessEnabled = camera.renderPostProcessing;
    data.cameraData.antialiasing = request.camera->antialiasing;
    data.cameraData.defaultOpaqueSortFlags = OpaqueSortFlags(*request.camera);
    data.cameraData.backgroundColor =
        CoreUtils::ConvertSRGBToActiveColorSpace(camera.backgroundColor);
    data.cameraData.volumeLayerMask = request.camera->volumeLayerMask;
    data.cameraData.worldSpaceCameraPos = camera.transform.position();
    data.cameraData.viewMatrix = camera.viewMatrix();
    data.cameraData.usesReversedZBuffer = UsesReversedZBuffer(renderer);
    data.cameraData.gpuProjectionMatrix =
        WithFlippedY(camera.gpuProjectionMatrix(aspect, data.cameraData.usesReversedZBuffer));
    data.scene = request.scene;
    data.time = request.time;
    data.volumeStack = request.blendVolumes ? request.blendVolumes(camera) : request.volumeStack;
    data.report = &report;
    const CurrentCamera current(data); // for code of features that is asked for its margin
    const glm::vec2 margin = 2.0f * renderer.cullingMargin(data.volumeStack) / size;
    data.cullResults = Measure(
        request.timeline, "cull",
        [&] { return Cull(*request.scene, camera, aspect, margin, data.cameraData.renderOrigin); });
    return data;
}

void NoteBeyondFloat(const CullingResults& results, RenderReport& report)
{
    const std::size_t count = results.beyondFloat.size();
    if (count > 0)
    {
        report.notes.push_back(
            "object '" + results.beyondFloat.front()->name + "'" +
            (count > 1 ? " and " + std::to_string(count - 1) + " more: nothing of them"
                       : ": nothing of it") +
            " is drawn: a position or size in the world exceeds the range of a float, 3.4e38");
    }
}

/// Every frame writes the whole of it, so nothing of the last one has to be kept.
void AllocateOutput(RTHandle& output, const RenderRequest& request)
{
    if (const auto& target = request.camera->targetTexture)
    {
        output = output && output.rt() == target ? output : RTHandle(target);
        return;
    }
    AllocateTransient(
        output, {request.width, request.height, SystemInfo::GetGraphicsFormat(DefaultFormat::LDR)},
        "limn_Output", FilterMode::Point);
}

/// Sets the uniforms that do not change within a camera, and those that an overlay must not take
/// over from the camera before it.
void SetUniforms(ScriptableRenderContext& context, const RenderRequest& request,
                 const RenderingData& renderingData)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    if (renderingData.cameraData.renderType == CameraRenderType::Overlay)
    {
        ForgetAdditionalLights(*cmd);
        MainLightShadowCasterPass::Forget(*cmd);
        AdditionalLightsShadowCasterPass::Forget(*cmd);
    }
    SetTimeUniforms(*cmd, renderingData.time, renderingData.deltaTime);
    SetLightUniforms(*cmd, *request.scene);
    SetAmbientUniforms(*cmd, *request.scene);
    SetFogUniforms(*cmd, *request.scene);
    SetAdditionalLightUniforms(context, *cmd, renderingData);
    context.ExecuteCommandBuffer(*cmd);
}

} // namespace

UniversalRenderPipeline::UniversalRenderPipeline(GraphicsDevice& device)
    : m_Device(&device), m_Context(std::make_unique<ScriptableRenderContext>())
{
}

RenderResult UniversalRenderPipeline::RenderSingleCamera(UniversalRenderer& renderer,
                                                         const RenderRequest& request)
{
    RenderResult result;
    RenderSingleCamera(renderer, request, result);
    return result;
}

void UniversalRenderPipeline::RenderSingleCamera(UniversalRenderer& renderer,
                                                 const RenderRequest& request, RenderResult& result)
{
    AdvanceTime(request.time);
    RenderStack(renderer, request, m_Frames, result);
}

std::vector<RenderResult> UniversalRenderPipeline::Render(UniversalRenderer& renderer,
                                                          const RenderRequest& request,
                                                          std::span<const Camera* const> cameras)
{
    std::vector<const Camera*> sorted(cameras.begin(), cameras.end());
    if (const auto null = std::ranges::find(sorted, nullptr); null != sorted.end())
    {
        throw ContractError("Render: cameras[" + std::to_string(null - sorted.begin()) +
                            "] is null");
    }
    std::erase_if(sorted, [](const Camera* camera)
                  { return camera->renderType != CameraRenderType::Base; });
    std::ranges::stable_sort(sorted, std::less(),
                             [](const Camera* camera) { return std::trunc(camera->depth); });
    AdvanceTime(request.time);
    m_FramesOfSeveral.resize(std::max(m_FramesOfSeveral.size(), sorted.size()));
    std::vector<RenderResult> results(sorted.size());
    RenderRequest ofOne = request;
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
        ofOne.camera = sorted[i];
        RenderStack(renderer, ofOne, m_FramesOfSeveral[i], results[i]);
    }
    return results;
}

void UniversalRenderPipeline::AdvanceTime(double time)
{
    if (!std::isfinite(time))
    {
        return; // ExpectRenderable refuses it
    }
    constexpr double k_LongestFrame = 1.0 / 3.0; // Unity: Time.maximumDeltaTime
    m_DeltaTime = std::clamp(time - m_Time.value_or(time), 0.0, k_LongestFrame);
    m_Time = time;
}

void UniversalRenderPipeline::FindStack(const Camera& camera, RenderReport& report)
{
    m_Stack.assign(1, &camera);
    for (const std::shared_ptr<const Camera>& overlay : camera.cameraStack)
    {
        if (!overlay)
        {
            throw ContractError("RenderSingleCamera: a camera of the cameraStack is null");
        }
        if (overlay->renderType == CameraRenderType::Overlay)
        {
            m_Stack.push_back(overlay.get());
        }
        else
        {
            report.notes.push_back("camera " + std::to_string(m_Stack.size()) +
                                   " of the cameraStack is not drawn: its renderType is Base");
        }
    }
}

void UniversalRenderPipeline::RenderStack(UniversalRenderer& renderer, const RenderRequest& request,
                                          FrameCache& frames, RenderResult& result)
{
    ExpectRenderable(request);
    ExpectSettings(*this);
    result.report.passes.clear();
    result.report.draws.clear();
    result.report.filters.clear();
    result.report.features.clear();
    result.report.notes.clear();
    result.report.choices.clear();
    result.frame = nullptr; // else the next would have to leave it as it is
    FindStack(*request.camera, result.report);
    RTHandle& output = request.camera->targetTexture ? m_TargetTexture : m_Output;
    AllocateOutput(output, request);
    renderer.SetOutput(output);
    result.output = output;

    const float scale = RenderScaleOf(*request.camera, renderScale);
    const bool isHdr = request.camera->allowHDR && supportsHDR;
    const GraphicsFormat colorFormat = ColorFormat(
        isHdr && !request.camera->targetTexture, hdrColorBufferPrecision, *m_Device, result.report);
    const RenderTextureDescriptor descriptor = CameraTargetDescriptor(
        request, scale, msaaSampleCount, colorFormat, *m_Device, result.report);
    RTHandles::SetReferenceSize(descriptor.width, descriptor.height);
    m_TemporaryTextures.BeginFrame();
    m_Context->Begin(result.report, request.camera->renderOrigin(), std::move(m_Commands),
                     UsesReversedZBuffer(renderer));
    for (const Camera* const& camera : m_Stack)
    {
        RenderingData renderingData =
            MakeRenderingData(request, *camera, renderer, descriptor, result.report);
        renderingData.deltaTime = m_DeltaTime;
        renderingData.cameraData.resolveFinalTarget = &camera == &m_Stack.back();
        renderingData.cameraData.isHdrEnabled = isHdr;
        renderingData.cameraData.renderScale = scale;
        renderingData.cameraData.pipelineVersion = pipelineVersion;
        renderingData.cameraData.maxShadowDistance = MaxShadowDistance(*camera, shadows);
        renderingData.postProcessingEnabled = std::ranges::any_of(
            m_Stack, [](const Camera* each) { return each->renderPostProcessing; });
        renderingData.shadowSettings = shadows;
        renderingData.enableRenderCompatibilityMode = enableRenderCompatibilityMode;
        FindLights(renderingData);
        renderingData.temporaryTextures = &m_TemporaryTextures;
        NoteBeyondFloat(renderingData.cullResults, result.report);
        Measure(request.timeline, "record",
                [&]
                {
                    SetUniforms(*m_Context, request, renderingData);
                    renderer.RenderCamera(*m_Context, renderingData);
                });
    }
    Finish(request, frames, output, result);
}

void UniversalRenderPipeline::FindLights(RenderingData& renderingData)
{
    const Scene& scene = *renderingData.scene;
    FindAdditionalLights(scene, renderingData.cameraData, m_AdditionalLights,
                         renderingData.report->notes);
    LightData& lights = renderingData.lightData;
    lights.scene = &scene;
    lights.additionalLights = m_AdditionalLights;
    lights.additionalLightsCount = static_cast<int>(m_AdditionalLights.size());
    lights.maxPerObjectAdditionalLightsCount = maxAdditionalLightsCount;
    lights.mainLightIndex = scene.mainLight.intensity != 0.0f ? 0 : -1;
    lights.supportsAdditionalLights = maxAdditionalLightsCount > 0;
    renderingData.shadowData = ShadowData(shadows, lights);
}

/// Compiles what is recorded and starts it.
void UniversalRenderPipeline::Finish(const RenderRequest& request, FrameCache& frames,
                                     const RTHandle& output, RenderResult& result)
{
    m_Outputs.assign(1, output.rt());
    for (const RTHandle& handle : request.alsoReadBack)
    {
        m_Outputs.push_back(handle.rt());
    }
    FrameCompilerOptions options = request.compile;
    if (options.leavesOut && !options.footprint)
    {
        options.footprint = [this](const RenderTexture& texture)
        {
            return m_Device->Footprint(texture);
        };
    }
    options.held = m_TemporaryTextures.held();
    m_Commands = m_Context->TakeCommands();
    result.frame = Measure(
        request.timeline, "compile",
        [&] { return frames.Compile(m_Commands, m_Device->textureStates(), m_Outputs, options); });
    Measure(request.timeline, "execute", [&] { m_Device->Execute(*result.frame); });
    std::vector<std::string>& notes = result.report.notes;
    notes.insert(notes.end(), result.frame->notes.begin(), result.frame->notes.end());
}

} // namespace limn
