#include "Mentions.h"
#include "ShaderTestSupport.h"
#include "core/FileSizeLimit.h"

#include <limn/base/WriteFile.h>

#include <fcntl.h>
#include <future>
#include <iterator>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/xattr.h>
#include <thread>
#include <unistd.h>

namespace limn
{
namespace
{

using std::filesystem::perms;

std::string ContentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::size_t FilesIn(const std::filesystem::path& folder)
{
    std::filesystem::directory_iterator files(folder);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

/// What was put onto the disk, and what a file held when that was asked for.
struct Syncs
{
    std::filesystem::path file;
    std::vector<std::string> all;
};
Syncs* s_Syncs = nullptr;

/// An extended attribute; "" if there is none.
std::string AttributeOf(const std::filesystem::path& path, const char* name)
{
    char bytes[256];
    const ssize_t size = getxattr(path.c_str(), name, bytes, sizeof(bytes));
    return {bytes, static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

/// A list of who may do what, as the kernel has it: the owner and a user of the number 12 may read
/// and write, the group may read.
std::string AccessControlList()
{
    struct Entry
    {
        std::uint16_t tag;
        std::uint16_t rights;
        std::uint32_t id;
    };
    constexpr std::uint32_t version = 2;
    constexpr std::uint32_t nobody = 0xFFFFFFFFu;
    const Entry entries[] = {
        {0x01, 6, nobody}, {0x02, 6, 12}, {0x04, 4, nobody}, {0x10, 6, nobody}, {0x20, 0, nobody}};
    std::string bytes(reinterpret_cast<const char*>(&version), sizeof(version));
    return bytes.append(reinterpret_cast<const char*>(entries), sizeof(entries));
}

bool SetAttribute(const std::filesystem::path& path, const char* name, const std::string& value)
{
    return setxattr(path.c_str(), name, value.data(), value.size(), 0) == 0;
}

constexpr const char* k_AccessControl = "system.posix_acl_access";

std::string WriteMessage(const std::filesystem::path& path)
{
    try
    {
        WriteFile(path, "new");
    }
    catch (const AssetError& error)
    {
        EXPECT_EQ(error.diagnostics().front().file, path.string());
        return error.diagnostics().front().message;
    }
    return {};
}

} // namespace

/// Stands before the C library's, as FaultyLoader's entry points do before Vulkan's.
extern "C" int fsync(int descriptor)
{
    struct stat status = {};
    fstat(descriptor, &status);
    if (s_Syncs != nullptr)
    {
        s_Syncs->all.push_back((S_ISDIR(status.st_mode) ? "folder, " : "file, ") +
                               ContentOf(s_Syncs->file));
    }
    return static_cast<int>(syscall(SYS_fsync, descriptor));
}

namespace
{

TEST(WriteFile, IsOnTheDiskWithItsNameWhenItReturns)
{
    test::TemporaryFolder folder;
    Syncs syncs{folder.Write("a", "old"), {}};
    s_Syncs = &syncs;
    WriteFile(syncs.file, "new");
    EXPECT_EQ(syncs.all, (std::vector<std::string>{"file, old", "folder, new"}));
    syncs.all.clear();
    EXPECT_FALSE(TryWriteFile(syncs.file, "newer"));
    s_Syncs = nullptr;
    EXPECT_EQ(syncs.all, std::vector<std::string>{}) << "a cache is lost without harm";
}

TEST(WriteFile, KeepsAccessControlListsAndOtherAttributes)
{
    test::TemporaryFolder folder;
    const auto file = folder.Write("a", "old");
    if (!SetAttribute(file, "user.limn", "kept") || !SetAttribute(file, "user.empty", "") ||
        !SetAttribute(file, k_AccessControl, AccessControlList()))
    {
        GTEST_SKIP() << "no attributes on this file system";
    }
    WriteFile(file, "new");
    EXPECT_EQ(ContentOf(file), "new");
    EXPECT_EQ(AttributeOf(file, "user.limn"), "kept");
    EXPECT_EQ(AttributeOf(file, k_AccessControl), AccessControlList());
    EXPECT_EQ(getxattr(file.c_str(), "user.empty", nullptr, 0), 0);
}

TEST(WriteFile, TakesNoAccessControlListFromTheFolder)
{
    test::TemporaryFolder folder;
    const auto file = folder.Write("a", "old");
    if (!SetAttribute(folder.path(), "system.posix_acl_default", AccessControlList()))
    {
        GTEST_SKIP() << "no attributes on this file system";
    }
    const std::string made = AttributeOf(folder.Write("b", ""), k_AccessControl);
    ASSERT_NE(made, "") << "what a new file gets";
    WriteFile(file, "new");
    EXPECT_EQ(AttributeOf(file, k_AccessControl), "");
    WriteFile(folder.path() / "c", "new");
    EXPECT_EQ(AttributeOf(folder.path() / "c", k_AccessControl), made);
}

TEST(WriteFile, GivesANewFileThePermissionsOfEveryNewFile)
{
    test::TemporaryFolder folder;
    WriteFile(folder.path() / "a", "new");
    folder.Write("b", "");
    EXPECT_EQ(ContentOf(folder.path() / "a"), "new");
    EXPECT_EQ(std::filesystem::status(folder.path() / "a").permissions(),
              std::filesystem::status(folder.path() / "b").permissions());
}

TEST(WriteFile, KeepsPermissionsAndOwner)
{
    test::TemporaryFolder folder;
    const auto file = folder.Write("a", "old");
    std::filesystem::permissions(file, perms::owner_all | perms::group_read);
    const bool isRoot = geteuid() == 0;
    ASSERT_TRUE(!isRoot || chown(file.c_str(), 12, 34) == 0);
    WriteFile(file, "new");
    struct stat status = {};
    ASSERT_EQ(stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777u, 0740u);
    EXPECT_EQ(status.st_uid, isRoot ? 12 : getuid());
    EXPECT_EQ(ContentOf(file), "new");
}

TEST(WriteFile, LeavesAFileAloneThatNobodyMayWriteTo)
{
    test::TemporaryFolder folder;
    const auto file = folder.Write("a", "old");
    std::filesystem::permissions(file, perms::owner_read | perms::group_read);
    EXPECT_EQ(WriteMessage(file), "the file cannot be written: Permission denied");
    EXPECT_EQ(ContentOf(file), "old");
}

TEST(WriteFile, TellsAMachinesFaultFromAFiles)
{
    test::TemporaryFolder folder;
    EXPECT_THROW(WriteFile("/dev/full", "new"), MachineError);
    try
    {
        WriteFile(folder.path(), "new");
        FAIL() << "written";
    }
    catch (const MachineError&)
    {
        FAIL() << "a folder is no fault of the machine's";
    }
    catch (const AssetError&)
    {
    }
}

TEST(WriteFile, WritesTheFileBehindALinkAndKeepsTheLink)
{
    test::TemporaryFolder folder;
    folder.Write("sub/a", "old");
    std::filesystem::create_symlink("sub/a", folder.path() / "near");
    std::filesystem::create_symlink(folder.path() / "near", folder.path() / "far");
    std::filesystem::create_symlink("sub/made", folder.path() / "dangling");
    WriteFile(folder.path() / "far", "new");
    WriteFile(folder.path() / "dangling", "made");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "far"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "near"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "dangling"));
    EXPECT_EQ(ContentOf(folder.path() / "sub/a"), "new");
    EXPECT_EQ(ContentOf(folder.path() / "sub/made"), "made");
    EXPECT_EQ(FilesIn(folder.path() / "sub"), 2u);
}

TEST(WriteFile, WritesToADeviceAndLeavesItThere)
{
    test::TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/null", folder.path() / "null");
    std::filesystem::create_symlink("/dev/full", folder.path() / "full");
    EXPECT_EQ(WriteMessage(folder.path() / "null"), "");
    EXPECT_THAT(WriteMessage(folder.path() / "full"), test::Mentions("written", "No space left"));
    EXPECT_TRUE(std::filesystem::is_character_file(folder.path() / "null"));
    EXPECT_TRUE(std::filesystem::is_character_file(folder.path() / "full"));
}

TEST(WriteFile, WritesIntoAPipeThatSomebodyReads)
{
    test::TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(WriteMessage(pipe), test::Mentions("written", "nobody reads"));

    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    EXPECT_EQ(WriteMessage(pipe), "");
    char bytes[8] = {};
    EXPECT_EQ(read(reader, bytes, sizeof(bytes)), 3);
    EXPECT_STREQ(bytes, "new");
    close(reader);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(WriteFile, WaitsForWhoReadsAPipeSlowly)
{
    test::TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    fcntl(reader, F_SETFL, 0);
    const std::string bytes(300000, 'x'); // a pipe holds 65536
    auto writing = std::async(std::launch::async, [&] { WriteFile(pipe, bytes); });
    std::string got(bytes.size(), '\0');
    for (std::size_t at = 0; at < got.size();)
    {
        const ssize_t count = read(reader, got.data() + at, got.size() - at);
        ASSERT_GE(count, 0);
        at += static_cast<std::size_t>(count);
        std::this_thread::yield();
    }
    writing.get();
    close(reader);
    EXPECT_EQ(got, bytes);
}

TEST(WriteFile, LeavesEveryNameOfAFileOnTheSameContent)
{
    test::TemporaryFolder folder;
    const auto one = folder.Write("one", "a longer old content");
    std::filesystem::create_hard_link(one, folder.path() / "two");
    WriteFile(one, "new");
    EXPECT_EQ(ContentOf(one), "new");
    EXPECT_EQ(ContentOf(folder.path() / "two"), "new");
    EXPECT_EQ(std::filesystem::hard_link_count(one), 2u);
    EXPECT_EQ(FilesIn(folder.path()), 2u);
}

TEST(WriteFile, KeepsTheOldContentUnderEveryNameWhenThereIsNoRoom)
{
    test::TemporaryFolder folder;
    const auto one = folder.Write("one", "old");
    std::filesystem::create_hard_link(one, folder.path() / "two");
    const std::string bytes(10000, 'x');
    std::error_code failure;
    {
        const test::FileSizeLimit limit(1024);
        failure = TryWriteFile(one, bytes);
    }
    EXPECT_EQ(failure, std::errc::file_too_large);
    EXPECT_EQ(ContentOf(folder.path() / "two"), "old");
}

TEST(WriteFile, TakesNamesAsLongAsTheSystemDoes)
{
    test::TemporaryFolder folder;
    WriteFile(folder.path() / std::string(255, 'n'), "new");
    EXPECT_EQ(ContentOf(folder.path() / std::string(255, 'n')), "new");
    EXPECT_THAT(WriteMessage(folder.path() / std::string(256, 'n')),
                test::Mentions("written", "name too long"));
}

TEST(WriteFile, IsNotStoppedByWhatAnotherProcessOfItsNumberLeft)
{
    test::TemporaryFolder folder;
    for (int i = 1; i < 200; ++i)
    {
        folder.Write("a.tmp-" + std::to_string(getpid()) + "-" + std::to_string(i), "left");
    }
    EXPECT_EQ(WriteMessage(folder.path() / "a"), "");
}

TEST(WriteFile, RefusesAFolder)
{
    test::TemporaryFolder folder;
    EXPECT_EQ(WriteMessage(folder.path()), "the file cannot be written: Is a directory");
    EXPECT_EQ(FilesIn(folder.path()), 0u);
}

TEST(WriteFile, LeavesTheFileAsItWasIfItIsStopped)
{
    test::TemporaryFolder folder;
    const auto one = folder.Write("one", "old");
    const auto stop = []
    {
        throw std::runtime_error("stop");
    };
    EXPECT_THROW(WriteFile(one, "new and longer", stop), std::runtime_error);
    EXPECT_EQ(ContentOf(one), "old");
    std::filesystem::create_hard_link(one, folder.path() / "two");
    EXPECT_THROW(WriteFile(one, "new and longer", stop), std::runtime_error);
    EXPECT_EQ(ContentOf(one), "old");
    EXPECT_EQ(FilesIn(folder.path()), 2u);
}

TEST(FileLock, IsHeldByOneAtATime)
{
    test::TemporaryFolder folder;
    const auto file = folder.Write("a", "");
    std::filesystem::create_symlink(file, folder.path() / "link");
    auto held = std::make_unique<FileLock>(file);
    std::promise<void> isWaiting;
    auto other = std::async(std::launch::async,
                            [&]
                            {
                                isWaiting.set_value();
                                const FileLock lock(folder.path() / "link");
                            });
    isWaiting.get_future().wait();
    EXPECT_EQ(other.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout);
    held.reset();
    EXPECT_EQ(other.wait_for(std::chrono::seconds(20)), std::future_status::ready);
}

} // namespace
} // namespace limn
