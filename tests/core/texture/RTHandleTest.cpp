#include <algorithm>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/RTHandle.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::Mentions;

using RenderingUtils::ReAllocateIfNeeded;

const RenderTextureDescriptor k_Mask(960, 540, GraphicsFormat::R8_UNorm);

RTHandle MaskHandle(const RenderTextureDescriptor& descriptor = k_Mask)
{
    return RTHandles::Alloc(descriptor, FilterMode::Bilinear, TextureWrapMode::Clamp, "_Mask");
}

bool ReAllocateMask(RTHandle& handle, const RenderTextureDescriptor& descriptor)
{
    return ReAllocateIfNeeded(handle, descriptor, FilterMode::Bilinear, TextureWrapMode::Clamp,
                              "_Mask");
}

TEST(RTHandle, IsEmptyUntilItIsAllocated)
{
    const RTHandle handle;
    EXPECT_FALSE(handle);
    EXPECT_TRUE(handle == nullptr);
    EXPECT_EQ(handle.rt(), nullptr);
    EXPECT_TRUE(MaskHandle() != nullptr);
}

TEST(RTHandle, LetsGoOfTheTextureOnRelease)
{
    RTHandle handle = MaskHandle();
    const std::weak_ptr<const RenderTexture> texture = handle.rt();
    handle.Release();
    EXPECT_FALSE(handle);
    EXPECT_TRUE(texture.expired());
}

TEST(RTHandle, LetsGoOfTheTextureWhereItIsSetToNull)
{
    RTHandle handle = MaskHandle();
    const std::weak_ptr<const RenderTexture> texture = handle.rt();
    handle = nullptr;
    EXPECT_TRUE(handle == nullptr);
    EXPECT_TRUE(texture.expired());
    handle = MaskHandle();
    handle = {};
    EXPECT_TRUE(handle == nullptr);
}

TEST(RTHandle, KeepsTheTextureAsLongAsACopyRefersToIt)
{
    RTHandle handle = MaskHandle();
    const RTHandle copy = handle;
    EXPECT_EQ(copy, handle);
    handle.Release();
    EXPECT_EQ(copy.rt()->name(), "_Mask");
}

TEST(RTHandle, AllocatesWhatTheDescriptorSays)
{
    const RTHandle handle = MaskHandle();
    EXPECT_EQ(handle.rt()->descriptor(), k_Mask);
    EXPECT_EQ(handle.rt()->sampler(),
              (SamplerState{FilterMode::Bilinear, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                            TextureWrapMode::Clamp, false}));
    EXPECT_EQ(handle.rt()->name(), "_Mask");
}

TEST(RTHandle, AllocatesPointFilteredAndRepeatingUnlessAskedOtherwise)
{
    const RTHandle handle = RTHandles::Alloc(k_Mask);
    EXPECT_EQ(handle.rt()->sampler(),
              (SamplerState{FilterMode::Point, TextureWrapMode::Repeat, TextureWrapMode::Repeat,
                            TextureWrapMode::Repeat, false}));
}

TEST(RTHandle, IsNotAllocatedWithASizeBelowOne)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] {
                        MaskHandle({0, 540, GraphicsFormat::R8_UNorm});
                    }),
                Mentions("'_Mask'", "0x540", "at least 1"));
}

TEST(ReAllocateIfNeeded, FillsAnEmptyHandle)
{
    RTHandle handle;
    EXPECT_TRUE(ReAllocateMask(handle, k_Mask));
    ASSERT_TRUE(handle);
    EXPECT_EQ(handle.rt()->descriptor(), k_Mask);
    EXPECT_EQ(handle.rt()->name(), "_Mask");
}

TEST(ReAllocateIfNeeded, KeepsATextureThatMatches)
{
    RTHandle handle = MaskHandle();
    const std::uint64_t id = handle.rt()->id();
    EXPECT_FALSE(ReAllocateMask(handle, k_Mask));
    EXPECT_EQ(handle.rt()->id(), id);
}

TEST(ReAllocateIfNeeded, ReplacesATextureForEachFieldThatDiffers)
{
    std::vector<RenderTextureDescriptor> others(5, k_Mask);
    others[0].width = 961;
    others[1].height = 541;
    others[2].graphicsFormat = GraphicsFormat::R8G8B8A8_UNorm;
    others[3].depthBufferBits = 32;
    others[4].msaaSamples = 2;
    for (const RenderTextureDescriptor& other : others)
    {
        RTHandle handle = MaskHandle();
        EXPECT_TRUE(ReAllocateMask(handle, other)) << "field " << &other - others.data();
        RenderTextureDescriptor made = other;
        made.graphicsFormat =
            other.depthBufferBits == 0 ? other.graphicsFormat : GraphicsFormat::None; // depth only
        EXPECT_EQ(handle.rt()->descriptor(), made);
    }
}

