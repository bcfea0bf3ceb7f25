#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/RenderTexture.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::Mentions;
using test::ThrownMessage;

GraphicsFormat FormatFor(int depthBufferBits)
{
    return RenderTexture("t", {4, 4, GraphicsFormat::None, depthBufferBits}).graphicsFormat();
}

TEST(RenderTexture, KeepsItsDescriptor)
{
    RenderTextureDescriptor descriptor(640, 360, GraphicsFormat::R16G16B16A16_SFloat);
    descriptor.msaaSamples = 4;
    const RenderTexture texture("_Color", descriptor, {}, true);
    EXPECT_EQ(texture.descriptor(), descriptor);
    EXPECT_EQ(texture.name(), "_Color");
    EXPECT_EQ(texture.width(), 640);
    EXPECT_EQ(texture.height(), 360);
    EXPECT_TRUE(texture.isTransient());
    EXPECT_FALSE(RenderTexture("t", descriptor).isTransient());
}

TEST(RenderTexture, HasADepthBesideItsColourWithDepthBits)
{
    RenderTextureDescriptor descriptor(4, 6, GraphicsFormat::R8_UNorm);
    EXPECT_EQ(RenderTexture("t", descriptor).depthBuffer(), nullptr);
    descriptor.msaaSamples = 4;
    for (const auto& [bits, format] : {std::pair(16, GraphicsFormat::D32_SFloat),
                                       std::pair(24, GraphicsFormat::D32_SFloat_S8_UInt),
                                       std::pair(32, GraphicsFormat::D32_SFloat_S8_UInt)})
    {
        descriptor.depthBufferBits = bits;
        const RenderTexture texture("t", descriptor);
        EXPECT_EQ(texture.graphicsFormat(), GraphicsFormat::R8_UNorm);
        ASSERT_TRUE(texture.depthBuffer());
        const RenderTexture& depth = *texture.depthBuffer();
        EXPECT_EQ(depth.graphicsFormat(), format);
        EXPECT_EQ(depth.width(), 4);
        EXPECT_EQ(depth.height(), 6);
        EXPECT_EQ(depth.descriptor().msaaSamples, 4);
        EXPECT_EQ(depth.depthBuffer(), nullptr);
    }
}

TEST(RenderTexture, TakesADepthThatIsThereIfItFits)
{
    const auto depth = std::make_shared<const RenderTexture>(
        "d", RenderTextureDescriptor(4, 4, GraphicsFormat::None, 24));
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8_UNorm);
    EXPECT_EQ(RenderTexture("t", descriptor, {}, false, depth).depthBuffer(), depth);
    descriptor.width = 5;
    EXPECT_THROW(RenderTexture("t", descriptor, {}, false, depth), ContractError);
    descriptor.width = 4;
    descriptor.depthBufferBits = 16;
    EXPECT_THROW(RenderTexture("t", descriptor, {}, false, depth), ContractError);
    EXPECT_THROW(RenderTexture("t", {4, 4, GraphicsFormat::R8_UNorm}, {}, false, nullptr),
                 ContractError);
}

TEST(RenderTexture, IsADepthTextureWithDepthBitsAndNoColourFormat)
{
    EXPECT_EQ(FormatFor(16), GraphicsFormat::D32_SFloat);
    EXPECT_EQ(FormatFor(24), GraphicsFormat::D32_SFloat_S8_UInt);
    EXPECT_EQ(FormatFor(32), GraphicsFormat::D32_SFloat_S8_UInt);
}

TEST(RenderTexture, IsADepthTextureWhenTheOlderFormatIsDepth)
{
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8_UNorm);
    descriptor.SetColorFormat(RenderTextureFormat::Depth);
    EXPECT_EQ(RenderTexture("t", descriptor).graphicsFormat(), GraphicsFormat::D32_SFloat);
}

TEST(RenderTextureDescriptor, StaysAsItIsEncodedWhenItsColorFormatIsSet)
{
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8G8B8A8_SRGB);
    descriptor.SetColorFormat(RenderTextureFormat::ARGB32);
    EXPECT_EQ(descriptor.graphicsFormat, GraphicsFormat::R8G8B8A8_SRGB);
    descriptor.graphicsFormat = GraphicsFormat::R16G16B16A16_SFloat;
    descriptor.SetColorFormat(RenderTextureFormat::ARGB32);
    EXPECT_EQ(descriptor.graphicsFormat, GraphicsFormat::R8G8B8A8_UNorm);
}

TEST(RenderTexture, RejectsADefaultDescriptor)
{
    EXPECT_THAT(ThrownMessage<ContractError>([] { RenderTexture("_Mask", {}); }),
                Mentions("'_Mask'", "0x0", "at least 1"));
}

