#include "report/measure/StudyFiles.h"

#include "Mentions.h"
#include "commands/WorkingFolder.h"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <limn/base/Diagnostic.h>

namespace limn::study
{
namespace
{

using test::Mentions;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CellId Cell(const std::string& technique, double width, CellKind kind = CellKind::Geometry)
{
    return {kind, technique, "disc", width, 64, 48, ""};
}

CellResult Result(const CellId& id, double error)
{
    return {id, {{"meanAbsoluteError", error}}, {}, {}, {}};
}

Study Planned()
{
    Study study;
    study.scene = "room.scene.yaml";
    study.sceneHash = "1234";
    study.device = "device";
    study.options = "quick";
    study.limnVersion = "1.0";
    study.started = "2026-11-22T10:00:00Z";
    study.techniques = {{"A", "AFeature", "draws", true, "has none"}};
    study.planned = {Cell("A", 2.0), Cell("B", 2.0), Cell("A", 8.0)};
    return study;
}

class StudyFiles : public testing::Test
{
protected:
    std::filesystem::path Folder() const { return m_Working.folder / "study"; }
    std::filesystem::path CellsOf() const { return Folder() / "cells.jsonl"; }

    test::WorkingFolder m_Working;
};

TEST_F(StudyFiles, ReadWhatWasWrittenWithEveryKindOfNumber)
{
    Study study = Planned();
    CellResult cell = Result(Cell("A", std::numeric_limits<double>::infinity()), 0.1);
    cell.values["largest"] = std::numeric_limits<double>::quiet_NaN();
    cell.values["hausdorff"] = -std::numeric_limits<double>::infinity();
    cell.quartiles["gpuMilliseconds"] = {1.0 / 3.0, 2.0};
    cell.notes = {"a sentence with \"quotes\""};
    cell.pictures = {{"picture", "pictures/a.png"}};
    StudyFolder(Folder(), study).Add(cell);

    const Study read = ReadStudy(Folder());
    EXPECT_EQ(read.scene, study.scene);
    EXPECT_EQ(read.started, study.started);
    ASSERT_EQ(read.planned.size(), 3u);
    EXPECT_EQ(read.planned[2].Name(), "geometry/A/disc/8/64x48");
    ASSERT_EQ(read.techniques.size(), 1u);
    EXPECT_TRUE(read.techniques[0].isArticle);
    ASSERT_EQ(read.cells.size(), 1u);
    EXPECT_EQ(read.cells[0].id.Name(), "geometry/A/disc/inf/64x48");
    EXPECT_EQ(read.cells[0].Value("meanAbsoluteError"), 0.1);
    EXPECT_TRUE(std::isnan(read.cells[0].Value("largest")));
    EXPECT_EQ(read.cells[0].Value("hausdorff"), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(read.cells[0].quartiles, cell.quartiles);
    EXPECT_EQ(read.cells[0].notes, cell.notes);
    EXPECT_EQ(read.cells[0].pictures, cell.pictures);
}

TEST_F(StudyFiles, GoOnBehindTheLastWholeLine)
{
    {
        Study study = Planned();
        StudyFolder(Folder(), study).Add(Result(Cell("A", 2.0), 0.5));
    }
    std::ofstream(CellsOf(), std::ios::app) << "{\"cell\": \"geometry/B/di"; // killed here
    Study study = Planned();
    study.started = "2026-11-22T11:00:00Z";
    StudyFolder folder(Folder(), study);
    EXPECT_TRUE(folder.Has(Cell("A", 2.0)));
    EXPECT_FALSE(folder.Has(Cell("B", 2.0)));
    EXPECT_EQ(study.started, "2026-11-22T10:00:00Z");
    folder.Add(Result(Cell("B", 2.0), 0.25));
    const Study read = ReadStudy(Folder());
    ASSERT_EQ(read.cells.size(), 2u);
    EXPECT_EQ(read.cells[1].Value("meanAbsoluteError"), 0.25);
}

TEST_F(StudyFiles, RefuseAnotherStudysFolder)
{
    Study study = Planned();
    StudyFolder(Folder(), study).Update();
    Study other = Planned();
    other.sceneHash = "5678";
    try
    {
        StudyFolder(Folder(), other).Update();
        FAIL() << "taken";
    }
    catch (const AssetError& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("another scene ('1234', not '5678')"));
    }
}

TEST_F(StudyFiles, SayWhichLineIsNoCell)
{
    Study study = Planned();
    StudyFolder(Folder(), study).Add(Result(Cell("A", 2.0), 0.5));
    std::ofstream(CellsOf(), std::ios::app) << "{\"cell\": 1}\n";
    try
    {
        ReadStudy(Folder());
        FAIL() << "read";
    }
    catch (const AssetError& error)
    {
        EXPECT_THAT(error.what(), Mentions("cells.jsonl:2:1:", "cell", "'id'", "missing"));
    }
    EXPECT_THROW(ReadStudy(m_Working.folder / "nothing"), AssetError);
}

TEST(MergeStudies, PutsCellsInThePlannedOrderAndNamesWhatIsMissingAndDoubled)
{
    Study first = Planned();
    first.cells = {Result(Cell("A", 8.0), 0.1), Result(Cell("A", 2.0), 0.2)};
    Study second = Planned();
    second.started = "2026-11-22T09:00:00Z";
    second.cells = {Result(Cell("A", 2.0), 0.3)};
    const Study parts[] = {first, second};
    const std::vector<MergedStudy> merged = MergeStudies(parts);
    ASSERT_EQ(merged.size(), 1u);
    ASSERT_EQ(merged[0].study.cells.size(), 2u);
    EXPECT_EQ(merged[0].study.cells[0].Value("meanAbsoluteError"), 0.2) << "the first one's stands";
    EXPECT_EQ(merged[0].study.cells[1].id.width, 8.0);
    EXPECT_EQ(merged[0].study.started, second.started);
    EXPECT_THAT(merged[0].missing, ElementsAre("geometry/B/disc/2/64x48"));
    EXPECT_THAT(merged[0].doubled, ElementsAre("geometry/A/disc/2/64x48"));
}

TEST(MergeStudies, KeepsDevicesApart)
{
    Study parts[] = {Planned(), Planned(), Planned()};
    parts[1].device = "another";
    std::size_t next = 0;
    for (Study& part : parts)
    {
        part.cells = {Result(part.planned[next++], 0.1)};
    }
    const std::vector<MergedStudy> merged = MergeStudies(parts);
    ASSERT_EQ(merged.size(), 2u);
    EXPECT_EQ(merged[0].study.cells.size(), 2u);
    EXPECT_EQ(merged[1].study.device, "another");
    EXPECT_EQ(merged[1].missing.size(), 2u);
}

TEST(CompareStudies, PassesOverWhatIsMeasuredAndNothingElse)
{
    Study first = Planned();
    first.cells = {Result(Cell("A", 2.0, CellKind::Cost), 0.1), Result(Cell("B", 2.0), 0.1)};
    first.cells[0].values["gpuMilliseconds"] = 1.0;
    first.cells[0].quartiles["gpuMilliseconds"] = {0.5, 2.0};
    Study second = first;
    second.cells[0].values["gpuMilliseconds"] = 7.0;
    second.cells[0].quartiles["gpuMilliseconds"] = {6.0, 8.0};
    EXPECT_THAT(CompareStudies(first, second), IsEmpty());

    second.cells[1].values["meanAbsoluteError"] = std::nextafter(0.1, 1.0);
    EXPECT_THAT(CompareStudies(first, second), ElementsAre(HasSubstr("geometry/B/disc/2/64x48: ")));
    second.cells.pop_back();
    EXPECT_THAT(CompareStudies(first, second),
                ElementsAre("geometry/B/disc/2/64x48: only in the first"));
    EXPECT_THAT(CompareStudies(second, first),
                ElementsAre("geometry/B/disc/2/64x48: only in the second"));
}

} // namespace
} // namespace limn::study