TEST(ReAllocateIfNeeded, TakesUnitysArgumentsByNameAndByPlace)
{
    RTHandle handle;
    EXPECT_TRUE(ReAllocateIfNeeded(
        handle, k_Mask,
        {.filterMode = FilterMode::Trilinear, .anisoLevel = 4, .mipMapBias = -1, .name = "_A"}));
    EXPECT_EQ(handle.rt()->name(), "_A");
    EXPECT_EQ(handle.rt()->sampler().anisoLevel, 4);
    EXPECT_EQ(handle.rt()->sampler().mipMapBias, -1.0f);
    EXPECT_EQ(handle.rt()->sampler().wrapModeV, TextureWrapMode::Repeat) << "as Unity's";
    EXPECT_FALSE(ReAllocateIfNeeded(handle, k_Mask, FilterMode::Trilinear, TextureWrapMode::Repeat,
                                    false, 4, -1.0f, "_A"));
    EXPECT_TRUE(
        ReAllocateIfNeeded(handle, k_Mask, FilterMode::Point, TextureWrapMode::Repeat, "_A"))
        << "the name, not isShadowMap";
    EXPECT_EQ(handle.rt()->name(), "_A");
}

TEST(ReAllocateIfNeeded, MakesAShadowMapThatSamplersCompareWith)
{
    RTHandle handle;
    const auto ask = [&]
    {
        return ReAllocateIfNeeded(handle, k_Mask, {.isShadowMap = true, .name = "_Shadows"});
    };
    EXPECT_TRUE(ask());
    EXPECT_EQ(handle.rt()->graphicsFormat(), GraphicsFormat::D32_SFloat);
    EXPECT_TRUE(handle.rt()->sampler().comparison);
    EXPECT_FALSE(ask());
}

TEST(ReAllocateIfNeeded, ReplacesATextureForAnotherFilterWrapModeOrName)
{
    const auto replaces = [](FilterMode filter, TextureWrapMode wrap, const std::string& name)
    {
        RTHandle handle = MaskHandle();
        return ReAllocateIfNeeded(handle, k_Mask, filter, wrap, name);
    };
    EXPECT_FALSE(replaces(FilterMode::Bilinear, TextureWrapMode::Clamp, "_Mask"));
    EXPECT_TRUE(replaces(FilterMode::Point, TextureWrapMode::Clamp, "_Mask"));
    EXPECT_TRUE(replaces(FilterMode::Bilinear, TextureWrapMode::Repeat, "_Mask"));
    EXPECT_TRUE(replaces(FilterMode::Bilinear, TextureWrapMode::Clamp, "_Other"));
}

TEST(ReAllocateIfNeeded, IgnoresTheColourFormatOfADepthTexture)
{
    RTHandle handle = MaskHandle({8, 8, GraphicsFormat::R8_UNorm, 32});
    EXPECT_FALSE(ReAllocateMask(handle, {8, 8, GraphicsFormat::R16G16B16A16_SFloat, 32}));
}

TEST(ReAllocateIfNeeded, MakesAHalfSizeOfASinglePixelOnePixel)
{
    const RenderTextureDescriptor half(1 / 2, 1 / 2, GraphicsFormat::R8_UNorm);
    RTHandle handle;
    EXPECT_TRUE(ReAllocateMask(handle, half));
    EXPECT_EQ(handle.rt()->width(), 1);
    EXPECT_EQ(handle.rt()->height(), 1);
    EXPECT_FALSE(ReAllocateMask(handle, half));
}

TEST(ReAllocateIfNeeded, LeavesTheOldTextureToWhoeverStillHoldsIt)
{
    RTHandle handle = MaskHandle();
    const RTHandle kept = handle;
    ReAllocateMask(handle, {1, 1, GraphicsFormat::R8_UNorm});
    EXPECT_EQ(kept.rt()->width(), 960);
    EXPECT_NE(kept, handle);
}

TEST(ReAllocateIfNeeded, FreesTheTexturesItReplaces)
{
    RTHandle handle;
    std::vector<std::weak_ptr<const RenderTexture>> textures;
    for (int i = 0; i < 100; ++i)
    {
        ReAllocateMask(handle, {1, 1 + i, GraphicsFormat::R8_UNorm});
        textures.push_back(handle.rt());
    }
    const auto alive = std::count_if(textures.begin(), textures.end(),
                                     [](const auto& texture) { return !texture.expired(); });
    EXPECT_EQ(alive, 1);
}

TEST(ReAllocateIfNeeded, KeepsTheTextureWhenTheDescriptorIsWrong)
{
    RTHandle handle = MaskHandle();
    RenderTextureDescriptor wrong = k_Mask;
    wrong.msaaSamples = 3;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { ReAllocateMask(handle, wrong); }),
                Mentions("'_Mask'", "msaaSamples", "3", "1, 2, 4 or 8"));
    EXPECT_EQ(handle.rt()->descriptor(), k_Mask);
}

