#include "ShaderTestSupport.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

namespace limn
{

namespace
{

/// Programs that differ in one digit, so that their entries are of one size.
PassProgram NumberedProgram(int digit)
{
    return test::Program("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                         "float4 frag() : SV_Target { return 0." +
                         std::to_string(digit) + "; }\n");
}

std::shared_ptr<const ShaderProgram> CompileInto(const std::filesystem::path& cache, int digit,
                                                 std::uintmax_t limit)
{
    ShaderCompilerOptions options;
    options.cacheFolder = cache;
    options.cacheLimit = limit;
    return ShaderCompiler(options).Compile(NumberedProgram(digit));
}

std::set<std::filesystem::path> FilesOf(const std::filesystem::path& folder)
{
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        files.insert(entry.path());
    }
    return files;
}

/// Compiles and says which file that made.
std::filesystem::path EntryMade(const std::filesystem::path& cache, int digit, std::uintmax_t limit)
{
    const std::set<std::filesystem::path> before = FilesOf(cache);
    CompileInto(cache, digit, limit);
    for (const std::filesystem::path& file : FilesOf(cache))
    {
        if (!before.contains(file))
        {
            return file;
        }
    }
    ADD_FAILURE() << "no entry was made for " << digit;
    return {};
}

/// As if the entry was used last so many hours ago.
void Age(const std::filesystem::path& entry, int hours)
{
    std::filesystem::last_write_time(entry, std::filesystem::file_time_type::clock::now() -
                                                std::chrono::hours(hours));
}

/// The entries of the programs 0, 1 and 2, last used 1, 3 and 2 hours ago.
std::map<int, std::filesystem::path> ThreeEntries(const std::filesystem::path& cache)
{
    std::map<int, std::filesystem::path> entries;
    for (const auto& [digit, hours] : {std::pair(0, 1), std::pair(1, 3), std::pair(2, 2)})
    {
        entries[digit] = EntryMade(cache, digit, 0);
        Age(entries[digit], hours);
    }
    return entries;
}

} // namespace

TEST(ShaderCacheLimit, TheEntriesNotUsedForLongestGoFirst)
{
    const test::TemporaryFolder folder;
    const auto entries = ThreeEntries(folder.path());
    const std::uintmax_t size = std::filesystem::file_size(entries.at(0));
    // The fourth makes four; the limit leaves room for two.
    const std::filesystem::path made = EntryMade(folder.path(), 3, 2 * size + size / 2);
    EXPECT_EQ(FilesOf(folder.path()), (std::set<std::filesystem::path>{entries.at(0), made}));
}

TEST(ShaderCacheLimit, UsingAnEntryKeepsIt)
{
    const test::TemporaryFolder folder;
    const auto entries = ThreeEntries(folder.path());
    const std::uintmax_t size = std::filesystem::file_size(entries.at(0));
    CompileInto(folder.path(), 1, 0);
    const std::filesystem::path made = EntryMade(folder.path(), 3, 2 * size + size / 2);
    EXPECT_EQ(FilesOf(folder.path()), (std::set<std::filesystem::path>{entries.at(1), made}));
}

TEST(ShaderCacheLimit, NothingGoesWhileAllFits)
{
    const test::TemporaryFolder folder;
    const auto entries = ThreeEntries(folder.path());
    EntryMade(folder.path(), 3, 5 * std::filesystem::file_size(entries.at(0)));
    EXPECT_EQ(FilesOf(folder.path()).size(), 4U);
}

TEST(ShaderCacheLimit, ALimitBelowOneEntryKeepsNoneAndStillCompiles)
{
    const test::TemporaryFolder folder;
    EXPECT_NE(CompileInto(folder.path(), 0, 1), nullptr);
    EXPECT_TRUE(FilesOf(folder.path()).empty());
}

TEST(ShaderCacheLimit, HoldsWhileOneCompilerFillsTheFolder)
{
    const test::TemporaryFolder folder;
    const std::uintmax_t size = std::filesystem::file_size(EntryMade(folder.path(), 0, 0));
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path();
    options.cacheLimit = 2 * size + size / 2;
    ShaderCompiler compiler(options);
    for (int digit = 1; digit < 8; ++digit)
    {
        compiler.Compile(NumberedProgram(digit));
        EXPECT_LE(FilesOf(folder.path()).size(), 2U) << digit;
    }
}

TEST(ShaderCacheLimit, ZeroIsNoLimit)
{
    const test::TemporaryFolder folder;
    for (int digit = 0; digit < 8; ++digit)
    {
        CompileInto(folder.path(), digit, 0);
    }
    EXPECT_EQ(FilesOf(folder.path()).size(), 8U);
}

TEST(ShaderCacheLimit, LeavesFilesThatAreNoEntriesAlone)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path foreign = folder.Write("notes.txt", std::string(100000, 'x'));
    Age(foreign, 100);
    CompileInto(folder.path(), 0, 1);
    EXPECT_EQ(FilesOf(folder.path()), std::set<std::filesystem::path>{foreign});
}

