#include "report/extremes/Stability.h"

#include "../vulkan/GpuTestDevice.h"
#include "CachedCompiler.h"

#include <gtest/gtest.h>
#include <set>

namespace limn::study
{
namespace
{

class FormulaTable : public test::GpuTest
{
};

TEST_F(FormulaTable, HasOursRightInEveryCellAndTheArticlesInThoseThatItIsKnownFor)
{
    AssetContext assets(test::CachedCompiler());
    const std::vector<FormulaCell> cells = EvaluateFormulas(assets, test::SharedDevice());
    const bool isLavapipe = test::SharedDevice().deviceName().find("llvmpipe") != std::string::npos;
    std::set<std::string> failing;
    for (const FormulaCell& cell : cells)
    {
        SCOPED_TRACE(cell.formula + ", " + cell.input);
        EXPECT_TRUE(cell.IsGood(cell.ours)) << cell.ours << " for " << cell.meant;
        if (isLavapipe) // other devices make what they like of what is undefined
        {
            EXPECT_EQ(cell.IsGood(cell.article), cell.articleHolds)
                << cell.article << " for " << cell.meant;
        }
        EXPECT_FALSE(cell.reason.empty());
        if (!cell.articleHolds)
        {
            failing.insert(cell.formula);
        }
    }
    EXPECT_EQ(failing.size(), 11u) << "every row has an input that the article's fails for";
}

TEST_F(FormulaTable, IsAPartOfTheStabilityCells)
{
    const std::vector<CellId> cells = PlanStability({}, SweepSize::Pairwise);
    ASSERT_EQ(cells.size(), Formulas().size());
    const AssetContext assets(test::CachedCompiler());
    StabilityStudy study(assets, test::SharedDevice());
    const CellResult negative = study.Measure(cells[1]);
    EXPECT_EQ(negative.id.Name(), "stability/Formulas/pow(x, y), y = 2/0/1x1/x = -0.5");
    EXPECT_EQ(negative.Value("formulaMeant"), 0.25);
    EXPECT_EQ(negative.Value("formulaOurs"), 0.25);
    EXPECT_EQ(negative.Value("failures"), 0.0);
    CellId unknown = cells[1];
    unknown.variant = "x = 7";
    EXPECT_THROW(study.Measure(unknown), ContractError);
}

} // namespace
} // namespace limn::study
