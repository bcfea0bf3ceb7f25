#include "Mentions.h"
#include "report/measure/StudyFiles.h"

#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"
#include "core/FileSizeLimit.h"

#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>

namespace limn::study
{
namespace
{

using test::CommandRun;
using test::Mentions;
using test::ReadText;
using test::RunCommand;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

CellId CellOf(const std::string& technique)
{
    return {CellKind::Geometry, technique, "disc", 2.0, 64, 48, ""};
}

Study TwoCells()
{
    Study study;
    study.scene = "room.scene.yaml";
    study.techniques = {{"A", "AFeature", "draws", true, ""}, {"B", "BFeature", "draws", true, ""}};
    study.planned = {CellOf("A"), CellOf("B")};
    return study;
}

/// A folder of results that somebody else made.
class ResultsFolder : public testing::Test
{
protected:
    void WriteCell(const std::string& folder, const std::string& technique,
                   const std::map<std::string, std::string>& pictures = {}) const
    {
        Study study = TwoCells();
        StudyFolder(folder, study)
            .Add({CellOf(technique), {{"meanAbsoluteError", 0.5}}, {}, {}, pictures});
    }

    static CommandRun Merge(std::vector<std::string> parts, const std::string& output)
    {
        parts.insert(parts.begin(), {"report", "--merge"});
        parts.insert(parts.end(), {"-o", output});
        return RunCommand(parts);
    }

