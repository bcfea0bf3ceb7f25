#pragma once

#include <limn/core/GraphicsDevice.h>

namespace limn::benchmarks
{

/// Remembers what a frame leaves to the next, and draws nothing: what the rest of a frame costs.
class NoDevice final : public GraphicsDevice
{
public:
    void Execute(const CompiledFrame& frame) override { m_States = frame.states; }
    const TextureStates& textureStates() const override { return m_States; }
    Image ReadBack(const RenderTexture&) override { return {}; }
    bool IsFormatSupported(GraphicsFormat, FormatUsage) const override { return true; }
    std::vector<PassTiming> LastFrameTimings() override { return {}; }
    int GetRenderTextureSupportedMSAASampleCount(const RenderTextureDescriptor&) const override
    {
        return 1;
    }

private:
    TextureStates m_States;
};

} // namespace limn::benchmarks
