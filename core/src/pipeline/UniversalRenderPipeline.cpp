#include "pipeline/AdditionalLights.h"
#include "pipeline/CameraUniforms.h"

#include <cmath>
#include <limn/core/UniversalRenderPipeline.h>

namespace limn
{

namespace
{

constexpr const char* k_OutputName = "limn_Output";
constexpr double k_MaxTime = 1e38;

void ExpectRenderable(const RenderRequest& request)
{
    if (request.scene == nullptr || request.camera == nullptr)
    {
        throw ContractError("RenderSingleCamera: scene and camera must be given");
    }
    if (request.width <= 0 || request.height <= 0)
    {
        throw ContractError("RenderSingleCamera: the size is " + std::to_string(request.width) +
                            "x" + std::to_string(request.height) + "; both must be greater than 0");
    }
    if (!(std::abs(request.time) <= k_MaxTime))
    {
        throw ContractError("RenderSingleCamera: the time is " + std::to_string(request.time) +
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

void ExpectSampleCount(int count)
{
    if (count != 1 && count != 2 && count != 4 && count != 8)
    {
        throw ContractError("UniversalRenderPipeline: msaaSampleCount is " + std::to_string(count) +
                            "; it must be 1, 2, 4 or 8");
    }
}

/// How many samples the device does of both colour and depth.
int SupportedSampleCount(const GraphicsDevice& device, RenderTextureDescriptor camera)
{
    RenderTextureDescriptor color = camera;
    color.depthBufferBits = 0;
    color.msaaSamples = device.GetRenderTextureSupportedMSAASampleCount(camera);
    const int both = device.GetRenderTextureSupportedMSAASampleCount(color);
    camera.msaaSamples = both;
    return both == color.msaaSamples ? both : SupportedSampleCount(device, camera);
}

RenderTextureDescriptor CameraTargetDescriptor(const RenderRequest& request, int msaaSampleCount,
                                               const GraphicsDevice& device, RenderReport& report)
{
    const Camera& camera = *request.camera;
    RenderTextureDescriptor descriptor(
        request.width, request.height,
        camera.allowHDR ? GraphicsFormat::R16G16B16A16_SFloat : GraphicsFormat::R8G8B8A8_SRGB, 32);
    if (!camera.allowMSAA || msaaSampleCount == 1)
    {
        return descriptor;
    }
    descriptor.msaaSamples = msaaSampleCount;
    descriptor.msaaSamples = SupportedSampleCount(device, descriptor);
    if (descriptor.msaaSamples != msaaSampleCount)
    {
        report.notes.push_back("the camera is drawn with " +
                               std::to_string(descriptor.msaaSamples) +
                               " samples a texel in place of " + std::to_string(msaaSampleCount) +
                               " (msaaSampleCount): the device does no more of its format");
    }
    return descriptor;
}

RenderingData MakeRenderingData(const RenderRequest& request, ScriptableRenderer& renderer,
                                const RenderTextureDescriptor& descriptor, RenderReport& report)
{
    const Camera& camera = *request.camera;
    const float aspect = static_cast<float>(request.width) / static_cast<float>(request.height);
    RenderingData data;
    data.cameraData.camera = &camera;
    data.cameraData.cameraTargetDescriptor = descriptor;
    data.cameraData.renderer = &renderer;
    data.cameraData.cameraType = camera.cameraType;
    data.cameraData.postProcessEnabled = camera.renderPostProcessing;
    data.cameraData.isHdrEnabled = camera.allowHDR;
    data.cameraData.viewMatrix = camera.viewMatrix();
    const std::shared_ptr<ShaderCompiler> compiler = renderer.shaderCompiler();
    data.cameraData.usesReversedZBuffer = !compiler || compiler->usesReversedZBuffer();
    data.cameraData.gpuProjectionMatrix =
        camera.gpuProjectionMatrix(aspect, data.cameraData.usesReversedZBuffer);
    data.scene = request.scene;
    data.time = request.time;
    data.volumeStack = request.volumeStack;
    const glm::vec2 margin =
        2.0f * renderer.cullingMargin(data.volumeStack) / glm::vec2(request.width, request.height);
    data.cullResults = Measure(request.timeline, "cull",
                               [&] { return Cull(*request.scene, camera, aspect, margin); });
    data.report = &report;
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
            " is drawn: position or size in the world is beyond a float, 3.4e38");
    }
}

/// Every frame writes the whole of it, so nothing of the last one has to be kept.
void AllocateOutput(RTHandle& output, const RenderRequest& request)
{
    const RenderTextureDescriptor descriptor(request.width, request.height,
                                             GraphicsFormat::R8G8B8A8_SRGB);
    if (!output || output.rt()->descriptor() != descriptor)
    {
        const SamplerState sampler{FilterMode::Point, TextureWrapMode::Clamp,
                                   TextureWrapMode::Clamp, TextureWrapMode::Clamp, false};
        output = RTHandle(
            std::make_shared<const RenderTexture>(k_OutputName, descriptor, sampler, true));
    }
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
    ExpectRenderable(request);
    ExpectSampleCount(msaaSampleCount);
    result.report.passes.clear();
    result.report.draws.clear();
    result.report.notes.clear();
    result.report.choices.clear();
    result.frame = nullptr; // else the next would have to leave it as it is
    AllocateOutput(m_Output, request);
    renderer.SetOutput(m_Output);
    result.output = m_Output;

    RenderingData renderingData = MakeRenderingData(
        request, renderer,
        CameraTargetDescriptor(request, msaaSampleCount, *m_Device, result.report), result.report);
    RTHandles::SetReferenceSize(request.width, request.height);
    renderingData.shadowSettings = shadows;
    m_TemporaryTextures.BeginFrame();
    renderingData.temporaryTextures = &m_TemporaryTextures;
    NoteBeyondFloat(renderingData.cullResults, result.report);
    ScriptableRenderContext& context = *m_Context;
    context.Begin(result.report, request.camera->renderOrigin(), std::move(m_Commands),
                  renderingData.cameraData.usesReversedZBuffer);
    Measure(request.timeline, "record",
            [&]
            {
                const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
                SetTimeUniforms(*cmd, request.time);
                SetLightUniforms(*cmd, *request.scene);
                SetAdditionalLightUniforms(*cmd, renderingData, result.report.notes);
                context.ExecuteCommandBuffer(*cmd);
                renderer.RenderCamera(context, renderingData);
            });

    m_Outputs.assign(1, m_Output.rt());
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
    m_Commands = context.TakeCommands();
    result.frame = Measure(
        request.timeline, "compile",
        [&]
        { return m_Frames.Compile(m_Commands, m_Device->textureStates(), m_Outputs, options); });
    Measure(request.timeline, "execute", [&] { m_Device->Execute(*result.frame); });
    std::vector<std::string>& notes = result.report.notes;
    notes.insert(notes.end(), result.frame->notes.begin(), result.frame->notes.end());
}

} // namespace limn
