#include "TemporaryFolder.h"
#include <limn/base/FileWatcher.h>

#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

using Paths = std::set<std::filesystem::path>;
using SystemClock = std::chrono::system_clock;

} // namespace

TEST(FileWatcher, TellsWhatWasWrittenRenamedIntoPlaceOrRemoved)
{
    const TemporaryFolder folder;
    const std::filesystem::path a = folder.Write("a", "1");
    const std::filesystem::path b = folder.Write("b", "1");
    FileWatcher watcher;
    watcher.Watch({a, b});
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
    folder.Write("a", "2");
    EXPECT_EQ(Paths{a}, watcher.TakeChanges());
    std::filesystem::rename(folder.Write("b.tmp", "2"), b);
    EXPECT_EQ(Paths{b}, watcher.TakeChanges());
    std::filesystem::remove(a);
    EXPECT_EQ(Paths{a}, watcher.TakeChanges());
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
}

TEST(FileWatcher, TellsOfAFileOnlyWhenItIsClosed)
{
    const TemporaryFolder folder;
    const std::filesystem::path a = folder.Write("a", "1");
    FileWatcher watcher;
    watcher.Watch({a});
    std::ofstream stream(a);
    stream << "2" << std::flush;
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
    stream.close();
    EXPECT_EQ(Paths{a}, watcher.TakeChanges());
}

TEST(FileWatcher, SeesAFileComeThatWasNotThere)
{
    const TemporaryFolder folder;
    FileWatcher watcher;
    watcher.Watch({folder / "later", folder / "no/folder"});
    folder.Write("other", "1");
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
    folder.Write("later", "1");
    EXPECT_EQ(Paths{folder / "later"}, watcher.TakeChanges());
    std::filesystem::create_directories(folder / "no");
    folder.Write("no/folder", "1");
    EXPECT_EQ(Paths{folder / "no/folder"}, watcher.TakeChanges());
}

TEST(FileWatcher, SeesWhatALinkPointsTo)
{
    const TemporaryFolder folder;
    const TemporaryFolder other;
    std::filesystem::create_symlink(other.Write("target", "1"), folder / "link");
    FileWatcher watcher;
    watcher.Watch({folder / "link"});
    other.Write("target", "2");
    EXPECT_EQ(Paths{folder / "link"}, watcher.TakeChanges());
}

TEST(FileWatcher, GoesOnWhenItsFolderIsReplacedByAnother)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "p/q");
    std::filesystem::create_directories(folder / "new/q");
    const std::filesystem::path file = folder.Write("p/q/a", "1");
    folder.Write("new/q/a", "2");
    FileWatcher watcher;
    watcher.Watch({file});
    std::filesystem::rename(folder / "p", folder / "old");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
    std::filesystem::rename(folder / "new", folder / "p");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
    folder.Write("p/q/a", "3");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
    folder.Write("old/q/a", "4");
    EXPECT_EQ(Paths{}, watcher.TakeChanges()) << "the file of the folder that was moved away";
}

TEST(FileWatcher, GoesOnWhenItsFolderIsRemovedAndMadeAgain)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "p/q");
    const std::filesystem::path file = folder.Write("p/q/a", "1");
    FileWatcher watcher;
    watcher.Watch({file});
    std::filesystem::remove_all(folder / "p");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
    std::filesystem::create_directories(folder / "p/q");
    folder.Write("p/q/a", "2");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
    folder.Write("p/q/a", "3");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
}

TEST(FileWatcher, SeesALinkedFolderPointElsewhere)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "one");
    std::filesystem::create_directories(folder / "two");
    folder.Write("one/a", "1");
    folder.Write("two/a", "2");
    std::filesystem::create_directory_symlink(folder / "one", folder / "now");
    const std::filesystem::path file = folder / "now/a";
    FileWatcher watcher;
    watcher.Watch({file});
    std::filesystem::create_directory_symlink(folder / "two", folder / "next");
    std::filesystem::rename(folder / "next", folder / "now");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
    folder.Write("two/a", "3");
    EXPECT_EQ(Paths{file}, watcher.TakeChanges());
    folder.Write("one/a", "4");
    EXPECT_EQ(Paths{}, watcher.TakeChanges()) << "what the link pointed to before";
}

TEST(FileWatcher, IsSilentOnWhatHappensBesideItsFiles)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "p");
    const std::filesystem::path file = folder.Write("p/a", "1");
    FileWatcher watcher;
    watcher.Watch({file});
    folder.Write("other", "1");
    folder.Write("p/other", "1");
    std::filesystem::create_directories(folder / "q");
    std::filesystem::rename(folder / "q", folder / "p/q");
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
}

TEST(FileWatcher, TellsOnceOfAFileThatChangedAfterItWasRead)
{
    const TemporaryFolder folder;
    const std::filesystem::path a = folder.Write("a", "1");
    FileWatcher watcher;
    watcher.Watch({a}, SystemClock::now() - std::chrono::minutes(1));
    EXPECT_EQ(Paths{a}, watcher.TakeChanges());
    watcher.Watch({a}, SystemClock::now() - std::chrono::minutes(1));
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
}

TEST(FileWatcher, SeesThatAnOldFileWasRenamedIntoPlaceAfterItWasRead)
{
    const TemporaryFolder folder;
    const std::filesystem::path old = folder.Write("a.tmp", "1");
    const auto lastYear = std::filesystem::file_time_type::clock::now() - std::chrono::hours(9000);
    std::filesystem::last_write_time(old, lastYear);
    std::filesystem::rename(old, folder / "a");
    FileWatcher watcher;
    watcher.Watch({folder / "a"}, SystemClock::now() - std::chrono::minutes(1));
    EXPECT_EQ(Paths{folder / "a"}, watcher.TakeChanges());
}

TEST(FileWatcher, IsSilentOnAFileThatDidNotChangeSinceItWasRead)
{
    const TemporaryFolder folder;
    const std::filesystem::path a = folder.Write("a", "1");
    FileWatcher watcher;
    watcher.Watch({a}, SystemClock::now() + std::chrono::minutes(1));
    EXPECT_EQ(Paths{}, watcher.TakeChanges());
}

} // namespace limn::test
