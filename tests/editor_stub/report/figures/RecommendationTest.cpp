#include "Mentions.h"
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
using testing::AllOf;
using testing::Contains;
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

/// Returns what is recommended for this many milliseconds.
std::vector<std::string> SentencesOf(const study::Comparison& comparison, double budget)
{
    std::vector<std::string> sentences{Recommend(comparison, budget).Text()};
    for (std::size_t end; (end = sentences.back().find(". ")) != std::string::npos;)
    {
        const std::string rest = sentences.back().substr(end + 2);
        sentences.back().resize(end + 1);
        sentences.push_back(rest);
    }
    return sentences;
}

TEST(Recommendation, IsASentenceWithItsFigures)
{
    const study::Study sample = ThreeTechniques();
    const study::Comparison comparison = Compare(sample);
    EXPECT_THAT(SentencesOf(comparison, 2.0),
                ElementsAre(Mentions("2 ms", "Quick", "0.1", "1 ± 0.1 ms", "8 px", "640x360"),
                            Mentions("More time", "Slow", "0.001", "10 ± 1 ms")));
    EXPECT_THAT(SentencesOf(comparison, 0.5),
                ElementsAre(Mentions("Nothing fits", "0.5 ms", "Quick", "0.1", "1 ± 0.1 ms", "8 px",
                                     "640x360")));
    EXPECT_THAT(
        SentencesOf(comparison, k_Unlimited),
        ElementsAre(Mentions("all the time", "Slow", "0.001", "10 ± 1 ms", "8 px", "640x360")));
    const study::Comparison nothing;
    EXPECT_THAT(SentencesOf(nothing, 5.0), ElementsAre(Mentions("No technique", "error", "time")));
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
    EXPECT_THAT(SentencesOf(Compare(sample), k_Unlimited),
                ElementsAre(Mentions("all the time", "Slow", "error 0.001", "flicker 0.02",
                                     "10 ± 1 ms", "8 px", "640x360", "flicker of shapes, 2 px")));
}

TEST(Recommendation, SaysWhereItCannotTellWhetherATimeIsWithinTheBudget)
{
    const study::Study sample = ThreeTechniques();
    const study::Comparison comparison = Compare(sample);
    for (const double budget : {9.0, 9.5, 10.999})
    {
        EXPECT_THAT(SentencesOf(comparison, budget),
                    Contains(Mentions("cannot tell", "Slow", "0.001", "10 ± 1 ms")))
            << budget;
    }
    EXPECT_THAT(SentencesOf(comparison, 1.0),
                AllOf(Contains(Mentions("Nothing fits", "1 ms", "Quick")),
                      Contains(Mentions("cannot tell", "Quick", "0.1", "1 ± 0.1 ms"))));
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
        EXPECT_THAT(SentencesOf(comparison, k_Unlimited),
                    ElementsAre(Mentions("time this run knows", "Quick", "0.1", "1 ± 0.1 ms",
                                         "8 px", "640x360"),
                                Mentions("not know", "time", "Slow", "0.001")));
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
    EXPECT_THAT(SentencesOf(Compare(sample), 5.0),
                ElementsAre(Mentions("5 ms", "Steady", "error 0.25", "flicker 0.01",
                                     "1.1 ± 0.11 ms", "4 px", "640x360", "flicker of shapes, 4 px"),
                            Mentions("As good", "Quick", "flicker 0.02")));
}

TEST(Recommendation, WithinABudgetTakesTheLongestThatATimeMayBe)
{
    study::Study sample = ThreeTechniques();
    sample.cells[1].values["gpuAddedUncertainty"] = 10.5; // of Slow's 10 ms
    const study::Comparison comparison = Compare(sample);
    EXPECT_THAT(SentencesOf(comparison, 20.5),
                ElementsAre(Mentions("20.5 ms", "Slow", "0.001", "10 ± 10.5 ms", "at most 20.5 ms",
                                     "8 px", "640x360")));
    EXPECT_THAT(
        SentencesOf(comparison, 20.0),
        Contains(Mentions("cannot tell", "Slow", "0.001", "10 ± 10.5 ms", "at most 20.5 ms")));
    sample.cells[1].values.erase("gpuAddedUncertainty");
    EXPECT_THAT(SentencesOf(Compare(sample), 20.5),
                Contains(Mentions("not know", "time", "Slow", "0.001")));
}

TEST(Recommendation, IsNotMadeWhereNoTimeIsKnown)
{
    study::Study sample = EmptySample();
    AddTechnique(sample, "Quick");
    AddPoint(sample, "Quick", 4.0, -0.25, 0.1);
    for (const double budget : {1.0, k_Unlimited})
    {
        EXPECT_THAT(SentencesOf(Compare(sample), budget),
                    ElementsAre(Mentions("no recommendation", "not know", "time"),
                                Mentions("quieter machine")));
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
    EXPECT_THAT(SentencesOf(comparison, 5.0), Contains(Mentions("As good", ": Near.")));
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
                ElementsAre(Mentions("load changed", "30 ms", "63 %", "180 ms")));
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
                ElementsAre(Mentions("load changed", "1 of 2", "not where")));
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
                ElementsAre(Mentions("Other programs", "1.25", "too long")));
}

TEST(TimeWarnings, NameTimesThatAreNotKnown)
{
    study::Study sample = ThreeTechniques();
    CostsOf(sample)[0]->values["gpuAddedUncertainty"] = 10.5;
    CostsOf(sample)[1]->values.erase("gpuAddedUncertainty");
    EXPECT_THAT(WarningsOf(Compare(sample)),
                ElementsAre(Mentions("not know", "Slow (10 ± 10.5 ms", "at most 20.5 ms",
                                     "Quick (1 ms)", "quieter machine")));
}

} // namespace

} // namespace limn::test