// An entry whose hash does not fit is rebuilt, whichever byte of it is wrong.
TEST(ShaderCacheDamage, RebuildsAnEntryWithAFlippedBitAnywhere)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path entry = EntryMade(folder.path(), 0, 0);
    std::ifstream stream(entry, std::ios::binary);
    const std::string good{std::istreambuf_iterator<char>(stream), {}};
    const auto expected = CompileInto({}, 0, 0);
    const std::size_t step = std::max<std::size_t>(1, good.size() / 10);
    for (std::size_t place = 0; place < good.size(); place += step)
    {
        std::string bad = good;
        bad[place] = static_cast<char>(bad[place] ^ (1 << (place % 8)));
        std::ofstream(entry, std::ios::binary) << bad;
        ShaderCompiler compiler({folder.path(), {}, {}});
        EXPECT_EQ(*compiler.Compile(NumberedProgram(0)), *expected) << place;
        EXPECT_EQ(compiler.statistics().compiled, 1) << "byte " << place << " was not looked at";
    }
}

namespace
{

constexpr int k_Programs = 5;

/// What a process of its own does: 0 = every result was as expected, else the number of wrong ones.
int CompileRepeatedly(const std::filesystem::path& cache, int first,
                      const std::vector<std::shared_ptr<const ShaderProgram>>& expected,
                      std::uintmax_t limit)
{
    int wrong = 0;
    for (int round = 0; round < 6; ++round)
    {
        for (int i = 0; i < k_Programs; ++i)
        {
            const int digit = (first + i) % k_Programs;
            const auto pass = CompileInto(cache, digit, limit);
            wrong += *pass == *expected[static_cast<std::size_t>(digit)] ? 0 : 1;
        }
    }
    return wrong;
}

/// Two processes that use one cache folder at once; both must find nothing wrong.
void ShareFolder(const std::filesystem::path& cache, std::uintmax_t limit)
{
    std::vector<std::shared_ptr<const ShaderProgram>> expected;
    for (int digit = 0; digit < k_Programs; ++digit)
    {
        expected.push_back(CompileInto({}, digit, 0));
    }
    std::vector<pid_t> children;
    for (const int first : {0, k_Programs / 2})
    {
        const pid_t child = fork();
        if (child == 0)
        {
            int wrong = 100;
            try
            {
                wrong = CompileRepeatedly(cache, first, expected, limit);
            }
            catch (...)
            {
            }
            _exit(wrong);
        }
        ASSERT_GT(child, 0);
        children.push_back(child);
    }
    for (const pid_t child : children)
    {
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 0);
    }
    for (const std::filesystem::path& file : FilesOf(cache))
    {
        EXPECT_EQ(file.extension(), ".limnpass") << file << " was left behind";
    }
}

} // namespace

TEST(ShaderCacheSharing, TwoProcessesMayFillOneFolderAtOnce)
{
    const test::TemporaryFolder folder;
    ShareFolder(folder.path(), 0);
    EXPECT_EQ(FilesOf(folder.path()).size(), static_cast<std::size_t>(k_Programs));
    for (int digit = 0; digit < k_Programs; ++digit)
    {
        ShaderCompiler compiler({folder.path(), {}, {}});
        compiler.Compile(NumberedProgram(digit));
        EXPECT_EQ(compiler.statistics().loadedFromCache, 1) << "the entry of " << digit;
    }
}

TEST(ShaderCacheSharing, TwoProcessesMayTrimOneFolderAtOnce)
{
    const test::TemporaryFolder folder;
    const std::uintmax_t size = std::filesystem::file_size(EntryMade(folder.path(), 0, 0));
    ShareFolder(folder.path(), 2 * size + size / 2);
}

} // namespace limn
