#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <limn/base/FileRoots.h>
#include <limn/base/ReadFile.h>

#include <sys/stat.h>

namespace limn
{
namespace
{

TEST(ReadFile, GivesEveryByte)
{
    test::TemporaryFolder folder;
    std::string bytes(70000, 'x');
    bytes[1] = '\0';
    bytes[69999] = '\xFF';
    EXPECT_EQ(ReadFile(folder.Write("a", bytes)), bytes);
    EXPECT_EQ(ReadFile(folder.Write("b", "")), "");
}

TEST(ReadFile, FollowsALink)
{
    test::TemporaryFolder folder;
    folder.Write("a", "here");
    std::filesystem::create_symlink("a", folder.path() / "link");
    EXPECT_EQ(ReadFile(folder.path() / "link"), "here");
}

TEST(ReadFile, NamesWhatIsNoFile)
{
    test::TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", folder.path() / "zeros");
    std::filesystem::create_symlink("circle", folder.path() / "circle");
    EXPECT_EQ(TryReadFile(folder.path() / "none").problem, "there is no such file");
    EXPECT_THAT(TryReadFile(folder.path()).problem, test::Mentions("folder", "file"));
    EXPECT_THAT(TryReadFile(pipe).problem, test::Mentions("named pipe", "file"));
    EXPECT_THAT(TryReadFile(folder.path() / "zeros").problem, test::Mentions("device", "file"));
    EXPECT_THAT(TryReadFile(folder.path() / "circle").problem, test::Mentions("link", "itself"));
}

TEST(ReadFile, RefusesWhatIsTooLongBeforeItReadsIt)
{
    test::TemporaryFolder folder;
    const auto file = folder.Write("a", "");
    std::filesystem::resize_file(file, std::uintmax_t{1} << 40); // without a byte on the disk
    EXPECT_THAT(TryReadFile(file).problem, test::Mentions("1099511627776", "67108864"));
    std::filesystem::resize_file(file, 10);
    EXPECT_EQ(TryReadFile(file, 10).bytes.size(), 10u);
    EXPECT_THAT(TryReadFile(file, 9).problem, test::Mentions("10 bytes", "9"));
}

TEST(ReadFile, RefusesWhatIsLongerThanItSays)
{
    EXPECT_THAT(TryReadFile("/proc/self/status", 8).problem, test::Mentions("more than 8"));
    EXPECT_NE(ReadFile("/proc/self/status").find("Name:"), std::string::npos);
}

TEST(ReadFile, NamesTheFileWhereItIsNeeded)
{
    try
    {
        ReadFile("/nowhere/a");
        FAIL() << "nothing was thrown";
    }
    catch (const AssetError& error)
    {
        EXPECT_THAT(error.what(), test::Mentions("/nowhere/a: error", "no such file"));
    }
}

TEST(FileRoots, ContainWhatIsBelowThem)
{
    test::TemporaryFolder folder;
    folder.Write("in/deep/a", "");
    folder.Write("inside/a", "");
    FileRoots roots;
    EXPECT_FALSE(roots.Contains(folder.path() / "in"));
    roots.Add(folder.path() / "in/");
    EXPECT_TRUE(roots.Contains(folder.path() / "in/deep/a"));
    EXPECT_TRUE(roots.Contains(folder.path() / "in/none/b"));
    EXPECT_TRUE(roots.Contains(folder.path() / "inside/../in/deep/a"));
    EXPECT_FALSE(roots.Contains(folder.path() / "inside/a"));
    EXPECT_FALSE(roots.Contains(folder.path() / "in/../inside/a"));
    EXPECT_FALSE(roots.Contains(folder.path() / "in/none/../../../a"));
    EXPECT_FALSE(roots.Contains("/etc/passwd"));
}

TEST(FileRoots, AreNotLeftByLinks)
{
    test::TemporaryFolder folder;
    folder.Write("in/a", "");
    folder.Write("out/b", "");
    std::filesystem::create_symlink("../out", folder.path() / "in/folder");
    std::filesystem::create_symlink("../out/b", folder.path() / "in/file");
    std::filesystem::create_symlink("circle", folder.path() / "in/circle");
    FileRoots roots;
    roots.Add(folder.path() / "in");
    EXPECT_FALSE(roots.Contains(folder.path() / "in/folder/b"));
    EXPECT_FALSE(roots.Contains(folder.path() / "in/file"));
    EXPECT_FALSE(roots.Contains(folder.path() / "in/circle"));
}

TEST(FileRoots, TakeNoNameForTheWorkingFolder)
{
    FileRoots roots;
    roots.Add("");
    EXPECT_TRUE(roots.Contains("a"));
    EXPECT_TRUE(roots.Contains(std::filesystem::current_path() / "a"));
    EXPECT_FALSE(roots.Contains("../a"));
    EXPECT_FALSE(roots.Contains("/"));
}

} // namespace
} // namespace limn
