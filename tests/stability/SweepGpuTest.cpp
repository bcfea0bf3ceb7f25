#include "stability/Stability.h"

#include "../vulkan/GpuTestDevice.h"
#include "TemporaryFolder.h"

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

const KnownFailure k_Known[] = {
    {"", "", ""},
};

/// Small pictures; the sweep's sizes of full screens are the report's.
std::vector<CellId> Plan()
{
    ExtremeLevels levels;
    levels.sizes = {{96, 64}, {1, 1}, {3, 7}};
    return PlanStability(Techniques(), SweepSize::Sampled, levels);
}

class Sweep : public test::GpuTest
{
protected:
    static StabilityStudy& Study()
    {
        static const test::TemporaryFolder cache;
        static StabilityStudy study({.cacheFolder = cache.path()}, test::SharedDevice());
        return study;
    }
};

TEST_F(Sweep, IsSurvivedByOurTechniquesEverywhereAndByTheArticlesButForWhatIsKnown)
{
    std::map<std::string, const KnownFailure*> known;
    for (const KnownFailure& failure : k_Known)
    {
        known[failure.cell] = &failure;
    }
    for (const CellId& cell : Plan())
    {
        const CellResult result = Study().Measure(cell);
        const auto expected = known.find(cell.Name());
        if (expected == known.end())
        {
            EXPECT_EQ(result.Value("failures"), 0.0) << Text(result);
            continue;
        }
        EXPECT_TRUE(FindTechnique(cell.technique)->info.isArticle) << Text(result);
        EXPECT_NE(Text(result).find(expected->second->sentence), std::string::npos)
            << Text(result) << "\nwas known to fail: " << expected->second->reason;
        known.erase(expected);
    }
    for (const auto& [cell, failure] : known)
    {
        ADD_FAILURE() << cell << " is not tried any more";
    }
}

} // namespace
} // namespace limn::study
