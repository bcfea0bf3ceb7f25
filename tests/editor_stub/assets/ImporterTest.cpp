#include "assets/Importer.h"

#include "Mentions.h"
#include "TemporaryFolder.h"

#include <fstream>
#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>
#include <limn/base/WorkerProcess.h>

namespace limn::test
{
namespace
{

using testing::HasSubstr;
using namespace std::chrono_literals;

int s_Imports = 0; ///< in this process

std::string ImportForTest(const ImportedFile& file)
{
    ++s_Imports;
    if (file.bytes == "abort")
    {
        std::abort();
    }
    for (volatile bool isEndless = file.bytes == "endless"; isEndless;)
    {
    }
    if (file.bytes == "memory")
    {
        throw std::bad_alloc();
    }
    if (file.bytes == "broken")
    {
        throw AssetError(file.path.generic_string(), {3, 4}, "it is broken");
    }
    return std::string(file.bytes) + "+" + file.settings;
}

constexpr ImportKind k_Thing{"thing", "thing 1", ImportInWorker<ImportForTest>};
constexpr ImportKind k_NewThing{"thing", "thing 2", ImportInWorker<ImportForTest>};

class ImporterTest : public testing::Test
{
protected:
    ImporterTest() { s_Imports = 0; }

    Importer Make(bool isIsolated, std::chrono::milliseconds limit = 30s) const
    {
        Importer::Options options;
        options.cacheFolder = m_Folder / "cache";
        options.timeLimit = limit;
        if (isIsolated)
        {
            options.process = std::make_shared<WorkerProcess>();
        }
        return Importer(std::move(options));
    }
    static std::string Import(const Importer& importer, const std::string& bytes,
                              const std::string& settings = "s", const ImportKind& kind = k_Thing)
    {
        return std::string(importer.Import(kind, "a.thing", settings, bytes).payload());
    }
    static std::string ProblemOf(const Importer& importer, const std::string& bytes)
    {
        try
        {
            Import(importer, bytes);
        }
        catch (const AssetError& error)
        {
            return ToString(error.diagnostics().front());
        }
        return "";
    }

    TemporaryFolder m_Folder;
};

TEST_F(ImporterTest, GivesTheSameInThisProcessInAnotherAndFromTheCache)
{
    const Importer isolated = Make(true);
    EXPECT_EQ(Import(isolated, "abc"), "abc+s");
    EXPECT_EQ(s_Imports, 0) << "another process did it";
    const Importer here = Make(false);
    EXPECT_EQ(Import(here, "abc"), "abc+s");
    EXPECT_EQ(s_Imports, 0) << "it was kept";
    EXPECT_EQ(Import(here, "other"), "other+s");
    EXPECT_EQ(Import(here, "abc", "t"), "abc+t");
    EXPECT_EQ(Import(here, "abc", "s", k_NewThing), "abc+s");
    EXPECT_EQ(s_Imports, 3) << "bytes, settings and version tell imports apart";
    EXPECT_EQ(Import(Importer(), "abc"), "abc+s");
    EXPECT_EQ(s_Imports, 4) << "without a folder nothing is kept";
}

TEST_F(ImporterTest, ImportsAgainWhereAnEntryIsDamaged)
{
    const Importer importer = Make(false);
    Import(importer, "abc");
    for (const auto& entry : std::filesystem::directory_iterator(m_Folder / "cache"))
    {
        std::fstream file(entry.path());
        file.seekp(-12, std::ios::end);
        file << "X";
    }
    EXPECT_EQ(Import(importer, "abc"), "abc+s");
    EXPECT_EQ(s_Imports, 2);
    EXPECT_EQ(Import(importer, "abc"), "abc+s");
    EXPECT_EQ(s_Imports, 2) << "the entry was replaced";
}

TEST_F(ImporterTest, ImportsWhereNothingCanBeKept)
{
    m_Folder.Write("cache", "a file in the folder's place");
    EXPECT_EQ(Import(Make(true), "abc"), "abc+s");
}

TEST_F(ImporterTest, SurvivesAnImportThatCrashesOrNeverEnds)
{
    const Importer importer = Make(true, 200ms);
    EXPECT_THAT(ProblemOf(importer, "abort"),
                Mentions("a.thing:", "importer stopped", "Aborted", "signal 6"));
    EXPECT_THAT(ProblemOf(importer, "endless"),
                Mentions("a.thing:", "longer than 200 ms", "smaller"));
    EXPECT_EQ(Import(importer, "abc"), "abc+s");
}

TEST_F(ImporterTest, PassesOnWhatIsWrongAndKeepsNoneOfIt)
{
    for (const bool isIsolated : {false, true})
    {
        const Importer importer = Make(isIsolated);
        EXPECT_EQ(ProblemOf(importer, "broken"), "a.thing:3:4: error: it is broken");
        EXPECT_THAT(ProblemOf(importer, "memory"), HasSubstr("not enough memory"));
    }
    EXPECT_FALSE(std::filesystem::exists(m_Folder / "cache"));
}

TEST_F(ImporterTest, NamesAPointerOfGitLfsAndAnEmptyFile)
{
    const auto problemOf = [&](const std::string& bytes)
    {
        try
        {
            ReadForImport(k_Thing, m_Folder.Write("a.thing", bytes));
        }
        catch (const AssetError& error)
        {
            return error.diagnostics().front().message;
        }
        return std::string();
    };
    EXPECT_THAT(problemOf("version https://git-lfs.github.com/spec/v1\noid sha256:1\nsize 3\n"),
                Mentions("Git LFS", "thing", "'git lfs pull'"));
    EXPECT_THAT(problemOf(""), Mentions("empty", "a thing"));
    EXPECT_EQ(problemOf("x"), "");
    EXPECT_THROW(ReadForImport(k_Thing, m_Folder / "none.thing"), AssetError);
}

} // namespace
} // namespace limn::test
