#pragma once

#include <functional>
#include <limn/core/FrameCompiler.h>
#include <limn/core/GraphicsDevice.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/Timeline.h>
#include <limn/core/UniversalRenderer.h>
#include <optional>

namespace limn
{

/// Selects the number of bits per pixel of a camera's colour that is HDR.
/// Unity: UnityEngine.Rendering.Universal.HDRColorBufferPrecision (URP 14).
enum class HDRColorBufferPrecision
{
    _32Bits = 0, ///< B10G11R11_UFloatPack32, which has no alpha
    _64Bits = 1  ///< R16G16B16A16_SFloat
};

/// A request to render one picture.
struct RenderRequest
{
    const Scene* scene = nullptr;   ///< never null
    const Camera* camera = nullptr; ///< never null; a base camera, its stack follows
    int width = 0;     ///< pixels, > 0; a camera with a targetTexture has that one's size
    int height = 0;    ///< pixels, > 0
    double time = 0.0; ///< seconds, shown by _Time; at most 1e38, since _Time.w is 3 times that
    /// The blended volumes for this camera; null = all defaults.
    const VolumeStack* volumeStack = nullptr;
    /// Returns the volume stack in place of volumeStack. It is called for each camera of a stack
    /// before its features are asked; the result must be valid until the next call.
    std::function<const VolumeStack*(const Camera&)> blendVolumes;
    std::vector<RTHandle> alsoReadBack; ///< further textures to keep readable after the frame
    FrameCompilerOptions compile;       ///< options about what may be left out
    Timeline* timeline = nullptr; ///< gets "cull", "record", "compile", "execute"; may be null
};

/// The result of rendering.
struct RenderResult
{
    /// The picture, in the format of DefaultFormat::LDR, or the camera's targetTexture. Read it
    /// back with GraphicsDevice::ReadBack.
    RTHandle output;
    RenderReport report;
    std::shared_ptr<const CompiledFrame> frame; ///< as the device ran it; never null
};

/// Renders cameras on a device. Keep one as long as its device, since its textures stay between
/// frames. Unity: UnityEngine.Rendering.Universal.UniversalRenderPipeline (URP 14).
class UniversalRenderPipeline
{
public:
    /// @param device  must live as long as this, or until the next SetDevice
    explicit UniversalRenderPipeline(GraphicsDevice& device);

    /// Continues with another device, e.g. after the first was lost: the contents of textures are
    /// lost.
    /// @param device  must outlive this
    void SetDevice(GraphicsDevice& device)
    {
        m_Device = &device;
        m_Frames.Clear();
        m_FramesOfSeveral.clear();
    }

    GraphicsDevice& device() const { return *m_Device; }

    /// The samples per texel of the camera's colour and depth, if the camera allows them: 1, 2, 4
    /// or 8. A device that lacks them uses fewer, with a note.
    /// Unity: UniversalRenderPipelineAsset.msaaSampleCount.
    int msaaSampleCount = 1;

    /// If true, cameras with allowHDR draw into an HDR colour.
    /// Unity: UniversalRenderPipelineAsset.supportsHDR.
    bool supportsHDR = true;

    /// The size of a pixel of an HDR colour. If the device cannot draw and blend 32 bits, it is 64
    /// bits, with a note. Unity: UniversalRenderPipelineAsset.hdrColorBufferPrecision, where 32
    /// bits are the default.
    HDRColorBufferPrecision hdrColorBufferPrecision = HDRColorBufferPrecision::_64Bits;

    /// The size of the target that cameras draw into, as a share of their picture's, 0.1 ... 2;
    /// their picture is made from it by bilinear sampling. Within 0.05 of 1, and for cameras of
    /// type SceneView, Preview and Reflection, it is 1.
    /// Unity: UniversalRenderPipelineAsset.renderScale.
    float renderScale = 1.0f;

    /// The largest number of lights besides the main one that light an object, 0 ... 8: the
    /// brightest at its place are chosen.
    /// Unity: UniversalRenderPipelineAsset.maxAdditionalLightsCount.
    int maxAdditionalLightsCount = 4;

    /// The major version of URP whose rules hold where they have changed, 7 ... 17: that of the
    /// project for which features were written. Below 12 the camera's colour brings the camera's
    /// depth and stencil along if it is bound alone, as long as no pass asks for the depth texture;
    /// from 12 on it has none. Unity: the package com.unity.render-pipelines.universal.
    int pipelineVersion = 14;

    /// If true, passes that override both Execute and RecordRenderGraph run Execute.
    /// Unity: RenderGraphSettings.enableRenderCompatibilityMode (URP 17), where passes that
    /// override only one of the two run in only one of the modes; here they run in both.
    bool enableRenderCompatibilityMode = false;

    /// The settings of shadows, for lights that throw any. Unity: UniversalRenderPipelineAsset.
    ShadowSettings shadows;

    /// Culls, lets the renderer record, compiles the frame and starts it on the device: for a base
    /// camera and the overlays of its stack, one after the other in one frame. Cameras of the stack
    /// that are no overlays are left out, with a note.
    /// @throws ContractError, AssetError (a shader), VulkanError
    RenderResult RenderSingleCamera(UniversalRenderer& renderer, const RenderRequest& request);
    /// Renders in the same way. A steady frame allocates no memory if each call is given the result
    /// of the last.
    void RenderSingleCamera(UniversalRenderer& renderer, const RenderRequest& request,
                            RenderResult& result);

    /// Renders base cameras, each with its stack and as a frame of its own, in the order of their
    /// depths, equal ones as given. Of those without a targetTexture the last one's picture stays.
    /// Overlays among them are drawn only in the stacks that contain them.
    /// @param request  its `camera` is ignored
    /// @return the result of each base camera, in the order of drawing
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
    void AdvanceTime(double time);

    GraphicsDevice* m_Device; ///< never null
    std::unique_ptr<ScriptableRenderContext> m_Context;
    RTHandle m_Output;
    RTHandle m_TargetTexture;     ///< of the last camera that had one
    std::optional<double> m_Time; ///< of the last frame, in seconds
    double m_DeltaTime = 0.0;
    RenderTexturePool m_TemporaryTextures;
    FrameCache m_Frames;
    /// The caches for the cameras of Render, in the order of drawing.
    std::vector<FrameCache> m_FramesOfSeveral;
    std::vector<const Light*> m_AdditionalLights;                ///< of the last camera
    std::vector<const Camera*> m_Stack;                          ///< of the last frame
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs; ///< of the last frame
    FrameCommands m_Commands; ///< of the last frame, for the memory of its lists
};

} // namespace limn
