#include "report/figures/Pareto.h"
#include "report/pages/SampleStudy.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace limn::test
{

namespace
{

using study::Compare;
using study::ParetoFront;
using study::TimeAndError;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double k_Infinity = std::numeric_limits<double>::infinity();
constexpr double k_NoFigure = std::numeric_limits<double>::quiet_NaN();

std::vector<std::size_t> FrontOf(const std::vector<TimeAndError>& points)
{
    return ParetoFront(points);
}

TEST(ParetoFront, HoldsWhatNothingBeats)
{
    //                      beaten by 2   quickest      between       beaten by 1  least error
    EXPECT_THAT(FrontOf({{3.0, 0.30}, {1.0, 0.90}, {2.0, 0.20}, {5.0, 0.95}, {4.0, 0.05}}),
                ElementsAre(1, 2, 4));
}

TEST(ParetoFront, HoldsASinglePointAndNothingOfNone)
{
    EXPECT_THAT(FrontOf({{3.0, 0.3}}), ElementsAre(0));
    EXPECT_THAT(FrontOf({}), IsEmpty());
}

TEST(ParetoFront, HoldsAllOfEqualPoints)
{
    EXPECT_THAT(FrontOf({{2.0, 0.1}, {1.0, 0.5}, {2.0, 0.1}, {1.0, 0.5}}), ElementsAre(1, 3, 0, 2));
}

TEST(ParetoFront, OfEqualTimesHoldsTheLeastErrorOnly)
{
    EXPECT_THAT(FrontOf({{1.0, 0.5}, {1.0, 0.4}, {1.0, 0.6}}), ElementsAre(1));
}

TEST(ParetoFront, OfEqualErrorsHoldsTheQuickestOnly)
{
    EXPECT_THAT(FrontOf({{2.0, 0.5}, {1.0, 0.5}, {3.0, 0.5}}), ElementsAre(1));
}

TEST(ParetoFront, HoldsNeitherNaNNorInfinity)
{
    EXPECT_THAT(FrontOf({{k_NoFigure, 0.0},
                         {0.0, k_NoFigure},
                         {k_Infinity, 0.0},
                         {0.0, k_Infinity},
                         {-k_Infinity, 0.0},
                         {7.0, 0.7}}),
                ElementsAre(5));
    EXPECT_THAT(FrontOf({{k_NoFigure, k_NoFigure}}), IsEmpty());
}

TEST(ParetoFront, HoldsTimesBelowZeroAsNoiseGivesThem)
{
    EXPECT_THAT(FrontOf({{-0.1, 0.5}, {0.0, 0.0}}), ElementsAre(0, 1));
}

/// By its definition: each point against each other one.
std::vector<std::size_t> FrontByDefinition(const std::vector<TimeAndError>& points)
{
    const auto isFinite = [](const TimeAndError& p)
    {
        return std::isfinite(p.milliseconds) && std::isfinite(p.error);
    };
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        bool isBeaten = !isFinite(points[i]);
        for (const TimeAndError& other : points)
        {
            isBeaten |=
                isFinite(other) && other.milliseconds <= points[i].milliseconds &&
                other.error <= points[i].error &&
                (other.milliseconds < points[i].milliseconds || other.error < points[i].error);
        }
        if (!isBeaten)
        {
            front.push_back(i);
        }
    }
    return front;
}

TEST(ParetoFront, IsWhatItsDefinitionSaysForRandomPoints)
{
    std::mt19937 random(13);
    std::size_t largest = 0;
    for (int round = 0; round < 2000; ++round)
    {
        // Few different figures make ties common; many make the front long.
        const int figures = round % 2 == 0 ? 6 : 1000;
        std::uniform_int_distribution<int> figure(0, figures);
        const auto next = [&]
        {
            const int value = figure(random);
            return value != 0 ? double(value) : round % 3 == 0 ? k_NoFigure : k_Infinity;
        };
        std::vector<TimeAndError> points(static_cast<std::size_t>(round % 40));
        for (TimeAndError& point : points)
        {
            point = {next(), next()};
        }
        const std::vector<std::size_t> front = ParetoFront(points);
        largest = std::max(largest, front.size());
        std::vector<std::size_t> sorted = front;
        std::ranges::sort(sorted);
        ASSERT_EQ(FrontByDefinition(points), sorted);
        for (std::size_t i = 1; i < front.size(); ++i)
        {
            ASSERT_LE(points[front[i - 1]].milliseconds, points[front[i]].milliseconds);
        }
    }
    EXPECT_GE(largest, 5u); // not only trivial ones were tried
}

TEST(Comparison, HasTheFiguresOfEachTechnique)
{
    const study::Study sample = ThreeTechniques();
    const study::Comparison comparison = Compare(sample);
    EXPECT_EQ(8.0, comparison.width);
    EXPECT_EQ(640, comparison.pictureWidth);
    EXPECT_EQ(360, comparison.pictureHeight);
    EXPECT_EQ("scene", comparison.subject);
    ASSERT_EQ(4u, comparison.standings.size());
    EXPECT_EQ(10.0, comparison.standings[0].at.milliseconds);
    EXPECT_EQ(0.001, comparison.standings[0].at.error);
    EXPECT_EQ(std::pair(9.0, 12.0), comparison.standings[0].timeQuartiles);
    EXPECT_TRUE(std::isnan(comparison.standings[3].at.milliseconds));
    EXPECT_TRUE(std::isnan(comparison.standings[3].at.error));
    EXPECT_THAT(comparison.front, ElementsAre(1, 0));
}

TEST(Comparison, TakesTheWidthWithMostTechniquesUnlessOneIsAsked)
{
    study::Study sample = ThreeTechniques();
    AddPoint(sample, "Slow", 64.0, 20.0, 0.002);
    AddPoint(sample, "Quick", 64.0, 2.0, 0.2);
    EXPECT_EQ(8.0, Compare(sample).width);
    const study::Comparison wide = Compare(sample, 64.0);
    EXPECT_EQ(64.0, wide.width);
    EXPECT_EQ(20.0, wide.standings[0].at.milliseconds);
    EXPECT_TRUE(std::isnan(wide.standings[2].at.milliseconds));
}

TEST(Comparison, HasNoFiguresOfUnusualCells)
{
    study::Study sample = ThreeTechniques();
    AddCell(sample, {study::CellKind::Cost, "Bad", "scene", 8.0, 640, 360, "100 objects"},
            {{"gpuAddedMilliseconds", 0.01}});
    AddCell(sample, {study::CellKind::Geometry, "Bad", "scene", 8.0, 640, 360, "half"},
            {{"meanAbsoluteError", 0.0}});
    const study::Comparison comparison = Compare(sample);
    EXPECT_EQ(12.0, comparison.standings[2].at.milliseconds);
    EXPECT_EQ(0.5, comparison.standings[2].at.error);
}

TEST(Comparison, WithoutTheScenesOutlineHasTheMedianOverShapes)
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "A");
    int errors = 0;
    for (const char* shape : {"disc", "bar", "needle"})
    {
        AddCell(sample, {study::CellKind::Geometry, "A", shape, 2.0, 256, 256, ""},
                {{"meanAbsoluteError", ++errors * 0.1}});
    }
    const study::Comparison comparison = Compare(sample);
    EXPECT_EQ("", comparison.subject);
    EXPECT_NEAR(0.2, comparison.standings[0].at.error, 1e-12);
    EXPECT_NEAR(0.15, comparison.standings[0].errorQuartiles.first, 1e-12);
    EXPECT_NEAR(0.25, comparison.standings[0].errorQuartiles.second, 1e-12);
}

TEST(Comparison, CountsStabilityCellsThatFailed)
{
    study::Study sample = ThreeTechniques();
    for (int i = 0; i < 5; ++i)
    {
        AddCell(sample,
                {study::CellKind::Stability, "Quick", "scene", 1.0, 3, 7, std::to_string(i)},
                {{"failures", i < 2 ? 3.0 : 0.0}});
    }
    const study::Comparison comparison = Compare(sample);
    EXPECT_EQ(5u, comparison.standings[1].stabilityCells);
    EXPECT_EQ(2u, comparison.standings[1].failures);
    EXPECT_THAT(study::Recommend(comparison, 2.0).Text(),
                testing::HasSubstr("It failed 2 of 5 stability checks."));
}

} // namespace

} // namespace limn::test
