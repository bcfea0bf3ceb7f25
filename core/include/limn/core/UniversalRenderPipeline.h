#pragma once

#include <limn/core/FrameCache.h>
#include <limn/core/GraphicsDevice.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/Timeline.h>
#include <limn/core/UniversalRenderer.h>

namespace limn
{

/// What to render once.
struct RenderRequest
{
    const Scene* scene = nullptr;   ///< never null
    const Camera* camera = nullptr; ///< never null
    int width = 0;                  ///< pixels, > 0
    int height = 0;                 ///< pixels, > 0
    double time = 0.0; ///< seconds, what _Time shows; at most 1e38, since _Time.w is 3 times that
    const VolumeStack* volumeStack = nullptr; ///< blended for this camera; null: all defaults
    std::vector<RTHandle> alsoReadBack;       ///< further textures to keep readable after the frame
    FrameCompilerOptions compile;             ///< what may be left out
    Timeline* timeline = nullptr; ///< gets "cull", "record", "compile", "execute"; may be null
};

/// What rendering gave.
struct RenderResult
{
    RTHandle output; ///< R8G8B8A8_SRGB; read it back with GraphicsDevice::ReadBack
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
    }

    /// Samples a texel of the camera's colour and depth, where the camera allows them: 1, 2, 4
    /// or 8. Where the device lacks them there are fewer, with a note. Unity:
    /// UniversalRenderPipelineAsset.msaaSampleCount.
    int msaaSampleCount = 1;

    /// Of the main light, where it throws any. Unity: UniversalRenderPipelineAsset.
    ShadowSettings shadows;

    /// Culls, lets the renderer record, compiles the frame and starts it on the device.
    /// @throws ContractError, AssetError (a shader), VulkanError
    RenderResult RenderSingleCamera(UniversalRenderer& renderer, const RenderRequest& request);
    /// The same. A steady frame asks for no memory where each is given the result of the last.
    void RenderSingleCamera(UniversalRenderer& renderer, const RenderRequest& request,
                            RenderResult& result);

private:
    GraphicsDevice* m_Device; ///< never null
    std::unique_ptr<ScriptableRenderContext> m_Context;
    RTHandle m_Output;
    RenderTexturePool m_TemporaryTextures;
    FrameCache m_Frames;
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs; ///< of the last frame
    FrameCommands m_Commands; ///< of the last frame, for the memory of its lists
};

} // namespace limn
