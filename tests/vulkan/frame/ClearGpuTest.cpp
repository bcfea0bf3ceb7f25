#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <cstring>
#include <optional>

namespace limn::test
{

using ClearOnDevice = GpuTest;

TEST_F(ClearOnDevice, FillsEveryTexelWithTheColor)
{
    const TargetPtr target = MakeTarget(5, 3);
    SharedDevice().Execute(FrameOf({ClearPass(target, {0.2f, 0.4f, 0.6f, 0.8f})}, target));
    const Image image = ReadRows(*target);
    EXPECT_EQ(5, image.width);
    EXPECT_EQ(3, image.height);
    EXPECT_EQ(GraphicsFormat::R8G8B8A8_UNorm, image.format);
    ASSERT_EQ(60u, image.texels.size());
    for (int i = 0; i < 15; ++i)
    {
        EXPECT_EQ((Rgba8{51, 102, 153, 204}), Texel8(image, i % 5, i / 5)) << "texel " << i;
    }
}

TEST_F(ClearOnDevice, EncodesALinearColorInAnSrgbTarget)
{
    const TargetPtr target = MakeTarget(1, 1, GraphicsFormat::R8G8B8A8_SRGB);
    SharedDevice().Execute(FrameOf({ClearPass(target, {0.5f, 1.0f, 0.0f, 0.5f})}, target));
    // sRGB of 0.5 is 1.055 * 0.5^(1/2.4) - 0.055 = 0.7354, times 255 = 187.5; alpha is not encoded.
    const Rgba8 texel = Texel8(ReadRows(*target), 0, 0);
    EXPECT_NEAR(188, texel[0], 1);
    EXPECT_EQ(255, texel[1]);
    EXPECT_EQ(0, texel[2]);
    EXPECT_NEAR(128, texel[3], 1);
}

TEST_F(ClearOnDevice, KeepsValuesAboveOneInAFloatTarget)
{
    const TargetPtr target = MakeTarget(1, 1, GraphicsFormat::R32G32B32A32_SFloat);
    SharedDevice().Execute(FrameOf({ClearPass(target, {-1.5f, 2.5f, 1000.0f, 1.0f})}, target));
    EXPECT_EQ((std::array<float, 4>{-1.5f, 2.5f, 1000.0f, 1.0f}),
              TexelFloat(ReadRows(*target), 0, 0));
}

namespace
{

/// The first texel's bits of a cleared target, lowest first; nothing where the device does not draw
/// into such ones.
std::optional<std::uint64_t> ClearedBits(GraphicsFormat format, const Color& color)
{
    if (!SharedDevice().IsFormatSupported(format, FormatUsage::Render))
    {
        return std::nullopt;
    }
    const TargetPtr target = MakeTarget(1, 1, format);
    SharedDevice().Execute(FrameOf({ClearPass(target, color)}, target));
    const Image image = SharedDevice().ReadBack(*target);
    std::uint64_t bits = 0;
    std::memcpy(&bits, image.texels.data(), image.texels.size());
    return bits;
}

} // namespace

// By the formats' definitions: bits by their places, SNorm c as round(c * (2^(n-1) - 1)).
TEST_F(ClearOnDevice, WritesTheBitsOfEachKindOfFormat)
{
    using enum GraphicsFormat;
    struct Case
    {
        GraphicsFormat format;
        Color color;
        std::uint64_t bits;
    };
    int drawn = 0;
    for (const Case& one :
         {Case{R8G8_SNorm, {1, -1, 0}, 0x817F}, Case{R16G16_SNorm, {-1, 1, 0}, 0x7FFF8001},
          Case{R16_SNorm, {1, 0, 0}, 0x7FFF}, Case{R8_SInt, {-3, 0, 0}, 0xFD},
          Case{R16G16_UInt, {5, 7, 0}, 0x00070005}, Case{R16G16_SInt, {-1, 2, 0}, 0x0002FFFF},
          Case{R5G6B5_UNormPack16, {1, 0, 0}, 0xF800}, Case{B5G6R5_UNormPack16, {1, 0, 0}, 0x001F},
          Case{A1R5G5B5_UNormPack16, {1, 0, 0, 1}, 0xFC00},
          Case{A2B10G10R10_UIntPack32, {1, 2, 3, 1}, 0x40300801},
          Case{A2R10G10B10_UNormPack32, {1, 0, 0, 1}, 0xFFF00000},
          Case{R8G8B8A8_SInt, {-1, 1, 2, 3}, 0x030201FF}})
    {
        if (const auto bits = ClearedBits(one.format, one.color))
        {
            ++drawn;
            EXPECT_EQ(*bits, one.bits) << ToString(one.format);
        }
    }
    EXPECT_GE(drawn, 5) << "those that each device draws into";
}

TEST_F(ClearOnDevice, NamesAFormatThatWouldDo)
{
    for (const auto& [lacking, instead] :
         {std::pair(GraphicsFormat::R8G8B8_UNorm, "R8G8B8A8_UNorm"),
          std::pair(GraphicsFormat::R32G32B32_UInt, "R32G32B32A32_UInt"),
          std::pair(GraphicsFormat::E5B9G9R9_UFloatPack32, "R16G16B16A16_SFloat")})
    {
        if (SharedDevice().IsFormatSupported(lacking, FormatUsage::Render))
        {
            continue;
        }
        const TargetPtr target = MakeTarget(1, 1, lacking);
        try
        {
            SharedDevice().Execute(FrameOf({ClearPass(target, Color::red)}, target));
            ADD_FAILURE() << ToString(lacking);
        }
        catch (const ContractError& error)
        {
            EXPECT_NE(std::string(error.what()).find("; " + std::string(instead) + " would do"),
                      std::string::npos)
                << error.what();
        }
    }
}

TEST_F(ClearOnDevice, InsideAPassTouchesTheViewportOnly)
{
    const TargetPtr target = MakeTarget(4, 4);
    CompiledRenderPass pass = ClearPass(target, Color::black);
    pass.commands.emplace_back(SetViewportCommand{{1, 0, 2, 3}});
    pass.commands.emplace_back(ClearCommand{ClearFlag::Color, Color::white, 1.0f, 0});
    SharedDevice().Execute(FrameOf({pass}, target));
    const Image image = ReadRows(*target);
    for (int y = 0; y < 4; ++y)
    {
        for (int x = 0; x < 4; ++x)
        {
            const bool inside = x >= 1 && x < 3 && y < 3;
            EXPECT_EQ(inside ? 255 : 0, Texel8(image, x, y)[0]) << x << ", " << y;
        }
    }
}

TEST_F(ClearOnDevice, OfAViewportOutsideTheTargetTouchesNothing)
{
    const TargetPtr target = MakeTarget(2, 2);
    CompiledRenderPass pass = ClearPass(target, Color::black);
    pass.commands.emplace_back(SetViewportCommand{{5, 5, 2, 2}});
    pass.commands.emplace_back(ClearCommand{ClearFlag::All, Color::white, 1.0f, 0});
    SharedDevice().Execute(FrameOf({pass}, target));
    EXPECT_EQ((Rgba8{0, 0, 0, 255}), Texel8(ReadRows(*target), 1, 1));
}

TEST_F(ClearOnDevice, WritesDepthAsOneMinusUnitys)
{
    const TargetPtr color = MakeTarget(2, 1);
    const TargetPtr depth = MakeDepth(2, 1);
    CompiledRenderPass pass = ClearPass(color);
    AddDepth(pass, depth);
    pass.depth->clearDepth = 1.0f;
    pass.commands.emplace_back(SetViewportCommand{{1, 0, 1, 1}});
    pass.commands.emplace_back(ClearCommand{ClearFlag::Depth, Color::black, 0.25f, 0});
    SharedDevice().Execute(FrameOf({pass}, depth));
    const Image image = ReadRows(*depth);
    EXPECT_EQ(GraphicsFormat::D32_SFloat, image.format);
    EXPECT_EQ(0.0f, TexelFloat<1>(image, 0, 0)[0]);
    EXPECT_EQ(0.75f, TexelFloat<1>(image, 1, 0)[0]);
}

TEST_F(ClearOnDevice, ReadsTheDepthOfADepthStencilTarget)
{
    const TargetPtr depth = MakeDepth(3, 2, true);
    CompiledRenderPass pass;
    pass.width = 3;
    pass.height = 2;
    AddDepth(pass, depth);
    pass.depth->clearDepth = 0.5f;
    SharedDevice().Execute(FrameOf({pass}, depth));
    const Image image = ReadRows(*depth);
    EXPECT_EQ(GraphicsFormat::D32_SFloat, image.format);
    ASSERT_EQ(24u, image.texels.size());
    EXPECT_EQ(0.5f, TexelFloat<1>(image, 2, 1)[0]);
}

struct FormatCase
{
    GraphicsFormat format;
    std::vector<int> bytes; ///< of a texel cleared to (1, 0, 1, 1), little-endian
};

class ClearEveryFormat : public GpuTest, public testing::WithParamInterface<FormatCase>
{
};

TEST_P(ClearEveryFormat, HasTheFormatsBytes)
{
    const TargetPtr target = MakeTarget(1, 1, GetParam().format);
    SharedDevice().Execute(FrameOf({ClearPass(target, {1.0f, 0.0f, 1.0f, 1.0f})}, target));
    std::vector<int> bytes;
    for (const std::byte byte : ReadRows(*target).texels)
    {
        bytes.push_back(std::to_integer<int>(byte));
    }
    EXPECT_EQ(GetParam().bytes, bytes);
}

// Half 1.0 is 0x3C00, float 1.0 is 0x3F800000; 11-bit float 1.0 is 0x3C0, 10-bit float 1.0 is
// 0x1E0, so red 1 and blue 1 of B10G11R11 make 0x3C0 | 0x1E0 << 22 = 0x780003C0.
INSTANTIATE_TEST_SUITE_P(
    Formats, ClearEveryFormat,
    testing::Values(
        FormatCase{GraphicsFormat::R8_UNorm, {255}},
        FormatCase{GraphicsFormat::R8G8B8A8_UNorm, {255, 0, 255, 255}},
        FormatCase{GraphicsFormat::R8G8B8A8_SRGB, {255, 0, 255, 255}},
        FormatCase{GraphicsFormat::R16G16_UNorm, {255, 255, 0, 0}},
        FormatCase{GraphicsFormat::R16G16B16A16_UNorm, {255, 255, 0, 0, 255, 255, 255, 255}},
        FormatCase{GraphicsFormat::R16_SFloat, {0, 0x3C}},
        FormatCase{GraphicsFormat::R16G16_SFloat, {0, 0x3C, 0, 0}},
        FormatCase{GraphicsFormat::R16G16B16A16_SFloat, {0, 0x3C, 0, 0, 0, 0x3C, 0, 0x3C}},
        FormatCase{GraphicsFormat::R32_SFloat, {0, 0, 0x80, 0x3F}},
        FormatCase{GraphicsFormat::R32G32_SFloat, {0, 0, 0x80, 0x3F, 0, 0, 0, 0}},
        FormatCase{GraphicsFormat::B10G11R11_UFloatPack32, {0xC0, 0x03, 0, 0x78}},
        FormatCase{GraphicsFormat::R8G8_UNorm, {255, 0}},
        FormatCase{GraphicsFormat::R16_UNorm, {255, 255}},
        FormatCase{GraphicsFormat::B8G8R8A8_UNorm, {255, 0, 255, 255}},
        FormatCase{GraphicsFormat::B8G8R8A8_SRGB, {255, 0, 255, 255}},
        // red 0x3FF, green 0, blue 0x3FF << 20, alpha 3 << 30
        FormatCase{GraphicsFormat::A2B10G10R10_UNormPack32, {0xFF, 0x03, 0xF0, 0xFF}},
        FormatCase{GraphicsFormat::R8_UInt, {1}}, FormatCase{GraphicsFormat::R16_UInt, {1, 0}},
        FormatCase{GraphicsFormat::R8G8B8A8_UInt, {1, 0, 1, 1}},
        FormatCase{GraphicsFormat::R16G16B16A16_UInt, {1, 0, 0, 0, 1, 0, 1, 0}},
        FormatCase{GraphicsFormat::R32_UInt, {1, 0, 0, 0}},
        FormatCase{GraphicsFormat::R32G32_UInt, {1, 0, 0, 0, 0, 0, 0, 0}},
        FormatCase{GraphicsFormat::R32G32B32A32_UInt,
                   {1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}},
        FormatCase{GraphicsFormat::R32_SInt, {1, 0, 0, 0}},
        FormatCase{GraphicsFormat::R32G32_SInt, {1, 0, 0, 0, 0, 0, 0, 0}},
        FormatCase{GraphicsFormat::R32G32B32A32_SInt,
                   {1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}}),
    [](const auto& which) { return std::string(ToString(which.param.format)); });

} // namespace limn::test