glm::ivec2 SizeOf(const RTHandle& handle)
{
    return {handle.rt()->width(), handle.rt()->height()};
}

TEST(ScaledHandles, FollowTheCamerasSize)
{
    RTHandles::SetReferenceSize(640, 480);
    const RTHandle half = RTHandles::Alloc(glm::vec2(0.5f, 0.25f), k_Mask, FilterMode::Bilinear,
                                           TextureWrapMode::Clamp, "_Half");
    const RTHandle eighth =
        RTHandles::Alloc([](const glm::ivec2& size) { return size / 8; }, k_Mask);
    EXPECT_TRUE(half && half.useScaling() && eighth.useScaling());
    EXPECT_FALSE(MaskHandle().useScaling());
    EXPECT_EQ(half.scaleFactor(), glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(SizeOf(half), glm::ivec2(320, 120));
    EXPECT_EQ(SizeOf(eighth), glm::ivec2(80, 60));
    const auto first = half.rt();
    EXPECT_EQ(half.rt(), first);
    EXPECT_EQ(first->name(), "_Half");
    EXPECT_EQ(first->graphicsFormat(), k_Mask.graphicsFormat);
    EXPECT_EQ(first->sampler().wrapModeU, TextureWrapMode::Clamp);
    RTHandles::SetReferenceSize(3, 3);
    EXPECT_EQ(SizeOf(half), glm::ivec2(2, 1)) << "1.5 and 0.75 are rounded";
    EXPECT_EQ(SizeOf(eighth), glm::ivec2(1, 1)) << "never less than a texel";
    RTHandles::SetReferenceSize(640, 480);
    EXPECT_EQ(SizeOf(half), glm::ivec2(320, 120));
    EXPECT_EQ(RTHandle(half), half);
}

TEST(ScaledHandles, AreReallocatedWhereTheyHaveToBeOnly)
{
    RTHandles::SetReferenceSize(64, 32);
    RTHandle handle;
    const auto reallocate = [&](float scale, const RenderTextureDescriptor& descriptor)
    {
        return ReAllocateIfNeeded(handle, glm::vec2(scale), descriptor, FilterMode::Bilinear,
                                  TextureWrapMode::Clamp, "_Mask");
    };
    EXPECT_TRUE(reallocate(0.5f, k_Mask));
    EXPECT_FALSE(reallocate(0.5f, k_Mask));
    EXPECT_TRUE(reallocate(1.0f, k_Mask));
    EXPECT_TRUE(reallocate(1.0f, {1, 1, GraphicsFormat::R8G8B8A8_UNorm}));
    EXPECT_FALSE(reallocate(1.0f, {7, 7, GraphicsFormat::R8G8B8A8_UNorm}))
        << "the descriptor's size does not count";
    EXPECT_EQ(SizeOf(handle), glm::ivec2(64, 32));
}

TEST(ScaledHandles, AreRefusedWithoutASize)
{
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([] { RTHandles::Alloc(glm::vec2(1.0f, 0.0f), k_Mask); }),
        Mentions("RTHandles::Alloc", "scale factor is 1, 0;", "greater than 0"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] { RTHandles::Alloc(RTHandles::ScaleFunc(), k_Mask); }),
                Mentions("RTHandles::Alloc", "scale function", "empty"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { RTHandles::SetReferenceSize(0, 1); }),
                Mentions("SetReferenceSize", "0x1", "greater than 0"));
}

TEST(ScaledHandles, TellTheSizeThatTheyHaveForACamera)
{
    RTHandles::Initialize(100, 60);
    RTHandles::ResetReferenceSize(40, 30);
    const RTHandle half = RTHandles::Alloc(glm::vec2(0.5f), {1, 1, GraphicsFormat::R8_UNorm});
    EXPECT_EQ(half.GetScaledSize({21, 9}), glm::ivec2(11, 5)); // 10.5 and 4.5, away from zero
    EXPECT_EQ(RTHandles::Alloc({7, 3, GraphicsFormat::R8_UNorm}).GetScaledSize({21, 9}),
              glm::ivec2(7, 3));
    EXPECT_EQ(RTHandle().GetScaledSize({21, 9}), glm::ivec2(0));
    EXPECT_EQ(RTHandles::maxWidth(), 40);
    EXPECT_EQ(RTHandles::maxHeight(), 30);
    const RTHandleProperties properties = half.rtHandleProperties();
    EXPECT_EQ(properties.previousViewportSize, glm::ivec2(100, 60));
    EXPECT_EQ(properties.currentRenderTargetSize, glm::ivec2(40, 30));
    EXPECT_EQ(properties.rtHandleScale, glm::vec4(1.0f));
    RTHandle released = half;
    RTHandles::Release(released);
    EXPECT_FALSE(released);
}

} // namespace
} // namespace limn
