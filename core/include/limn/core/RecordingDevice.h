#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/core/GraphicsDevice.h>

namespace limn
{

/// A device that draws nothing and keeps every frame it was given, for tests without Vulkan.
class RecordingDevice final : public GraphicsDevice
{
public:
    void Execute(const CompiledFrame& frame) override
    {
        m_Frames.push_back(frame);
        m_TextureStates = frame.states;
    }
    const TextureStates& textureStates() const override { return m_TextureStates; }
    /// Returns the size of the texels without padding, in units of 256 bytes.
    TextureFootprint Footprint(const RenderTexture& texture) override
    {
        const auto bytes = static_cast<std::uint64_t>(texture.width()) *
                           static_cast<std::uint64_t>(texture.height()) *
                           static_cast<std::uint64_t>(BytesPerTexel(texture.graphicsFormat()));
        return {(bytes + 255) / 256 * 256, 256, 0};
    }
    /// @throws ContractError always: nothing was drawn
    bool drawsPictures() const override { return false; }
    Image ReadBack(const RenderTexture& texture) override
    {
        throw ContractError("RecordingDevice draws nothing, so '" + texture.name() +
                            "' has no texels to read back");
    }
    int GetRenderTextureSupportedMSAASampleCount(
        const RenderTextureDescriptor& descriptor) const override
    {
        return descriptor.msaaSamples;
    }
    bool IsFormatSupported(GraphicsFormat, FormatUsage) const override { return true; }
    std::vector<PassTiming> LastFrameTimings() override { return {}; }

    const std::vector<CompiledFrame>& frames() const { return m_Frames; }

private:
    std::vector<CompiledFrame> m_Frames;
    TextureStates m_TextureStates;
};

} // namespace limn
