#pragma once

#include <functional>
#include <limn/core/FrameCompiler.h>
#include <limn/core/GraphicsDevice.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/Timeline.h>
#include <limn/core/UniversalRenderer.h>

namespace limn
{

/// How many bits of a camera's colour a pixel has where it is HDR.
/// Unity: UnityEngine.Rendering.Universal.HDRColorBufferPrecision (URP 14).
enum class HDRColorBufferPrecision
{
    _32Bits = 0, ///< B10G11R11_UFloatPack32, which has no alpha
    _64Bits = 1  ///< R16G16B16A16_SFloat
};

/// What to render once.
struct RenderRequest
{
    const Scene* scene = nullptr;   ///< never null
    const Camera* camera = nullptr; ///< never null; a base camera, its stack follows
    int width = 0;     ///< pixels, > 0; a camera with a targetTexture has that one's size
    int height = 0;    ///< pixels, > 0
    double time = 0.0; ///< seconds, what _Time shows; at most 1e38, since _Time.w is 3 times that
    const VolumeStack* volumeStack = nullptr; ///< blended for this camera; null: all defaults
    /// In place of volumeStack, called for each camera of a stack before its features are asked:
    /// what it gives holds until the next call.
    std::function<const VolumeStack*(const Camera&)> blendVolumes;
    std::vector<RTHandle> alsoReadBack; ///< further textures to keep readable after the frame
    FrameCompilerOptions compile;       ///< what may be left out
    Timeline* timeline = nullptr; ///< gets "cull", "record", "compile", "execute"; may be null
};

/// What rendering gave.
struct RenderResult
{
    /// R8G8B8A8_SRGB, or the camera's targetTexture; read it back with GraphicsDevice::ReadBack.
    RTHandle output;
    RenderReport report;
    std::shared_ptr<const CompiledFrame> frame; ///< as the device ran it; never null
};

/// Renders cameras on a device. Keep one for as long as its device: its textures stay between
/// frames. Unity: UnityEngine.Rendering.Universal.UniversalRenderPipeline (URP 14).
class UniversalRenderPipeline
{
public:
    /// @param device  must outlive this, or SetDevice
    explicit UniversalRenderPipeline(GraphicsDevice& device);

    /// Goes on with another device, as after the first was lost: what textures held is gone.
    /// @param device  must outlive this
    void SetDevice(GraphicsDevice& device)
    {
        m_Device = &device;
        m_Frames.Clear();
        m_FramesOfSeveral.clear();
    }

    GraphicsDevice& device() const { return *m_Device; }

    /// Samples a texel of the camera's colour and depth, where the camera allows them: 1, 2, 4
    /// or 8. Where the device lacks them there are fewer, with a note. Unity:
    /// UniversalRenderPipelineAsset.msaaSampleCount.
    int msaaSampleCount = 1;

    /// Cameras with allowHDR draw into an HDR colour if it is true. Unity:
    /// UniversalRenderPipelineAsset.supportsHDR.
    bool supportsHDR = true;

    /// The size of a pixel of an HDR colour. Where the device cannot draw and blend 32 bits it is
    /// 64 bits, with a note. Unity: UniversalRenderPipelineAsset.hdrColorBufferPrecision, where 32
    /// bits are the default.
    HDRColorBufferPrecision hdrColorBufferPrecision = HDRColorBufferPrecision::_64Bits;

    /// The size of what cameras draw into, as a share of their picture's, 0.1 ... 2: their picture
    /// is made of that by bilinear sampling. Within 0.05 of 1, and for cameras of type SceneView,
    /// Preview and Reflection, it is 1. Unity: UniversalRenderPipelineAsset.renderScale.
    float renderScale = 1.0f;

    /// By how many lights besides the main one an object is lit at most, 0 ... 8: the brightest
    /// where it is. Unity: UniversalRenderPipelineAsset.maxAdditionalLightsCount.
    int maxAdditionalLightsCount = 4;

    /// The major version of URP whose rules hold where they have changed, 7 ... 17: that of the
    /// project that features were written for. Below 12 the camera's colour brings the camera's
    /// depth and stencil along where it is bound alone, as long as no pass asks for the depth
    /// texture; from 12 on it has none. Unity: the package com.unity.render-pipelines.universal.
    int pipelineVersion = 14;

    /// Passes that override both Execute and RecordRenderGraph run Execute. Unity:
    /// RenderGraphSettings.enableRenderCompatibilityMode (URP 17), where passes that override one
    /// of the two only run in one of the modes only; here they run in both.
    bool enableRenderCompatibilityMode = false;

    /// Of the main light, where it throws any. Unity: UniversalRenderPipelineAsset.
    ShadowSettings shadows;

    /// Culls, lets the renderer record, compiles the frame and starts it on the device: for a base
    /// camera and the overlays of its stack, one after the other in one frame. What is no overlay
    /// is left out of the stack, with a note.
    /// @throws ContractError, AssetError (a shader), VulkanError
    RenderResult RenderSingleCamera(UniversalRenderer& renderer, const RenderRequest& request);
    /// The same. A steady frame asks for no memory where each is given the result of the last.
    void RenderSingleCamera(UniversalRenderer& renderer, const RenderRequest& request,
                            RenderResult& result);

    /// Renders base cameras, each with its stack and as a frame of its own, in the order of their
    /// depths, equal ones as given: of those without a targetTexture the last one's picture stays.
    /// Overlays among them are drawn in the stacks that they are in only.
    /// @param request  `camera` is not looked at
    /// @return of each base camera, as drawn
    /// @throws ContractError, AssetError, VulkanError as RenderSingleCamera does
    /// @source Unity: UniversalRenderPipeline.Render(context, cameras) (URP 14)
    std::vector<RenderResult> Render(UniversalRenderer& renderer, const RenderRequest& request,
                                     std::span<const Camera* const> cameras);

private:
    void RenderStack(UniversalRenderer& renderer, const RenderRequest& request, FrameCache& frames,
                     RenderResult& result);
    void Finish(const RenderRequest& request, FrameCache& frames, const RTHandle& output,
                RenderResult& result);
    void FindLights(RenderingData& renderingData);
    void FindStack(const Camera& camera, RenderReport& report);

    GraphicsDevice* m_Device; ///< never null
    std::unique_ptr<ScriptableRenderContext> m_Context;
    RTHandle m_Output;
    RTHandle m_TargetTexture; ///< of the last camera that had one
    RenderTexturePool m_TemporaryTextures;
    FrameCache m_Frames;
    std::vector<FrameCache> m_FramesOfSeveral;                   ///< of Render's cameras, as drawn
    std::vector<const Light*> m_AdditionalLights;                ///< of the last camera
    std::vector<const Camera*> m_Stack;                          ///< of the last frame
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs; ///< of the last frame
    FrameCommands m_Commands; ///< of the last frame, for the memory of its lists
};

} // namespace limn
