#include "stability/FormulaTable.h"

#include "../vulkan/GpuTestDevice.h"

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
    AssetContext assets;
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

} // namespace
} // namespace limn::study
