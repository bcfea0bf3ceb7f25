#include "report/StudyPlan.h"

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
