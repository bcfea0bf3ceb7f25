#include "Mentions.h"
#include "NumericalRun.h"

#include "report/measure/StudyBench.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

namespace limn::study
{
namespace
{

CellId NumericalCell(const std::string& technique, const std::string& shape,
                     const std::string& variant, double width = 4.0)
{
    return {CellKind::Numerical, technique, shape, width, 96, 64, variant};
}

/// How far a technique may be off its twin.
struct Rounding
{
    const char* technique;
    double mean;
    double differing; ///< part of the pixels
};
// Strokes and distances: half floats. Screen space: half a step of 8 bits. Selection: that seven
// times over, and three times as bright. Mask difference: where a pixel's centre lies on an edge,
// five pixels go by it. Jump flood: one pixel of 891 at width 5. The flood
// passes a texel that has two edges at exactly one pixel: the twin keeps the first, and on the
// device, where an offset of 0 comes out of 16 bits with a rounding error, the other is nearer. It
// leads to the right one; the twin's is 0.1 pixels farther.
constexpr Rounding k_Roundings[] = {{"Strokes", 1e-3, 0.005},     {"Separable", 1e-3, 0.0},
                                    {"Jump flood", 1e-3, 0.0012}, {"Screen space", 2e-3, 0.06},
                                    {"Selection", 0.01, 0.6},     {"Mask difference", 0.01, 0.01}};

TEST(NumericalGpu, DrawsWhatTheTwinInDoubleDraws)
{
    StudyBench bench({}, {}, AssetsWithDepth(true), NumericalDevice());
    for (const Rounding& rounding : k_Roundings)
    {
        for (const double width : {2.0, 5.0})
        {
            SCOPED_TRACE(rounding.technique + std::string(", ") + std::to_string(width));
            const CellResult result =
                bench.Measure(NumericalCell(rounding.technique, "star", "", width));
            EXPECT_LE(result.Value("numericalMean"), rounding.mean);
            EXPECT_LE(result.Value("numericalDiffering"), rounding.differing);
        }
    }
}

TEST(NumericalGpu, SaysWhichTechniquesHaveNoTwin)
{
    StudyBench bench({}, {}, AssetsWithDepth(true), NumericalDevice());
    const CellResult result = bench.Measure(NumericalCell("Rim", "disc", ""));
    EXPECT_TRUE(result.values.empty());
    EXPECT_THAT(result.notes, testing::ElementsAre(test::Mentions("no twin", "double precision")));
    EXPECT_THROW(bench.Measure(NumericalCell("Rim", "disc", "thirds")), ContractError);
}

TEST(NumericalGpu, ComparesPicturesOfHalves)
{
    StudyBench bench({}, {}, AssetsWithDepth(true), NumericalDevice());
    if (std::ranges::count(NumericalDevice().missingShaderFeatures(), "native16bit") > 0)
    {
        EXPECT_THAT(bench.Measure(NumericalCell("Strokes", "disc", "half")).notes,
                    testing::ElementsAre(testing::HasSubstr("native16bit")));
        GTEST_SKIP() << "the device reports no shaderInt16 or no shaderFloat16 (native16bit)";
    }
    // All end in textures of 8 or 16 bits, which take a half as it is. Selection goes through 8
    // bits seven times more: each time a half may fall to the other side, by one step, and what
    // comes of it is three times as bright.
    constexpr std::pair<const char*, double> k_Bounds[] = {
        {"Strokes", 0x1p-10}, {"Screen space", 0x1p-10}, {"Selection", 3 * 7 / 255.0}};
    for (const auto& [technique, bound] : k_Bounds)
    {
        SCOPED_TRACE(technique);
        EXPECT_LE(bench.Measure(NumericalCell(technique, "disc", "half")).Value("numericalLargest"),
                  bound);
    }
}

TEST(NumericalGpu, ComparesPicturesOfOtherDepthsAndTargets)
{
    StudyBench bench({}, {}, AssetsWithDepth(true), NumericalDevice());
    for (const char* technique : {"Strokes", "Screen space", "Selection"})
    {
        SCOPED_TRACE(technique);
        // A flat shape has one depth.
        EXPECT_EQ(
            bench.Measure(NumericalCell(technique, "disc", "standard Z")).Value("numericalLargest"),
            0.0);
        // A step of sRGB is largest at white, and Vulkan lets a device take either neighbour.
        const double eight =
            bench.Measure(NumericalCell(technique, "disc", "R8 targets")).Value("numericalLargest");
        EXPECT_GT(eight, 0.5 / 255.0);
        if (technique == std::string("Selection"))
        {
            // Its colour of 3 becomes 1 before it is blended.
            EXPECT_GT(eight, 0.5);
        }
        else
        {
            EXPECT_LE(eight, 2.4 / 1.055 / 255.0 + 0x1p-11);
        }
    }
}

} // namespace
} // namespace limn::study
