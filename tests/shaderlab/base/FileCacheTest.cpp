#include <limn/base/FileCache.h>

#include "TemporaryFolder.h"

#include <fstream>
#include <gmock/gmock.h>
#include <limn/base/ReadFile.h>
#include <thread>

namespace limn
{
namespace
{

class FileCacheTest : public testing::Test
{
protected:
    FileCache Make(std::uintmax_t limit = 0, const std::string& magic = "test 1\n") const
    {
        return FileCache(m_Folder / "cache", ".test", magic, limit);
    }
    std::string Load(const std::string& key) const
    {
        const std::optional<FileCache::Entry> entry = Make().Load(key);
        return entry ? std::string(entry->payload()) : "(none)";
    }
    std::filesystem::path PathOf(const std::string& key) const
    {
        return m_Folder / "cache" / (key + ".test");
    }

    test::TemporaryFolder m_Folder;
};

} // namespace

TEST_F(FileCacheTest, GivesBackWhatWasStored)
{
    EXPECT_EQ(Load("a"), "(none)");
    Make().Store("a", "one");
    Make().Store("b", "");
    EXPECT_EQ(Load("a"), "one");
    EXPECT_EQ(Load("b"), "");
    Make().Store("a", "two");
    EXPECT_EQ(Load("a"), "two");
    EXPECT_FALSE(FileCache({}, ".test", "m", 0).Load("a"));
}

TEST_F(FileCacheTest, TakesNoEntryThatIsDamagedRenamedOrOfAnotherFormat)
{
    Make().Store("a", "payload");
    EXPECT_FALSE(Make(0, "test 2\n").Load("a"));
    const std::string whole = ReadFile(PathOf("a"));
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        std::ofstream(PathOf("a"), std::ios::binary) << damaged;
        EXPECT_EQ(Load("a"), "(none)") << "byte " << i;
        std::ofstream(PathOf("a"), std::ios::binary) << whole.substr(0, i);
        EXPECT_EQ(Load("a"), "(none)") << i << " bytes";
    }
    std::ofstream(PathOf("b"), std::ios::binary) << whole;
    EXPECT_EQ(Load("b"), "(none)");
    Make().Store("a", "again");
    EXPECT_EQ(Load("a"), "again");
}

TEST_F(FileCacheTest, RemovesWhatWasNotUsedForLongest)
{
    const std::string payload(1000, 'p');
    for (const char* key : {"a", "b", "c"})
    {
        Make().Store(key, payload);
        std::filesystem::last_write_time(PathOf(key),
                                         std::filesystem::file_time_type::clock::now() -
                                             std::chrono::hours(*key == 'a' ? 3 : 2));
    }
    Make().Touch("a");
    Make(2500).Store("d", payload);
    EXPECT_EQ(Load("a"), payload);
    EXPECT_EQ(Load("d"), payload);
    EXPECT_EQ(Load("b"), "(none)");
    EXPECT_EQ(Load("c"), "(none)");
}

TEST_F(FileCacheTest, KeepsNothingInAFolderThatCannotBeMade)
{
    m_Folder.Write("cache", "a file stands in its place");
    Make().Store("a", "one");
    EXPECT_EQ(Load("a"), "(none)");
}

TEST_F(FileCacheTest, IsSharedByWritersAndReadersAtATime)
{
    const std::string payloads[] = {std::string(100'000, 'x'), std::string(200'000, 'y')};
    std::vector<std::thread> writers;
    for (const std::string& payload : payloads)
    {
        writers.emplace_back(
            [&]
            {
                for (int i = 0; i < 30; ++i)
                {
                    Make().Store("a", payload);
                }
            });
    }
    for (int i = 0; i < 100; ++i)
    {
        const std::string found = Load("a");
        EXPECT_TRUE(found == "(none)" || found == payloads[0] || found == payloads[1]);
    }
    for (std::thread& writer : writers)
    {
        writer.join();
    }
    EXPECT_NE(Load("a"), "(none)");
}

} // namespace limn
