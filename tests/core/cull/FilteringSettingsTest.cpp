#include <gtest/gtest.h>
#include <limn/core/DrawingSettings.h>
#include <limn/core/FilteringSettings.h>
#include <type_traits>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

// A mask is no number and no other kind of mask: swapping arguments does not compile.
static_assert(!std::is_convertible_v<int, LayerMask>);
static_assert(!std::is_convertible_v<std::uint32_t, LayerMask>);
static_assert(!std::is_convertible_v<int, RenderingLayerMask>);
static_assert(!std::is_convertible_v<LayerMask, int>);
static_assert(!std::is_convertible_v<LayerMask, bool>);
static_assert(!std::is_convertible_v<LayerMask, RenderingLayerMask>);
static_assert(!std::is_constructible_v<LayerMask, RenderingLayerMask>);
static_assert(!std::is_constructible_v<RenderingLayerMask, LayerMask>);
static_assert(!std::is_assignable_v<LayerMask&, RenderingLayerMask>);
static_assert(
    !std::is_constructible_v<FilteringSettings, RenderQueueRange, RenderingLayerMask, LayerMask>);

template <typename Mask>
class Masks : public testing::Test
{
};
using MaskTypes = testing::Types<LayerMask, RenderingLayerMask>;
TYPED_TEST_SUITE(Masks, MaskTypes);

TYPED_TEST(Masks, SetTheBitOfEachIndex)
{
    std::uint32_t expected = 1;
    for (int index = 0; index < 32; ++index, expected *= 2)
    {
        EXPECT_EQ(TypeParam::FromIndex(index).bits, expected) << "index " << index;
    }
}

TYPED_TEST(Masks, AreNothingByDefault)
{
    EXPECT_EQ(TypeParam().bits, 0u);
    EXPECT_EQ(TypeParam(), TypeParam::Nothing());
    EXPECT_EQ(TypeParam::Everything().bits, 4294967295u);
}

TYPED_TEST(Masks, CombineBitByBit)
{
    EXPECT_EQ((TypeParam(12) | TypeParam(10)).bits, 14u);
    EXPECT_EQ((TypeParam(12) & TypeParam(10)).bits, 8u);
    EXPECT_EQ((~TypeParam(12)).bits, 4294967283u);
    EXPECT_TRUE(TypeParam(12).Intersects(TypeParam(10)));
    EXPECT_FALSE(TypeParam(12).Intersects(TypeParam(3)));
}

TEST(LayerMask, RefusesAnIndexThatIsNoBit)
{
    EXPECT_EQ(test::ThrownMessage<ContractError>([] { LayerMask::FromIndex(32); }),
              "layer index 32 is outside 0...31");
    EXPECT_EQ(test::ThrownMessage<ContractError>([] { LayerMask::FromIndex(-1); }),
              "layer index -1 is outside 0...31");
}

TEST(RenderingLayerMask, RefusesAnIndexThatIsNoBit)
{
    EXPECT_EQ(test::ThrownMessage<ContractError>([] { RenderingLayerMask::FromIndex(32); }),
              "rendering layer index 32 is outside 0...31");
    EXPECT_EQ(test::ThrownMessage<ContractError>([] { RenderingLayerMask::FromIndex(-1); }),
              "rendering layer index -1 is outside 0...31");
}

TEST(RenderQueueRange, IncludesBothEnds)
{
    const RenderQueueRange range(2450, 2501);
    EXPECT_FALSE(range.Contains(2449));
    EXPECT_TRUE(range.Contains(2450));
    EXPECT_TRUE(range.Contains(2501));
    EXPECT_FALSE(range.Contains(2502));
}

TEST(RenderQueueRange, DividesOpaqueFromTransparentBehind2500)
{
    EXPECT_TRUE(RenderQueueRange::opaque.Contains(2500));
    EXPECT_FALSE(RenderQueueRange::opaque.Contains(2501));
    EXPECT_FALSE(RenderQueueRange::transparent.Contains(2500));
    EXPECT_TRUE(RenderQueueRange::transparent.Contains(2501));
    EXPECT_EQ(RenderQueueRange::all, RenderQueueRange(0, 5000));
}

TEST(RenderQueueRange, RefusesBoundsThatNoQueueCanHave)
{
    EXPECT_EQ(test::ThrownMessage<ContractError>([] { RenderQueueRange(-1, 5000); }),
              "render queue bound -1 is outside 0...5000");
    EXPECT_EQ(test::ThrownMessage<ContractError>([] { RenderQueueRange(0, 5001); }),
              "render queue bound 5001 is outside 0...5000");
}

TEST(FilteringSettings, TakeEverythingByDefault)
{
    const FilteringSettings settings;
    EXPECT_EQ(settings.renderQueueRange, RenderQueueRange(0, 5000));
    EXPECT_EQ(settings.layerMask.bits, 4294967295u);
    EXPECT_EQ(settings.renderingLayerMask.bits, 4294967295u);
    EXPECT_EQ(settings, FilteringSettings(RenderQueueRange::all));
}

TEST(FilteringSettings, DifferInEachField)
{
    const FilteringSettings settings;
    FilteringSettings queues = settings;
    queues.renderQueueRange = RenderQueueRange::opaque;
    FilteringSettings layers = settings;
    layers.layerMask = LayerMask(1);
    FilteringSettings renderingLayers = settings;
    renderingLayers.renderingLayerMask = RenderingLayerMask(1);
    EXPECT_NE(settings, queues);
    EXPECT_NE(settings, layers);
    EXPECT_NE(settings, renderingLayers);
}

TEST(DrawingSettings, HoldAsManyPassNamesAsUnity)
{
    DrawingSettings settings;
    settings.SetShaderPassName(15, ShaderTagId("Last"));
    ASSERT_EQ(settings.shaderTagIds.size(), 16u);
    EXPECT_EQ(settings.shaderTagIds[15].name(), "Last");
    EXPECT_EQ(settings.shaderTagIds[0].name(), "");
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { settings.SetShaderPassName(16, ShaderTagId("TooMany")); }),
                test::Mentions("pass name", "16", "0...15"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { settings.SetShaderPassName(-1, ShaderTagId("Before")); }),
                test::Mentions("pass name", "-1", "0...15"));
}

} // namespace
TEST(FilteringSettings, TakesNullForAllQueuesAsUnityDoes)
{
    EXPECT_EQ(FilteringSettings(nullptr, LayerMask(2)),
              FilteringSettings(RenderQueueRange::all, LayerMask(2)));
    const std::optional<RenderQueueRange> none;
    EXPECT_EQ(FilteringSettings(none), FilteringSettings());
    EXPECT_EQ(FilteringSettings(RenderQueueRange::opaque).renderQueueRange,
              RenderQueueRange::opaque);
}

} // namespace limn
