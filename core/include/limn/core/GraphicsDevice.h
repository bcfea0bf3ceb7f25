#pragma once

#include <limn/core/FrameCompiler.h>
#include <limn/core/Image.h>
#include <limn/core/SystemInfo.h>

namespace limn
{

/// How long one pass of a frame took on the device.
struct PassTiming
{
    std::string name; ///< CompiledRenderPass::Title
    double milliseconds = 0.0;
    double start = 0.0; ///< milliseconds after the frame's first pass began
};

class PendingReadback;
class Timeline;

/// Runs compiled frames. VulkanDevice draws; RecordingDevice keeps what it was given.
class GraphicsDevice
{
public:
    GraphicsDevice(const GraphicsDevice&) = delete;
    GraphicsDevice& operator=(const GraphicsDevice&) = delete;
    virtual ~GraphicsDevice();

    /// Starts the frame; returns without waiting for it. Frames run in the order given.
    virtual void Execute(const CompiledFrame& frame) = 0;

    /// What the frames so far leave to the next one, for CompileFrame.
    virtual const TextureStates& textureStates() const = 0;

    /// What of its memory a render texture would take, for CompileFrame; of size 0 where this
    /// device shares none.
    virtual TextureFootprint Footprint(const RenderTexture&) { return {}; }

    /// Returns whether there are pictures that ReadBack could read.
    virtual bool drawsPictures() const { return true; }

    /// Returns the texels of a texture that was an output of the last frame, the top row of its
    /// picture first whichever way up the texture is; waits for it.
    /// @throws ContractError if it was not
    virtual Image ReadBack(const RenderTexture& texture) = 0;

    /// GraphicsBuffer::bytes() as the last frame left them; waits for it.
    /// @throws ContractError if no frame has used the buffer
    virtual std::vector<std::byte> ReadBackBuffer(const GraphicsBuffer& buffer);

    /// The same without waiting, for AsyncGPUReadback. A device that has nothing to wait for reads
    /// at once.
    virtual std::shared_ptr<PendingReadback> BeginReadBack(const RenderTexture& texture);
    virtual std::shared_ptr<PendingReadback> BeginReadBack(const GraphicsBuffer& buffer);

    /// How many samples a texel it draws such a texture with: at most the descriptor's msaaSamples,
    /// and at least 1. Unity: SystemInfo.GetRenderTextureSupportedMSAASampleCount.
    virtual int
    GetRenderTextureSupportedMSAASampleCount(const RenderTextureDescriptor& descriptor) const = 0;

    /// For SystemInfo, from any thread.
    virtual bool IsFormatSupported(GraphicsFormat format, FormatUsage usage) const
    {
        return EveryDeviceSupports(format, usage);
    }

    /// Times of the passes of the last finished frame, in order; empty where nothing is measured.
    virtual std::vector<PassTiming> LastFrameTimings() = 0;

    /// Where the device records from now on how long the parts of its work on the CPU take.
    /// @param timeline  null = nowhere; else it must outlive this, or another call
    virtual void SetTimeline(Timeline* timeline) { static_cast<void>(timeline); }

protected:
    GraphicsDevice();
};

} // namespace limn
