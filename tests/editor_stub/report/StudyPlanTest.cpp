#include "report/StudyPlan.h"

#include "Mentions.h"
#include "ShippedTechniques.h"

#include <gmock/gmock.h>
#include <set>

namespace limn::study
{
namespace
{

std::set<std::string> NamesOf(const std::vector<CellId>& cells)
{
    std::set<std::string> names;
    for (const CellId& cell : cells)
    {
        names.insert(cell.Name());
    }
    return names;
}

StudyOptions Options(bool isQuick)
{
    StudyOptions options;
    options.isQuick = isQuick;
    options.sceneSize = {1280, 720};
    return options;
}

std::vector<CellId> Plan(const StudyOptions& options)
{
    return PlanStudy(options, test::ShippedTechniques());
}

TEST(StudyPlan, TellsInWordsWhatIsMeasured)
{
    using enum CellKind;
    const CellId cost{Cost, "Strokes", "scene", 4.0, 1280, 720, ""};
    CellId other = cost;
    other.technique = "Inflated";
    EXPECT_THAT(UnitText(std::vector{cost, other}),
                test::Mentions("time", "all techniques", "your scene", "4 pixels", "1280x720"));
    EXPECT_THAT(UnitText(std::vector{CellId{Temporal, "Strokes", "disc", 2.0, 160, 90, ""}}),
                test::Mentions("flicker", "Strokes", "disc", "2 pixels", "160x90"));
    EXPECT_THAT(
        UnitText(std::vector{CellId{Numerical, "Strokes", "star", 4.0, 160, 90, "standard Z"}}),
        test::Mentions("rounding error", "Strokes", "star", "depth from 0", "4 pixels", "160x90"));
    EXPECT_THAT(UnitText(std::vector{CellId{Stability, "Strokes", "torus", 8.0, 96, 64,
                                            "ratio=1e+02 fov=60 scale=mirrored"}}),
                test::Mentions("stability", "Strokes", "extreme settings", "8 pixels", "96x64"));
    EXPECT_THAT(
        UnitText(std::vector{CellId{Cost, "Strokes", "balls", 4.0, 1280, 720, "1 objects"}}),
        test::Mentions("time", "Strokes", "balls", "1 object,", "4 pixels", "1280x720"));
}

TEST(StudyPlan, HasWordsForAllThatItPlans)
{
    StudyOptions options = Options(false);
    options.isPartlyHidden = true;
    for (const auto& unit : UnitsOf(Plan(options)))
    {
        const std::string text = UnitText(unit);
        EXPECT_THAT(text, testing::AnyOf(testing::HasSubstr(" in your scene, "),
                                         testing::HasSubstr(" around a "),
                                         testing::HasSubstr(" around two shapes, "),
                                         testing::HasSubstr(" around balls, ")));
    }
}

TEST(StudyPlan, NamesEachCellOnce)
{
    for (const bool isQuick : {true, false})
    {
        const std::vector<CellId> cells = Plan(Options(isQuick));
        EXPECT_EQ(NamesOf(cells).size(), cells.size());
    }
}

TEST(StudyPlan, ComparesEachTechniqueInTheSceneAndTakesItsTime)
{
    for (const bool isQuick : {true, false})
    {
        const std::set<std::string> names = NamesOf(Plan(Options(isQuick)));
        for (const Technique& technique : test::ShippedTechniques())
        {
            const std::string behind = "/" + technique.name + "/scene/4/1280x720";
            EXPECT_TRUE(names.contains("geometry" + behind)) << behind;
            EXPECT_TRUE(names.contains("cost" + behind)) << behind;
        }
    }
}

TEST(StudyPlan, TakesTheTechniquesThatAreAskedFor)
{
    StudyOptions options = Options(true);
    options.techniques = {"Strokes", "Rim"};
    std::set<std::string> techniques;
    for (const CellId& cell : Plan(options))
    {
        techniques.insert(cell.technique);
    }
    EXPECT_THAT(techniques, testing::ElementsAre("Rim", "Strokes"));
    EXPECT_NE(options.Text(), Options(true).Text()) << "another study";
}

TEST(StudyPlan, HoldsStrokesToBothPartsOfAnOutlineThatIsPartlyHidden)
{
    StudyOptions options = Options(true);
    const std::string both[] = {"geometry/Strokes/scene/4/1280x720/seen part",
                                "geometry/Strokes/scene/4/1280x720/hidden part"};
    const std::set<std::string> without = NamesOf(Plan(options));
    options.isPartlyHidden = true;
    std::set<std::string> names = NamesOf(Plan(options));
    EXPECT_NE(options.Text(), Options(true).Text()) << "another study";
    for (const std::string& name : both)
    {
        EXPECT_FALSE(without.contains(name));
        EXPECT_EQ(names.erase(name), 1u);
    }
    EXPECT_EQ(names, without);
    options.techniques = {"Rim"};
    EXPECT_FALSE(NamesOf(Plan(options)).contains(both[0]));
}

TEST(StudyPlan, MeasuresCostsOfAllTechniquesTogetherAndAllElseAlone)
{
    const std::vector<CellId> cells = Plan(Options(true));
    std::vector<CellId> again;
    std::size_t costs = 0;
    for (const std::vector<CellId>& unit : UnitsOf(cells))
    {
        again.insert(again.end(), unit.begin(), unit.end());
        if (unit.front().kind == CellKind::Cost)
        {
            ++costs;
            EXPECT_EQ(unit.size(), test::ShippedTechniques().size());
        }
        else
        {
            EXPECT_EQ(unit.size(), 1u);
        }
    }
    EXPECT_EQ(costs, 1u);
    EXPECT_EQ(NamesOf(again), NamesOf(cells));
}

} // namespace
} // namespace limn::study
