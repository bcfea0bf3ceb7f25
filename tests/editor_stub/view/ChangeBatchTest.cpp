#include "view/ChangeBatch.h"
#include "plugins/PluginRun.h"

#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

using std::chrono::milliseconds;
using Files = std::set<std::filesystem::path>;

/// Counts milliseconds from the beginning of a test.
ChangeBatch::Clock::time_point At(int millisecond)
{
    return ChangeBatch::Clock::time_point(milliseconds(millisecond));
}

/// How many pictures come of 3 s in which a file is saved again and again, drawing taking no time.
int DrawsWhileSavedEvery(int period, const std::filesystem::path& file)
{
    ChangeBatch batch;
    int draws = 0;
    for (int now = 0; now < 3000; ++now)
    {
        batch.Add(now % period == 0 ? Files{file} : Files{}, At(now));
        if (batch.Remaining(At(now)) == milliseconds(0))
        {
            EXPECT_EQ(Files{file}, batch.Take());
            ++draws;
        }
    }
    return draws;
}

} // namespace

TEST(ChangeBatch, IsDrawnWhateverThePauseBetweenSaves)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.Write("a", "1");
    for (const int period : {1, 2, 4, 8, 16, 40})
    {
        EXPECT_GE(DrawsWhileSavedEvery(period, file), 75) << period << " ms"; // 25 a second
    }
}

TEST(ChangeBatch, OfOneSaveIsDrawnAtOnce)
{
    const TemporaryFolder folder;
    ChangeBatch batch;
    EXPECT_FALSE(batch.Remaining(At(0)));
    batch.Add({}, At(0));
    EXPECT_FALSE(batch.Remaining(At(0)));
    batch.Add({folder.Write("a", "1")}, At(100));
    EXPECT_LE(batch.Remaining(At(100)), milliseconds(5));
    EXPECT_EQ(batch.Remaining(At(200)), milliseconds(0));
    EXPECT_EQ(Files{folder / "a"}, batch.Take());
    EXPECT_FALSE(batch.Remaining(At(200)));
}

TEST(ChangeBatch, HoldsAllFilesOfACheckout)
{
    const TemporaryFolder folder;
    ChangeBatch batch;
    Files files;
    for (int i = 0; i < 10; ++i)
    {
        files.insert(folder.Write("f" + std::to_string(i), "1"));
        batch.Add({*files.rbegin()}, At(2 * i));
        EXPECT_GT(batch.Remaining(At(2 * i)), milliseconds(0));
    }
    EXPECT_EQ(batch.Remaining(At(25)), milliseconds(0));
    EXPECT_EQ(files, batch.Take());
}

TEST(ChangeBatch, WaitsALittleForAFileThatWasTakenAway)
{
    const TemporaryFolder folder;
    ChangeBatch batch;
    batch.Add({folder / "a"}, At(0));
    EXPECT_GT(batch.Remaining(At(20)), milliseconds(0));
    EXPECT_EQ(batch.Remaining(At(30)), milliseconds(0)) << "it does not come back";
    folder.Write("a", "1");
    batch.Add({folder / "a"}, At(20));
    EXPECT_EQ(batch.Remaining(At(25)), milliseconds(0)) << "it is back";
}

TEST(ChangeBatch, WaitsForAPluginUntilItIsLinked)
{
    const TemporaryFolder folder;
    const std::string whole = ReadText(BuiltPlugin("no_plugin.so"));
    ChangeBatch batch;
    batch.Add({folder / "a.so"}, At(0));
    EXPECT_GT(batch.Remaining(At(400)), milliseconds(0)) << "it was taken away";
    folder.Write("a.so", "");
    EXPECT_GT(batch.Remaining(At(400)), milliseconds(0)) << "it is empty";
    folder.Write("a.so", whole.substr(0, whole.size() / 2));
    batch.Add({folder / "a.so"}, At(300));
    EXPECT_GT(batch.Remaining(At(400)), milliseconds(0)) << "its second half is missing";
    EXPECT_EQ(batch.Remaining(At(500)), milliseconds(0)) << "it does not come";
    folder.Write("a.so", whole);
    batch.Add({folder / "a.so"}, At(400));
    EXPECT_EQ(batch.Remaining(At(405)), milliseconds(0)) << "it is there";
}

} // namespace limn::test
