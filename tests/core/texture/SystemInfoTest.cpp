#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/SystemInfo.h>

namespace limn
{
namespace
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

TEST(SystemInfo, HasUnitysNumbersOfUsages)
{
    EXPECT_EQ(static_cast<int>(FormatUsage::Render), 4);
    EXPECT_EQ(static_cast<int>(FormatUsage::Blend), 5);
    EXPECT_EQ(static_cast<int>(FormatUsage::LoadStore), 10);
    EXPECT_EQ(static_cast<int>(FormatUsage::StencilSampling), 16);
}

TEST(SystemInfo, AsksTheDeviceThatWasMadeLast)
{
    using RenderingUtils::SupportsRenderTextureFormat;
    // Without one: what the specification promises of all.
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::ARGBHalf));
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::R8));
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::Depth));
    EXPECT_FALSE(SupportsRenderTextureFormat(RenderTextureFormat::RG32));
    {
        const PickyDevice device(GraphicsFormat::R16G16_UNorm);
        EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::RG32));
        EXPECT_FALSE(SupportsRenderTextureFormat(RenderTextureFormat::R8));
        const PickyDevice later(GraphicsFormat::R8_UNorm);
        EXPECT_FALSE(SupportsRenderTextureFormat(RenderTextureFormat::RG32));
        EXPECT_TRUE(
            RenderingUtils::SupportsGraphicsFormat(GraphicsFormat::R8_UNorm, FormatUsage::Linear));
    }
    EXPECT_TRUE(SupportsRenderTextureFormat(RenderTextureFormat::ARGBHalf)) << "both are gone";
}

// Vulkan 1.3, 34.5: rows of the tables of mandatory formats.
TEST(SystemInfo, KnowsWhatEveryDeviceDoes)
{
    using enum GraphicsFormat;
    EXPECT_TRUE(EveryDeviceSupports(R16_SFloat, FormatUsage::Blend));
    EXPECT_TRUE(EveryDeviceSupports(R32_SFloat, FormatUsage::Render));
    EXPECT_FALSE(EveryDeviceSupports(R32_SFloat, FormatUsage::Blend));
    EXPECT_FALSE(EveryDeviceSupports(R32G32B32A32_SFloat, FormatUsage::Linear));
    EXPECT_TRUE(EveryDeviceSupports(B10G11R11_UFloatPack32, FormatUsage::Linear));
    EXPECT_FALSE(EveryDeviceSupports(B10G11R11_UFloatPack32, FormatUsage::Render));
    EXPECT_TRUE(EveryDeviceSupports(A2B10G10R10_UNormPack32, FormatUsage::Blend));
    EXPECT_TRUE(EveryDeviceSupports(R8G8B8A8_SNorm, FormatUsage::LoadStore));
    EXPECT_FALSE(EveryDeviceSupports(R8G8B8A8_SRGB, FormatUsage::LoadStore));
    EXPECT_TRUE(EveryDeviceSupports(R32_UInt, FormatUsage::Render));
    EXPECT_FALSE(EveryDeviceSupports(R32_UInt, FormatUsage::Blend));
    EXPECT_FALSE(EveryDeviceSupports(R32_UInt, FormatUsage::MSAA4x));
    EXPECT_TRUE(EveryDeviceSupports(R8G8B8A8_UNorm, FormatUsage::MSAA4x));
    EXPECT_FALSE(EveryDeviceSupports(R8G8B8A8_UNorm, FormatUsage::Sparse));
    EXPECT_FALSE(EveryDeviceSupports(None, FormatUsage::Sample));
}

} // namespace
} // namespace limn