    test::WorkingFolder m_Working;
    const test::TemporaryFolder& m_Folder = m_Working.folder;
};

TEST_F(ResultsFolder, MayNotNamePicturesOutsideOfItself)
{
    const std::filesystem::path victim = m_Folder.Write("victim.png", "precious");
    for (const std::string& name :
         {std::string("../victim.png"), victim.string(), std::string("pictures/../../victim.png"),
          std::string("pictures/../report.html"), std::string("")})
    {
        std::filesystem::remove_all("part");
        WriteCell("part", "A", {{"picture", name}});
        m_Folder.Write("part/" + name, "evil");
        m_Folder.Write("victim.png", "precious");
        const CommandRun run = Merge({"part"}, "merged");
        EXPECT_EQ(run.exitCode, 1) << name;
        EXPECT_THAT(run.err, HasSubstr("cells.jsonl:1:")) << name;
        EXPECT_THAT(run.err,
                    Mentions("cell.pictures", "'" + name + "'", "no picture", "pictures/disc.png"));
        EXPECT_EQ(ReadText(victim), "precious") << name;
        EXPECT_FALSE(std::filesystem::exists("merged")) << name;
    }
}

TEST_F(ResultsFolder, MayNotLeadOutOfItselfByLinks)
{
    const std::filesystem::path secret = m_Folder.Write("secret", "precious");
    WriteCell("part", "A", {{"picture", "pictures/a.png"}});
    std::filesystem::create_directory("part/pictures");
    std::filesystem::create_symlink(secret, "part/pictures/a.png");
    const CommandRun picture = Merge({"part"}, "merged");
    EXPECT_EQ(picture.exitCode, 1);
    EXPECT_THAT(picture.err, Mentions("part/pictures/a.png:", "link", "out of"));

    // A run that goes on would cut the file behind the link to its whole lines: to nothing.
    Study study = TwoCells();
    std::filesystem::create_directory("results");
    std::filesystem::create_symlink(secret, "results/cells.jsonl");
    EXPECT_THROW(StudyFolder("results", study), AssetError);
    EXPECT_EQ(ReadText(secret), "precious");

    // The report's own files are not written through links either.
    WriteCell("good", "A");
    std::filesystem::create_directory("target");
    std::filesystem::create_symlink(secret, "target/report.html");
    const CommandRun page = Merge({"good"}, "target");
    EXPECT_EQ(page.exitCode, 1);
    EXPECT_THAT(page.err, HasSubstr("target/report.html: error: this is a link"));
    EXPECT_EQ(ReadText(secret), "precious");

    // Nor is what a link leads to made where it is not there yet.
    for (const std::string name : {"study.json", "cells.jsonl", "report.html", "plots"})
    {
        std::filesystem::remove_all("fresh");
        std::filesystem::create_directory("fresh");
        std::filesystem::create_symlink("../nowhere", "fresh/" + name);
        const CommandRun fresh = Merge({"good"}, "fresh");
        EXPECT_EQ(fresh.exitCode, 1) << name;
        EXPECT_THAT(fresh.err, HasSubstr("fresh/" + name + ": error: this is a link"));
        EXPECT_FALSE(std::filesystem::exists("nowhere")) << name;
    }
}

TEST_F(ResultsFolder, IsMergedWithItsPicturesAndOnceMore)
{
    WriteCell("a", "A", {{"picture", "pictures/a.png"}});
    WriteCell("b", "B");
    m_Folder.Write("a/pictures/a.png", "a picture");
    for (int i = 0; i < 2; ++i)
    {
        const CommandRun run = Merge({"a", "b"}, "merged");
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_EQ(ReadText("merged/pictures/a.png"), "a picture");
        EXPECT_EQ(ReadStudy("merged").cells.size(), 2u);
    }
}

TEST_F(ResultsFolder, LosesNothingToAMerge)
{
    WriteCell("a", "A", {{"picture", "pictures/a.png"}});
    m_Folder.Write("a/pictures/a.png", "a picture");
    m_Folder.Write("mine/pictures/a.png", "precious");
    const CommandRun picture = Merge({"a"}, "mine");
    EXPECT_EQ(picture.exitCode, 1);
    EXPECT_THAT(picture.err, Mentions("mine/pictures/a.png:", "another picture", "a/pictures/a.png",
                                      "not overwritten"));
    EXPECT_EQ(ReadText("mine/pictures/a.png"), "precious");

    WriteCell("b", "B");
    const CommandRun cells = Merge({"a"}, "b");
    EXPECT_EQ(cells.exitCode, 1);
    EXPECT_THAT(cells.err, Mentions("b:", "geometry/B/disc/2/64x48", "new folder"));
    EXPECT_EQ(ReadStudy("b").cells.size(), 1u);

    const CommandRun itself = Merge({"a", "b"}, "./a");
    EXPECT_EQ(itself.exitCode, 1);
    EXPECT_THAT(itself.err, Mentions("folders that are merged", "new folder"));
    EXPECT_EQ(ReadStudy("a").cells.size(), 1u);
}

TEST_F(ResultsFolder, ThatIsMissingIsSaidToBeMissing)
{
    m_Folder.Write("file", "no folder");
    std::filesystem::create_directory("empty");
    const std::pair<std::string, std::vector<std::string>> cases[] = {
        {"nope", {"nope:", "no such folder"}},
        {"file", {"file:", "no folder", "'limn report'"}},
        {"empty", {"empty/study.json:", "no such file"}}};
    for (const auto& [folder, parts] : cases)
    {
        const CommandRun merge = Merge({folder}, "merged");
        EXPECT_EQ(merge.exitCode, 1);
        const auto isMissing = testing::ElementsAre(test::MentionsInOrder(parts));
        EXPECT_THAT(test::LinesOf(merge.err), isMissing);
        EXPECT_THAT(test::LinesOf(RunCommand({"report", "--compare", folder, "."}).err), isMissing);
    }
    EXPECT_FALSE(std::filesystem::exists("merged"));
}

TEST_F(ResultsFolder, IsWrittenByOneRunAtATime)
{
    Study study = TwoCells();
    const StudyFolder held("results", study);
    Study second = TwoCells();
    try
    {
        const StudyFolder other("results", second);
        FAIL() << "two runs have the folder";
    }
    catch (const AssetError& error)
    {
        EXPECT_THAT(error.what(), Mentions("results:", "another limn", "wait"));
    }
}

TEST_F(ResultsFolder, ThatHasNoRoomIsTheMachinesFault)
{
    Study study = TwoCells();
    StudyFolder folder("results", study);
    const test::FileSizeLimit limit(1);
    EXPECT_THROW(folder.Add({CellOf("A"), {{"meanAbsoluteError", 0.5}}, {}, {}, {}}), MachineError);
}

struct Tampered
{
    const char* file;
    const char* from;
    const char* to;
    std::vector<std::string> parts; ///< of what is said
};

class TamperedResults : public ResultsFolder, public testing::WithParamInterface<Tampered>
{
};

TEST_P(TamperedResults, AreRefusedAtTheirLineAndColumn)
{
    WriteCell("part", "A", {{"picture", "pictures/a.png"}});
    const Tampered& tampered = GetParam();
    std::string text = ReadText(std::string("part/") + tampered.file);
    const std::size_t at = text.find(tampered.from);
    ASSERT_NE(at, std::string::npos) << text;
    text.replace(at, std::string_view(tampered.from).size(), tampered.to);
    m_Folder.Write(std::string("part/") + tampered.file, text);
    const CommandRun run = Merge({"part"}, "merged");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, test::MentionsInOrder(tampered.parts));
    EXPECT_THAT(run.err, Not(HasSubstr("json.exception")));
    EXPECT_FALSE(std::filesystem::exists("merged"));
}

INSTANTIATE_TEST_SUITE_P(
    Each, TamperedResults,
    testing::Values(
        Tampered{"cells.jsonl", "64,", "6.5,", {"cells.jsonl:1:"}},
        Tampered{"cells.jsonl", "64,", "1e300,", {"whole number"}},
        Tampered{"cells.jsonl", "64,", "2000000000,", {"outside", "[0, 16384]"}},
        Tampered{"cells.jsonl",
                 "0.5",
                 "\"half\"",
                 {"cell.values.meanAbsoluteError", "'half'", "number", "\"nan\"", "\"-inf\""}},
        Tampered{"cells.jsonl",
                 "\"geometry\"",
                 "\"geometri\"",
                 {"unknown kind", "'geometri'", "'geometry'"}},
        Tampered{"cells.jsonl", "[64,48]", "[64]", {"list of two", "numbers"}},
        Tampered{"cells.jsonl", "\"notes\":[]", "\"notes\":{}", {"a list"}},
        Tampered{"cells.jsonl", "\"values\":{", "\"values\":[", {"cells.jsonl:1:"}},
        Tampered{"study.json", "\"room.scene.yaml\"", "[]", {"study.scene", "sequence", "text"}},
        Tampered{"study.json", "\"format\": 2,", "", {"study.json:1:1:", "another format", "2"}},
        Tampered{
            "study.json", "\"format\": 2,", "\"format\": 3,", {"another format", "another folder"}},
        Tampered{"study.json", "\"started\"", "\"begun\"", {"study", "'started'", "missing"}},
        Tampered{"study.json", "true", "\"yes\"", {"true or false"}},
        Tampered{"study.json", "\"device\"", "\"scene\"", {"study.json:"}}));

} // namespace
} // namespace limn::study
