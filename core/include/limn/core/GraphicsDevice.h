#pragma once

#include <limn/core/FrameCompiler.h>
#include <limn/core/Image.h>
#include <limn/core/SystemInfo.h>

namespace limn
{

/// The time that one pass of a frame took on the device.
struct PassTiming
{
    std::string name; ///< CompiledRenderPass::Title
    double milliseconds = 0.0;
    double start = 0.0; ///< milliseconds after the frame's first pass began
};

class PendingReadback;
class Timeline;

/// Runs compiled frames. VulkanDevice draws them; RecordingDevice keeps what it was given.
class GraphicsDevice
{
public:
    GraphicsDevice(const GraphicsDevice&) = delete;
    GraphicsDevice& operator=(const GraphicsDevice&) = delete;
    virtual ~GraphicsDevice();

    /// Starts the frame and returns without waiting for it. Frames run in the order in which they
    /// are given.
    virtual void Execute(const CompiledFrame& frame) = 0;

    /// Returns the states that the frames so far leave to the next one, for CompileFrame.
    virtual const TextureStates& textureStates() const = 0;

    /// Returns the memory that a render texture would take, for CompileFrame; its size is 0 if this
    /// device shares no memory.
    virtual TextureFootprint Footprint(const RenderTexture&) { return {}; }

    /// Returns whether there are pictures that ReadBack could read.
    virtual bool drawsPictures() const { return true; }

    /// Returns the texels of a texture that was an output of the last frame, the top row of its
    /// picture first whichever way up the texture is; waits for the frame.
    /// @throws ContractError if the texture was no output of the last frame
    virtual Image ReadBack(const RenderTexture& texture) = 0;

    /// Returns GraphicsBuffer::bytes() as the last frame left them; waits for the frame.
    /// @throws ContractError if no frame has used the buffer
    virtual std::vector<std::byte> ReadBackBuffer(const GraphicsBuffer& buffer);

    /// Starts to read back without waiting, for AsyncGPUReadback. A device that has nothing to wait
    /// for reads at once.
    virtual std::shared_ptr<PendingReadback> BeginReadBack(const RenderTexture& texture);
    virtual std::shared_ptr<PendingReadback> BeginReadBack(const GraphicsBuffer& buffer);

    /// Returns the samples per texel with which the device draws such a texture: at most the
    /// descriptor's msaaSamples, and at least 1.
    /// Unity: SystemInfo.GetRenderTextureSupportedMSAASampleCount.
    virtual int
    GetRenderTextureSupportedMSAASampleCount(const RenderTextureDescriptor& descriptor) const = 0;

    /// Returns whether the device supports a use of a format, for SystemInfo. Any thread may call
    /// it.
    virtual bool IsFormatSupported(GraphicsFormat format, FormatUsage usage) const
    {
        return EveryDeviceSupports(format, usage);
    }

    /// Returns the times of the passes of the last finished frame, in order; empty if nothing is
    /// measured.
    virtual std::vector<PassTiming> LastFrameTimings() = 0;

    /// Sets where the device records, from now on, how long the parts of its work on the CPU take.
    /// @param timeline  null = nowhere; else it must outlive the device, or live until the next
    ///     call
    virtual void SetTimeline(Timeline* timeline) { static_cast<void>(timeline); }

protected:
    GraphicsDevice();
};

} // namespace limn
