#pragma once

#include <limn/core/GraphicsDevice.h>

namespace limn::test
{

/// Says yes to one format alone.
class PickyDevice final : public GraphicsDevice
{
public:
    explicit PickyDevice(GraphicsFormat format) : m_Format(format) {}

    void Execute(const CompiledFrame&) override {}
    const TextureStates& textureStates() const override { return m_States; }
    Image ReadBack(const RenderTexture&) override { return {}; }
    int GetRenderTextureSupportedMSAASampleCount(const RenderTextureDescriptor&) const override
    {
        return 1;
    }
    std::vector<PassTiming> LastFrameTimings() override { return {}; }
    bool IsFormatSupported(GraphicsFormat format, FormatUsage) const override
    {
        return format == m_Format;
    }

private:
    GraphicsFormat m_Format;
    TextureStates m_States;
};

} // namespace limn::test