TEST(RenderTexture, RejectsNumbersOfSamplesThatNoHardwareHas)
{
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8_UNorm);
    for (const int samples : {0, 3, 16, -1})
    {
        descriptor.msaaSamples = samples;
        EXPECT_THAT(
            ThrownMessage<ContractError>([&] { RenderTexture("_Mask", descriptor); }),
            Mentions("'_Mask'", "msaaSamples is " + std::to_string(samples), "1, 2, 4 or 8"));
    }
}

TEST(RenderTexture, RejectsDepthBitsThatUnityDoesNotName)
{
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [] {
                        RenderTexture("_Mask", {4, 4, GraphicsFormat::R8_UNorm, 23});
                    }),
                Mentions("'_Mask'", "depthBufferBits", "23", "0, 16, 24 or 32"));
}

TEST(RenderTexture, RejectsNoFormatAtAll)
{
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [] {
                        RenderTexture("_Mask", {4, 4, GraphicsFormat::None});
                    }),
                Mentions("'_Mask'", "format is None"));
}

TEST(RenderTexture, HasTheMipLevelsThatItsDescriptorSays)
{
    RenderTextureDescriptor descriptor(20, 7, GraphicsFormat::R8_UNorm);
    EXPECT_EQ(RenderTexture("a", descriptor).mipmapCount(), 1);
    descriptor.useMipMap = true;
    EXPECT_EQ(RenderTexture("a", descriptor).mipmapCount(), 5) << "20, 10, 5, 2, 1";
    descriptor.mipCount = 3;
    EXPECT_EQ(RenderTexture("a", descriptor).mipmapCount(), 3);
    descriptor.mipCount = 6;
    EXPECT_THAT(ThrownMessage<ContractError>([&] { RenderTexture("a", descriptor); }),
                Mentions("'a'", "6 mip levels", "20x7", "1 to 5"));
    descriptor.graphicsFormat = GraphicsFormat::None;
    descriptor.depthBufferBits = 24;
    descriptor.mipCount = 0;
    EXPECT_THAT(ThrownMessage<ContractError>([&] { RenderTexture("a", descriptor); }),
                Mentions("'a'", "useMipMap", "depth texture"));
}

TEST(RenderTexture, RefusesWhatADescriptorMayAskForInVain)
{
    const auto message = [](auto change)
    {
        RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8_UNorm);
        change(descriptor);
        return ThrownMessage<ContractError>([&] { RenderTexture("t", descriptor); });
    };
    EXPECT_THAT(message([](auto& d) { d.dimension = TextureDimension::Cube; }),
                Mentions("'t'", "dimension is Cube", "volumeDepth is 1", "2D", "volumeDepth of 1"));
    EXPECT_THAT(message([](auto& d) { d.volumeDepth = 2; }),
                Mentions("'t'", "dimension is 2D", "volumeDepth is 2", "volumeDepth of 1"));
    EXPECT_THAT(message([](auto& d) { d.vrUsage = VRTextureUsage::TwoEyes; }),
                Mentions("'t'", "vrUsage", "VRTextureUsage::None"));
    EXPECT_THAT(message([](auto& d) { d.bindMS = true; }),
                Mentions("'t'", "bindMS is true", "resolved"));
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8_UNorm, 32);
    descriptor.memoryless = RenderTextureMemoryless::Depth;
    descriptor.useDynamicScale = true;
    EXPECT_FALSE(RenderTexture("t", descriptor).sampler().comparison);
    descriptor.shadowSamplingMode = ShadowSamplingMode::CompareDepths;
    EXPECT_TRUE(RenderTexture("t", descriptor).sampler().comparison);
}

TEST(RenderTexture, OfIntegersHasNoAverages)
{
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R32_SInt);
    descriptor.useMipMap = true;
    EXPECT_THAT(ThrownMessage<ContractError>([&] { RenderTexture("t", descriptor); }),
                Mentions("'t'", "integer", "R32_SInt", "useMipMap"));
    descriptor.useMipMap = false;
    descriptor.msaaSamples = 4;
    EXPECT_THAT(ThrownMessage<ContractError>([&] { RenderTexture("t", descriptor); }),
                Mentions("'t'", "integer", "R32_SInt", "several samples"));
}

TEST(RenderTexture, TakesItsDepthByFormatAsWell)
{
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::None);
    EXPECT_EQ(descriptor.depthStencilFormat(), GraphicsFormat::None);
    for (const GraphicsFormat format :
         {GraphicsFormat::D32_SFloat, GraphicsFormat::D32_SFloat_S8_UInt})
    {
        descriptor.SetDepthStencilFormat(format);
        EXPECT_EQ(descriptor.depthStencilFormat(), format);
        EXPECT_EQ(RenderTexture("t", descriptor).graphicsFormat(), format);
    }
    descriptor.SetDepthStencilFormat(GraphicsFormat::None);
    EXPECT_EQ(descriptor.depthBufferBits, 0);
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [&] { descriptor.SetDepthStencilFormat(GraphicsFormat::R8_UNorm); }),
                Mentions("SetDepthStencilFormat", "R8_UNorm", "no depth format"));
}

} // namespace
} // namespace limn
