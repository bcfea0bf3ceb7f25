#include "report/figures/Pareto.h"
#include "report/pages/SampleStudy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

using study::Compare;
using study::Recommend;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double k_Unlimited = std::numeric_limits<double>::infinity();

TEST(Recommendation, IsTheLeastErrorWithinTheBudget)
{
    const study::Study sample = ThreeTechniques();
    const study::Comparison comparison = Compare(sample);
    const auto nameFor = [&](double budget)
    {
        const study::Recommendation result = Recommend(comparison, budget);
        return result.standing == nullptr ? "" : result.standing->technique->name;
    };
    EXPECT_EQ("", nameFor(1.099)) << "1 ± 0.1 ms may be more";
    EXPECT_EQ("Quick", nameFor(1.1));
    EXPECT_EQ("Quick", nameFor(10.999));
    EXPECT_EQ("Slow", nameFor(11.0));
    EXPECT_EQ("Slow", nameFor(k_Unlimited));
    EXPECT_EQ("", nameFor(std::numeric_limits<double>::quiet_NaN()));
}

TEST(Recommendation, IsASentenceWithItsFigures)
{
    const study::Study sample = ThreeTechniques();
    const study::Comparison comparison = Compare(sample);
    EXPECT_EQ("Within 2 ms take Quick: mean error 0.1 for 1 ± 0.1 ms (8 px wide, in a picture of "
              "640x360). More time buys less error: Slow has mean error 0.001 for 10 ± 1 ms.",
              Recommend(comparison, 2.0).Text());
    EXPECT_EQ("Nothing fits 0.5 ms for certain: the quickest outline is Quick with mean error 0.1 "
              "for 1 ± 0.1 ms (8 px wide, in a picture of 640x360).",
              Recommend(comparison, 0.5).Text());
    EXPECT_EQ("With all the time there is take Slow: mean error 0.001 for 10 ± 1 ms (8 px wide, in "
              "a picture of 640x360).",
              Recommend(comparison, k_Unlimited).Text());
    const study::Comparison nothing;
    EXPECT_EQ("No technique has both an error and a time to choose by.",
              Recommend(nothing, 5.0).Text());
}

TEST(Recommendation, NamesTheFlickerAndTheWidthItIsOf)
{
    study::Study sample = ThreeTechniques();
    for (const auto& [shape, flicker] : {std::pair("disc", 0.01), std::pair("needle", 0.03)})
    {
        AddCell(sample, {study::CellKind::Temporal, "Slow", shape, 2.0, 160, 90, ""},
                {{"flicker", flicker}});
    }
    AddCell(sample, {study::CellKind::Temporal, "Slow", "disc", 32.0, 160, 90, ""},
            {{"flicker", 0.5}});
    EXPECT_EQ("With all the time there is take Slow: mean error 0.001 and flicker 0.02 for 10 ± 1 "
              "ms (8 px wide, in a picture of 640x360; flicker of shapes, 2 px wide).",
              Recommend(Compare(sample), k_Unlimited).Text());
}

TEST(Recommendation, SaysWhereItCannotTellWhetherATimeIsWithinTheBudget)
{
    const study::Study sample = ThreeTechniques();
    const study::Comparison comparison = Compare(sample);
    for (const double budget : {9.0, 9.5, 10.999})
    {
        EXPECT_THAT(Recommend(comparison, budget).Text(),
                    testing::EndsWith(" This run cannot tell whether these fit: Slow (mean error "
                                      "0.001 for 10 ± 1 ms)."))
            << budget;
    }
    EXPECT_THAT(Recommend(comparison, 1.0).Text(),
                HasSubstr("Nothing fits 1 ms for certain: the quickest outline is Quick"));
    EXPECT_THAT(Recommend(comparison, 1.0).Text(),
                HasSubstr("This run cannot tell whether these fit: Quick (mean error 0.1 for 1 ± "
                          "0.1 ms)."));
}

TEST(Recommendation, IsNotOfATimeThatMayBeZeroOrHasNoBound)
{
    study::Study sample = ThreeTechniques();
    for (const bool isBounded : {true, false})
    {
        study::CellResult& slow = sample.cells[1];
        ASSERT_EQ(10.0, slow.Value("gpuAddedMilliseconds"));
        slow.values["gpuAddedUncertainty"] = 10.0;
        if (!isBounded)
        {
            slow.values.erase("gpuAddedUncertainty");
        }
        const study::Comparison comparison = Compare(sample);
        EXPECT_THAT(comparison.front, ElementsAre(1));
        EXPECT_EQ(
            "Of those whose time this run knows take Quick: mean error 0.1 for 1 ± 0.1 ms "
            "(8 px wide, in a picture of 640x360). This run does not know the time of Slow (mean "
            "error 0.001).",
            Recommend(comparison, k_Unlimited).Text());
    }
}

TEST(Recommendation, OfWhatTimesDoNotTellApartFlickersLeast)
{
    study::Study sample = EmptySample();
    double flicker = 0.04;
    for (const auto& [name, time] :
         {std::pair("Quick", 1.0), std::pair("Steady", 1.1), std::pair("Slow", 2.0)})
    {
        AddTechnique(sample, name);
        AddPoint(sample, name, 4.0, time, 0.25);
        AddCell(sample, {study::CellKind::Temporal, name, "disc", 4.0, 160, 90, ""},
                {{"flicker", flicker /= 2.0}});
    }
    EXPECT_EQ("Within 5 ms take Steady: mean error 0.25 and flicker 0.01 for 1.1 ± 0.11 ms (4 px "
              "wide, in a picture of 640x360; flicker of shapes, 4 px wide). As good, as far as "
              "the times tell: Quick (flicker 0.02).",
              Recommend(Compare(sample), 5.0).Text());
}

