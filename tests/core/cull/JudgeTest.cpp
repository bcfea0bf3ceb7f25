#include <gtest/gtest.h>
#include <limn/core/Judge.h>
#include <random>
#include <vector>

#include "Mentions.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::Mentions;

struct Range
{
    RenderQueueRange range;
    int lowest;
    int highest;
};

/// The three rules as Unity's manual states them, in plain arithmetic.
bool Passes(int queue, const Range& range, int layer, std::uint32_t layerMask,
            std::uint32_t objectMask, std::uint32_t filterMask)
{
    std::uint32_t shifted = layerMask;
    for (int i = 0; i < layer; ++i)
    {
        shifted /= 2;
    }
    const bool queueFits = range.lowest <= queue && queue <= range.highest;
    const bool layerFits = shifted % 2 == 1;
    const bool renderingLayerFits = (objectMask & filterMask) != 0;
    return queueFits && layerFits && renderingLayerFits;
}

const std::vector<Range>& Ranges()
{
    static const std::vector<Range> ranges{{RenderQueueRange::all, 0, 5000},
                                           {RenderQueueRange::opaque, 0, 2500},
                                           {RenderQueueRange::transparent, 2501, 5000},
                                           {RenderQueueRange(2449, 2450), 2449, 2450}};
    return ranges;
}

/// Judges with a shader that always has the wanted pass.
class JudgeMatrix : public testing::Test
{
protected:
    JudgeMatrix() { m_Drawing.shaderTagIds = {ShaderTagId("UniversalForward")}; }

    void ExpectAgreement(int queue, const Range& range, int layer, std::uint32_t layerMask,
                         std::uint32_t objectMask, std::uint32_t filterMask)
    {
        const FilterItem item{queue, layer, RenderingLayerMask(objectMask), m_Shader.get()};
        const FilteringSettings filtering(range.range, LayerMask(layerMask),
                                          RenderingLayerMask(filterMask));
        const bool drawn = Judge(item, filtering, m_Drawing) == FilterVerdict::Drawn;
        EXPECT_EQ(drawn, Passes(queue, range, layer, layerMask, objectMask, filterMask))
            << "queue " << queue << " in " << range.lowest << "..." << range.highest << ", layer "
            << layer << " in " << layerMask << ", rendering layers " << objectMask << " in "
            << filterMask;
    }

    std::shared_ptr<const Shader> m_Shader = test::ShaderWithModes({"UniversalForward"});
    DrawingSettings m_Drawing;
};

TEST_F(JudgeMatrix, AgreesWithThreePlainComparisonsOnEveryCombination)
{
    const std::vector<std::uint32_t> layerMasks{0u, ~0u, 1u, 1u << 6, 1u << 31, 0x80000041u, ~1u};
    const std::vector<std::uint32_t> objectMasks{0u, ~0u, 1u, 1u << 3, 1u << 31};
    const std::vector<std::uint32_t> filterMasks{0u, ~0u, 1u, 1u << 3, 0x80000008u};
    for (const int queue : {0, 1000, 2449, 2450, 2500, 2501, 3000, 5000})
    {
        for (const Range& range : Ranges())
        {
            for (const int layer : {0, 6, 31})
            {
                for (const std::uint32_t layerMask : layerMasks)
                {
                    for (const std::uint32_t objectMask : objectMasks)
                    {
                        for (const std::uint32_t filterMask : filterMasks)
                        {
                            ExpectAgreement(queue, range, layer, layerMask, objectMask, filterMask);
                        }
                    }
                }
            }
        }
    }
}

TEST_F(JudgeMatrix, AgreesWithThreePlainComparisonsOnRandomCombinations)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto number = [&](int low, int high)
    {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    // Sparse masks, so that both verdicts are common.
    const auto mask = [&]
    {
        return static_cast<std::uint32_t>(random() & random() & random());
    };
    for (int i = 0; i < 20000; ++i)
    {
        const int a = number(0, 5000);
        const int b = number(0, 5000);
        const Range range{RenderQueueRange(std::min(a, b), std::max(a, b)), std::min(a, b),
                          std::max(a, b)};
        ExpectAgreement(number(0, 5000), range, number(0, 31), mask() | mask(), mask(), mask());
    }
}

