#include "TemporaryFolder.h"
#include "report/pages/ReportText.h"
#include "report/pages/SampleStudy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/Image.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three techniques, measured 8 px wide, and an article's without an error. Each has a picture of
/// the scene at 2, 8 and 32 px.
study::Study PicturedStudy(const std::string& kind = "closeUp")
{
    study::Study sample = ThreeTechniques();
    sample.techniques[3] = {"Theirs", "", "", true, "it has no width"};
    for (const Technique& technique : sample.techniques)
    {
        for (const double width : {2.0, 8.0, 32.0})
        {
            AddCell(sample, {study::CellKind::Geometry, technique.name, "scene", width, 64, 64, ""},
                    {})
                .pictures = {{kind, technique.name + std::to_string(int(width)) + ".png"}};
        }
    }
    return sample;
}

std::vector<study::Tile> TilesIn(const study::Study& sample, std::string* caption = nullptr)
{
    const study::Comparison comparison = Compare(sample);
    std::string text;
    std::vector<study::Tile> tiles =
        TilesOf(sample, comparison, &comparison.standings[0], caption ? *caption : text);
    return tiles;
}

std::vector<std::string> TextsOf(const std::vector<study::Tile>& tiles,
                                 std::string study::Tile::*member)
{
    std::vector<std::string> texts;
    for (const study::Tile& tile : tiles)
    {
        texts.push_back(tile.*member);
    }
    return texts;
}

TEST(ReportTiles, BeginWithTheLeastErrorAndHaveErrorAndTime)
{
    std::string caption;
    const std::vector<study::Tile> tiles = TilesIn(PicturedStudy(), &caption);
    EXPECT_THAT(TextsOf(tiles, &study::Tile::technique),
                ElementsAre("Slow", "Quick", "Bad", "Theirs"));
    EXPECT_THAT(TextsOf(tiles, &study::Tile::picture),
                ElementsAre("Slow8.png", "Quick8.png", "Bad8.png", "Theirs8.png"));
    EXPECT_THAT(TextsOf(tiles, &study::Tile::error),
                ElementsAre("error 0.001", "error 0.1", "error 0.5", "error not compared"));
    EXPECT_THAT(TextsOf(tiles, &study::Tile::time),
                ElementsAre("10 ± 1 ms", "1 ± 0.1 ms", "12 ± 1.2 ms", "time not measured"));
    EXPECT_TRUE(tiles[0].isRecommended);
    EXPECT_FALSE(tiles[1].isRecommended);
    EXPECT_FALSE(tiles[2].isArticle);
    EXPECT_TRUE(tiles[3].isArticle);
    EXPECT_THAT(caption, HasSubstr("The same part of the scene"));
    EXPECT_THAT(caption, HasSubstr("8 px wide"));
}

TEST(ReportTiles, ShowNoTimeThatTheRunDoesNotKnow)
{
    study::Study sample = PicturedStudy();
    sample.cells[1].values["gpuAddedUncertainty"] = 11.0; // of Slow's 10 ms
    sample.cells[3].values.erase("gpuAddedUncertainty");  // of Quick's 1 ms
    EXPECT_THAT(TextsOf(TilesIn(sample), &study::Tile::time),
                ElementsAre("at most 21 ms", "time not known", "12 ± 1.2 ms", "time not measured"));
}

TEST(ReportTiles, AreOfAShapeWhereThereIsNoScene)
{
    study::Study sample = PicturedStudy("picture");
    for (study::CellResult& cell : sample.cells)
    {
        cell.id.subject = "disc";
    }
    std::string caption;
    EXPECT_THAT(TextsOf(TilesIn(sample, &caption), &study::Tile::picture),
                ElementsAre("Slow8.png", "Quick8.png", "Bad8.png", "Theirs8.png"));
    EXPECT_THAT(caption, HasSubstr("The same part of 'disc'"));
    EXPECT_THAT(TilesIn(ThreeTechniques()), IsEmpty()) << "it has no pictures";
}

TEST(ReportTiles, StandBeforeTheAnswerOnBothPages)
{
    const TemporaryFolder folder;
    const study::Study sample = PicturedStudy();
    const Image image{2, 2, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(16)};
    for (const char* name : {"Slow8.png", "Quick8.png", "Bad8.png", "Theirs8.png"})
    {
        WritePng(folder / name, image);
    }
    study::ReportOptions options;
    options.budgetMilliseconds = 2.0;
    const study::ReportText report = ReportOf(sample, Compare(sample), options);
    EXPECT_THAT(report.recommendation, testing::StartsWith("Within 2 ms take Quick: "));
    EXPECT_THAT(report.more, testing::StartsWith("More time buys less error: Slow"));
    const std::string html = HtmlPage(report, folder.path(), {});
    const std::string markdown = MarkdownPage(report, {});
    for (const std::string& page : {html, markdown})
    {
        const std::size_t picture = page.find("0.001");
        const std::size_t answer = page.find("Within 2 ms take Quick");
        const std::size_t more = page.find("More time buys");
        ASSERT_NE(std::string::npos, more);
        EXPECT_LT(picture, answer);
        EXPECT_LT(answer, more);
        EXPECT_LT(more, page.find("All techniques at 8 px"));
    }
    EXPECT_THAT(markdown, HasSubstr("| ![Quick](Quick8.png) | **Quick**, recommended | error 0.1 | "
                                    "1 ± 0.1 ms |\n"));
    EXPECT_THAT(markdown, HasSubstr("| ![Theirs](Theirs8.png) | Theirs, an article's | "));
}

} // namespace

} // namespace limn::test