TEST(Recommendation, WithinABudgetTakesTheLongestThatATimeMayBe)
{
    study::Study sample = ThreeTechniques();
    sample.cells[1].values["gpuAddedUncertainty"] = 10.5; // of Slow's 10 ms
    const study::Comparison comparison = Compare(sample);
    EXPECT_EQ(
        "Within 20.5 ms take Slow: mean error 0.001 for 10 ± 10.5 ms, so at most 20.5 ms (8 px "
        "wide, in a picture of 640x360).",
        Recommend(comparison, 20.5).Text());
    EXPECT_THAT(Recommend(comparison, 20.0).Text(),
                testing::EndsWith("This run cannot tell whether these fit: Slow (mean error 0.001 "
                                  "for 10 ± 10.5 ms, so at most 20.5 ms)."));
    sample.cells[1].values.erase("gpuAddedUncertainty");
    EXPECT_THAT(Recommend(Compare(sample), 20.5).Text(),
                testing::EndsWith("This run does not know the time of Slow (mean error 0.001)."));
}

TEST(Recommendation, IsNotMadeWhereNoTimeIsKnown)
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "Quick");
    AddPoint(sample, "Quick", 4.0, -0.25, 0.1);
    for (const double budget : {1.0, k_Unlimited})
    {
        EXPECT_EQ("There is no recommendation: this run does not know the time of any technique. "
                  "Measure again on a quieter machine.",
                  Recommend(Compare(sample), budget).Text());
    }
}

TEST(Recommendation, OfEqualErrorsIsTheQuickest)
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "Slower");
    AddTechnique(sample, "Quicker");
    AddPoint(sample, "Slower", 4.0, 2.0, 0.25);
    AddPoint(sample, "Quicker", 4.0, 1.0, 0.25);
    EXPECT_EQ("Quicker", Recommend(Compare(sample), 5.0).standing->technique->name);
}

TEST(Recommendation, NamesWhatIsAsGoodAsFarAsTheTimesTell)
{
    study::Study sample = EmptySample();
    for (const char* name : {"Chosen", "Near", "Slow", "Worse"})
    {
        AddTechnique(sample, name);
    }
    AddPoint(sample, "Chosen", 4.0, 1.0, 0.25); // up to 1.1 ms
    AddPoint(sample, "Near", 4.0, 1.2, 0.251);  // 1.08 to 1.32 ms
    AddPoint(sample, "Slow", 4.0, 1.3, 0.25);   // from 1.17 ms
    AddPoint(sample, "Worse", 4.0, 1.1, 0.26);
    const study::Comparison comparison = Compare(sample);
    const std::string sentence = " As good, as far as the times tell: Near.";
    EXPECT_THAT(Recommend(comparison, 5.0).Text(), testing::EndsWith(sentence));
    EXPECT_THAT(Recommend(comparison, 1.25).Text(), testing::Not(HasSubstr("As good")));
}

/// The cells of cost of a study.
std::vector<study::CellResult*> CostsOf(study::Study& sample)
{
    std::vector<study::CellResult*> costs;
    for (study::CellResult& cell : sample.cells)
    {
        if (cell.id.kind == study::CellKind::Cost)
        {
            costs.push_back(&cell);
        }
    }
    return costs;
}

TEST(TimeWarnings, SayThatTheLoadChanged)
{
    study::Study sample = ThreeTechniques();
    EXPECT_THAT(WarningsOf(Compare(sample)), IsEmpty());
    for (study::CellResult* cell : CostsOf(sample))
    {
        cell->values["quietPart"] = 0.625;
        cell->values["busyMilliseconds"] = 180.0;
    }
    EXPECT_THAT(WarningsOf(Compare(sample)),
                ElementsAre("The load changed during this run: the frame without an outline took "
                            "30 ms in 63 % of it and up to 180 ms in the rest, which counts for "
                            "nothing."));
}

TEST(TimeWarnings, SayThatTheLoadChangedElsewhere)
{
    study::Study sample = ThreeTechniques();
    for (const char* technique : {"Slow", "Quick"})
    {
        AddCell(sample, {study::CellKind::Cost, technique, "balls", 8.0, 640, 360, "9 objects"},
                {{"gpuAddedMilliseconds", 1.0}, {"quietMilliseconds", 30.0}, {"quietPart", 0.5}});
    }
    EXPECT_THAT(WarningsOf(Compare(sample)),
                ElementsAre("The load changed during 1 of 2 measurements of time; not where "
                            "techniques are compared."));
}

TEST(TimeWarnings, SayThatOtherProgramsRan)
{
    study::Study sample = ThreeTechniques();
    CostsOf(sample)[1]->values["otherPrograms"] = 0.15; // a system's own
    EXPECT_THAT(WarningsOf(Compare(sample)), IsEmpty());
    for (study::CellResult* cell : CostsOf(sample))
    {
        cell->values["otherPrograms"] = 1.25;
    }
    EXPECT_THAT(WarningsOf(Compare(sample)),
                ElementsAre("Other programs kept busy 1.25 of the machine's processors during this "
                            "run: all of its times may be too long, which their ± does not hold."));
}

TEST(TimeWarnings, NameTimesThatAreNotKnown)
{
    study::Study sample = ThreeTechniques();
    CostsOf(sample)[0]->values["gpuAddedUncertainty"] = 10.5;
    CostsOf(sample)[1]->values.erase("gpuAddedUncertainty");
    EXPECT_THAT(WarningsOf(Compare(sample)),
                ElementsAre("This run does not know these times, of which 0 is within the bound or "
                            "for which too little of it was quiet: Slow (10 ± 10.5 ms, so at most "
                            "20.5 ms), Quick (1 ms). Measure again on a quieter machine before "
                            "choosing by them."));
}

} // namespace

} // namespace limn::test
