#include "report/extremes/Stability.h"

#include "../vulkan/GpuTestDevice.h"
#include "CachedCompiler.h"

#include <gtest/gtest.h>

namespace limn::study
{
namespace
{

std::string Text(const CellResult& result)
{
    std::string text = result.id.Name();
    for (const std::string& note : result.notes)
    {
        text += "\n    " + note;
    }
    return text;
}

/// Why an article's own formula fails in a cell of the sweep that the tests go through.
struct KnownFailure
{
    const char* cell;
    const char* sentence; ///< a part of its note
    const char* reason;
};

constexpr const char* k_Jumps = "the blur's taps lie a seventh of the width apart, and an object "
                                "thinner than that between them";
constexpr const char* k_Cross = "of its four neighbours, so far away, none is on the object: the "
                                "line is the object moved aside";
constexpr const char* k_TooStrong =
    "the blurred colour is multiplied by outlineStrength, 3, and not limited";
const KnownFailure k_Known[] = {
    {"stability/Selection/torus/1/96x64/ratio=1e+09 fov=1 scale=singular samples=4 "
     "view=perspective z=reversed mesh=two-objects",
     "values are outside 0...1", k_TooStrong},
    {"stability/Selection/torus/8/96x64/ratio=1e+08 fov=60 scale=1 samples=1 view=oblique "
     "z=standard mesh=doubled",
     "values are outside 0...1", k_TooStrong},
    {"stability/Selection/torus/64/3x7/ratio=1000 fov=1 scale=1000 samples=1 view=orthographic "
     "z=reversed mesh=open",
     "nothing is drawn", k_Jumps},
    {"stability/Selection/torus/10000/96x64/ratio=100 fov=1 scale=0.001 samples=1 "
     "view=perspective z=reversed mesh=soup",
     "nothing is drawn", k_Jumps},
    {"stability/Mask difference/torus/64/96x64/ratio=1000 fov=60 scale=1 samples=1 "
     "view=perspective z=reversed mesh=tidy",
     "twice the width has 0 pixels", k_Cross},
};

const AssetContext& Assets()
{
    static const AssetContext assets(test::CachedCompiler());
    return assets;
}

/// Small pictures; the sweep's sizes of full screens are the report's.
std::vector<CellId> Plan()
{
    ExtremeLevels levels;
    levels.sizes = {{96, 64}, {1, 1}, {3, 7}};
    return PlanSweep(Assets().features().techniques(), SweepSize::Sampled, levels);
}

class Sweep : public test::GpuTest
{
protected:
    static StabilityStudy& Study()
    {
        static StabilityStudy study(Assets(), test::SharedDevice());
        return study;
    }
};

TEST_F(Sweep, IsSurvivedByOurTechniquesEverywhereAndByTheArticlesButForWhatIsKnown)
{
    std::map<std::string, const KnownFailure*> known;
    int refused = 0;
    int bounded = 0;
    for (const KnownFailure& failure : k_Known)
    {
        known[failure.cell] = &failure;
    }
    for (const CellId& cell : Plan())
    {
        const CellResult result = Study().Measure(cell);
        refused += Text(result).find("refused: ") != std::string::npos ? 1 : 0;
        bounded += result.Has("errorBound") ? 1 : 0;
        const auto expected = known.find(cell.Name());
        if (expected == known.end())
        {
            EXPECT_EQ(result.Value("failures"), 0.0) << Text(result);
            continue;
        }
        EXPECT_TRUE(RequireTechnique(Assets(), cell.technique).isArticle) << Text(result);
        EXPECT_NE(Text(result).find(expected->second->sentence), std::string::npos)
            << Text(result) << "\nwas known to fail: " << expected->second->reason;
        known.erase(expected);
    }
    for (const auto& [cell, failure] : known)
    {
        ADD_FAILURE() << cell << " is not tried any more";
    }
    EXPECT_GE(refused, 24) << "infinite and NaN for twelve techniques";
    EXPECT_GE(bounded, 20) << "widths that a README says something about";
}

TEST_F(Sweep, OfAFullScreenIsAsGoodAsOfASmallPicture)
{
    ExtremeCase extreme;
    extreme.size = {1919, 1079};
    extreme.depthRatio = 1e9;
    extreme.view = ExtremeView::Oblique;
    const CellResult result = Study().Measure(
        {CellKind::Stability, "Strokes", "torus", 8.0, 1919, 1079, extreme.Variant()});
    EXPECT_EQ(result.Value("failures"), 0.0) << Text(result);
    EXPECT_GT(result.Value("bandPixels"), 3000.0);
    EXPECT_LE(result.Value("meanAbsoluteError"), 0.004);
}

// What shards and resumed runs count on.
TEST_F(Sweep, MeasuresACellFromItsNameAlone)
{
    const CellId cell{CellKind::Stability,
                      "Separable",
                      "torus",
                      8.0,
                      96,
                      64,
                      "ratio=1e+05 fov=60 scale=mirrored samples=4 view=oblique z=standard"};
    const CellResult here = Study().Measure(cell);
    const CellResult there = StabilityStudy(Assets(), test::SharedDevice()).Measure(cell);
    EXPECT_EQ(here.values, there.values);
    EXPECT_EQ(here.notes, there.notes);
    EXPECT_GT(here.Value("meanAbsoluteError"), 0.0);
}

TEST_F(Sweep, RefusesCellsThatAreNotItsOwn)
{
    const CellId good{CellKind::Stability, "Strokes", "torus", 8.0, 8, 8, "fov=60"};
    for (const char* variant : {"fov", "fov=wide", "fov=-1", "view=nowhere", "z=up", "half"})
    {
        CellId cell = good;
        cell.variant = variant;
        EXPECT_THROW(Study().Measure(cell), ContractError) << variant;
    }
    CellId unknown = good;
    unknown.technique = "Crayon";
    EXPECT_THROW(Study().Measure(unknown), ContractError);
    CellId cost = good;
    cost.kind = CellKind::Cost;
    EXPECT_THROW(Study().Measure(cost), ContractError);
}

} // namespace
} // namespace limn::study