TEST(Judge, NamesTheFirstRuleThatRejects)
{
    const auto shader = test::ShaderWithModes({"Other"});
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
    const FilteringSettings filtering(RenderQueueRange::opaque, LayerMask::FromIndex(6),
                                      RenderingLayerMask::FromIndex(3));
    FilterItem item{3000, 0, RenderingLayerMask(1), shader.get()};
    EXPECT_EQ(Judge(item, filtering, drawing), FilterVerdict::QueueOutOfRange);
    item.renderQueue = 2000;
    EXPECT_EQ(Judge(item, filtering, drawing), FilterVerdict::LayerMaskMiss);
    item.layer = 6;
    EXPECT_EQ(Judge(item, filtering, drawing), FilterVerdict::RenderingLayerMaskMiss);
    item.renderingLayerMask = RenderingLayerMask(8);
    EXPECT_EQ(Judge(item, filtering, drawing), FilterVerdict::NoMatchingPass);
    drawing.shaderTagIds.push_back(ShaderTagId("Other"));
    EXPECT_EQ(Judge(item, filtering, drawing), FilterVerdict::Drawn);
}

TEST(Judge, DrawsNothingWithoutAnyTag)
{
    const auto shader = test::ShaderWithModes({"UniversalForward"});
    const FilterItem item{2000, 0, RenderingLayerMask(1), shader.get()};
    EXPECT_EQ(Judge(item, FilteringSettings(), DrawingSettings()), FilterVerdict::NoMatchingPass);
}

TEST(Judge, LeavesANewRendererOutOfAllRenderingLayersButTheFirst)
{
    const auto shader = test::ShaderWithModes({"UniversalForward"});
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
    const MeshRenderer renderer;
    const FilterItem item{2000, 0, renderer.renderingLayerMask, shader.get()};
    FilteringSettings filtering;
    filtering.renderingLayerMask = RenderingLayerMask::FromIndex(3);
    EXPECT_EQ(Judge(item, filtering, drawing), FilterVerdict::RenderingLayerMaskMiss);
    filtering.renderingLayerMask = RenderingLayerMask::FromIndex(0);
    EXPECT_EQ(Judge(item, filtering, drawing), FilterVerdict::Drawn);
}

constexpr bool JudgesAtCompileTime()
{
    const FilteringSettings filtering(RenderQueueRange::opaque, LayerMask::FromIndex(2));
    return JudgeMasks({2000, 2}, filtering) == FilterVerdict::Drawn &&
           JudgeMasks({2000, 1}, filtering) == FilterVerdict::LayerMaskMiss &&
           JudgeMasks({2501, 2}, filtering) == FilterVerdict::QueueOutOfRange;
}
static_assert(JudgesAtCompileTime());

TEST(Describe, CountsWhatEachRuleLeftOut)
{
    EXPECT_THAT(
        Describe({0, 13, 201, 0, 0}, FilteringSettings()),
        Mentions("0 of 214", "render queue range leaves out 13", "layer mask leaves out 201"));
    EXPECT_THAT(Describe({1, 0, 0, 2, 4}, FilteringSettings()),
                Mentions("1 of 7 renderers is drawn", "rendering layer mask leaves out 2",
                         "4 have no pass", "LightMode"));
    EXPECT_EQ(Describe({3, 0, 0, 0, 0}, FilteringSettings()), "3 of 3 renderers are drawn");
    EXPECT_EQ(Describe({0, 1, 0, 0, 0}, FilteringSettings()),
              "0 of 1 renderer is drawn: the render queue range leaves out 1");
}

TEST(Describe, SaysThatThereIsNothingToFilter)
{
    EXPECT_THAT(Describe({}, FilteringSettings()), Mentions("0 of 0", "camera", "no renderer"));
}

TEST(Describe, PointsOutAnEmptyMask)
{
    EXPECT_THAT(
        Describe({0, 0, 5, 0, 0}, FilteringSettings(RenderQueueRange::all, LayerMask::Nothing())),
        Mentions("0 of 5", "layer mask leaves out 5", "layerMask is 0"));
    EXPECT_THAT(
        Describe({0, 0, 0, 5, 0}, FilteringSettings(RenderQueueRange::all, LayerMask::Everything(),
                                                    RenderingLayerMask::Nothing())),
        Mentions("0 of 5", "rendering layer mask leaves out 5", "renderingLayerMask is 0"));
}

} // namespace
} // namespace limn
