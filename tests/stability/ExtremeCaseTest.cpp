#include "report/extremes/Stability.h"

#include "ShippedTechniques.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <limn/core/Image.h>
#include <set>
#include <sstream>

namespace limn::study
{
namespace
{

TEST(ExtremeCase, IsReadBackFromTheCellThatItIs)
{
    for (const CellId& cell : PlanSweep(test::ShippedTechniques(), SweepSize::Pairwise))
    {
        const ExtremeCase extreme = ExtremeCase::OfCell(cell);
        EXPECT_EQ(extreme.Variant(), cell.variant);
        EXPECT_EQ(extreme.size, glm::ivec2(cell.pictureWidth, cell.pictureHeight));
    }
}

TEST(PlanSweep, NamesEachCellOnce)
{
    const auto namesOf = [](SweepSize size)
    {
        std::set<std::string> names;
        for (const CellId& cell : PlanSweep(test::ShippedTechniques(), size))
        {
            EXPECT_TRUE(names.insert(cell.Name()).second) << cell.Name();
        }
        return names.size();
    };
    const std::size_t techniques = test::ShippedTechniques().size();
    EXPECT_GE(namesOf(SweepSize::Sampled), 8 * techniques); // a cell for each width at least
    EXPECT_LE(namesOf(SweepSize::Sampled), 12 * techniques);
    EXPECT_GE(namesOf(SweepSize::Pairwise), 64 * techniques);
    EXPECT_LE(namesOf(SweepSize::Pairwise), 80 * techniques);
}

TEST(PlanSweep, HasEveryLevelForEveryTechniqueHoweverFewCells)
{
    const std::vector<CellId> cells = PlanSweep(test::ShippedTechniques(), SweepSize::Sampled);
    for (const Technique& technique : test::ShippedTechniques())
    {
        std::set<std::string> levels;
        for (const CellId& cell : cells)
        {
            if (cell.technique == technique.name)
            {
                std::istringstream variant(cell.variant);
                levels.insert(std::istream_iterator<std::string>(variant), {});
                levels.insert("width=" + std::to_string(cell.width));
                levels.insert("height=" + std::to_string(cell.pictureHeight));
            }
        }
        // 8 ratios, 8 widths, 5 sizes, 3 angles, 7 scales, 2 sample counts, 3 views, 2 directions,
        // 8 kinds of mesh
        EXPECT_EQ(levels.size(), 46u) << technique.name;
    }
}

TEST(PlanSweep, OfAllCombinationsKeepsFullScreensFew)
{
    ExtremeLevels levels;
    levels.depthRatios = {1e2, 1e9};
    levels.widths = {8.0, 64.0};
    levels.meshes = {Untidiness::None};
    const auto cells =
        PlanSweep(std::span(test::ShippedTechniques()).first(1), SweepSize::Full, levels);
    EXPECT_EQ(
        std::ranges::count_if(cells, [](const CellId& cell) { return cell.pictureWidth <= 256; }),
        2 * 2 * 3 * 3 * 7 * 2 * 3 * 2);
    const auto large =
        std::ranges::count_if(cells, [](const CellId& cell) { return cell.pictureWidth > 256; });
    EXPECT_GT(large, 100);
    EXPECT_LT(large, 200);
}

TEST(CountBadValues, CountsWhatNoPictureShouldHave)
{
    Image image;
    image.width = 2;
    image.height = 1;
    image.format = GraphicsFormat::R16G16B16A16_SFloat;
    // 1, NaN, infinity, -infinity; 1.5, -0.5, 0, 1 + 1/1024
    for (const unsigned half : {0x3C00u, 0x7E00u, 0x7C00u, 0xFC00u, 0x3E00u, 0xB800u, 0u, 0x3C01u})
    {
        image.texels.push_back(static_cast<std::byte>(half & 0xFFu));
        image.texels.push_back(static_cast<std::byte>(half >> 8u));
    }
    const BadValues bad = CountBadValues(image);
    EXPECT_EQ(bad.notFinite, 3);
    EXPECT_EQ(bad.outOfRange, 4) << "infinities are outside as well";
}

} // namespace
} // namespace limn::study
