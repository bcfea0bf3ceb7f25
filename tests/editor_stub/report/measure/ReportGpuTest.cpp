#include "Mentions.h"
#include "precision/DevicePrecision.h"

#include "CachedCompiler.h"
#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"
#include "report/measure/StudyBench.h"
#include "report/measure/StudyFiles.h"
#include "report/measure/StudyScene.h"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace limn::study
{
namespace
{

using test::CommandRun;
using test::Mentions;
using test::RunCommand;
using testing::HasSubstr;
using testing::StartsWith;

using Words = std::vector<std::string>;

constexpr const char* k_Scene = R"(size: [64, 36]
layers: {6: Furniture}
renderingLayers: {8: Selected}
camera: {position: [0, 1, -3], lookAt: [0, 0, 0]}
renderer:
  features:
    - {type: ScreenSpaceOutlineRenderFeature, m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline,
       m_LayerMask: Furniture, m_RenderingLayerMask: Selected}
objects:
  - {name: Floor, mesh: plane, position: [0, -0.5, 0]}
  - {name: Cube, mesh: cube, layer: Furniture, renderingLayerMask: [Default, Selected], rotation: [0, 30, 0]}
)";

class ReportGpu : public testing::Test
{
protected:
    ReportGpu() { m_Working.folder.Write("s.scene.yaml", k_Scene); }

    /// `limn report` of one technique, into this folder.
    static CommandRun Report(const std::string& folder, const Words& more = {})
    {
        Words words{"report",  "s.scene.yaml", "-o",          folder,
                    "--quick", "--technique",  "screen space"};
        words.insert(words.end(), more.begin(), more.end());
        return RunCommand(words);
    }

    static std::string Compared(const std::string& a, const std::string& b)
    {
        const CommandRun run = RunCommand({"report", "--compare", a, b});
        return run.exitCode == 0 && run.out.empty() ? run.err : run.out;
    }

    test::WorkingFolder m_Working;
};

std::size_t LineCount(const std::string& file)
{
    std::ifstream stream(file);
    std::size_t count = 0;
    for (std::string line; std::getline(stream, line);)
    {
        ++count;
    }
    return count;
}

TEST_F(ReportGpu, IsTheSameWhetherMeasuredAtOnceOrInPartsOrInterrupted)
{
    ASSERT_EQ(Report("whole").exitCode, 0);
    ASSERT_EQ(Report("a", {"--shard", "1/2"}).exitCode, 0);
    ASSERT_EQ(Report("b", {"--shard", "2/2"}).exitCode, 0);
    const std::size_t cells = ReadStudy("whole").cells.size();
    EXPECT_EQ(cells, ReadStudy("whole").planned.size());
    EXPECT_GT(LineCount("a/cells.jsonl"), 0u);
    EXPECT_GT(LineCount("b/cells.jsonl"), 0u);

    // Killed while it wrote its third cell, and begun again.
    const auto length = std::filesystem::file_size("b/cells.jsonl");
    std::ifstream file("b/cells.jsonl");
    std::string first, second;
    std::getline(file, first);
    std::getline(file, second);
    ASSERT_LT(first.size() + second.size() + 42, length);
    std::filesystem::resize_file("b/cells.jsonl", first.size() + second.size() + 42);
    ASSERT_EQ(Report("b", {"--shard", "2/2"}).exitCode, 0);

    const CommandRun merge = RunCommand({"report", "--merge", "a", "b", "-o", "merged"});
    EXPECT_EQ(merge.exitCode, 0) << merge.err;
    EXPECT_EQ(Compared("whole", "merged"), "note: " + std::to_string(cells) + " and " +
                                               std::to_string(cells) +
                                               " cells, 0 differ, times apart\n");

    const CommandRun part = RunCommand({"report", "--merge", "a", "-o", "part"});
    EXPECT_EQ(part.exitCode, 1);
    EXPECT_THAT(part.err, HasSubstr("warning: part: missing: "));
    EXPECT_THAT(Compared("whole", "part"), HasSubstr("only in the first"));
    const CommandRun json = RunCommand({"report", "--compare", "whole", "part", "--json"});
    EXPECT_EQ(json.exitCode, 1);
    EXPECT_EQ(nlohmann::json::parse(json.out)["cells"][0], cells);
    EXPECT_FALSE(nlohmann::json::parse(json.out)["differences"].empty());
}

TEST_F(ReportGpu, TellsTheSameAsJson)
{
    const CommandRun text = Report("r");
    const CommandRun run = Report("r", {"--json"}); // which takes over what is measured
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const nlohmann::json json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["files"][0], "r/report.html");
    EXPECT_THAT(text.err, testing::EndsWith(json["recommendation"].get<std::string>() + "\n"));
    const CommandRun merged = RunCommand({"report", "--merge", "r", "-o", "m", "--json"});
    const nlohmann::json reports = nlohmann::json::parse(merged.out)["reports"];
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0]["files"][0], "m/report.html");
    EXPECT_TRUE(reports[0]["missing"].empty());
}

TEST_F(ReportGpu, PrintsThePageAndWhatItBeginsWith)
{
    const CommandRun run = Report("r", {"--budget", "100000"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.out, "r/report.html\n");
    const std::string page = test::ReadText("r/report.md");
    std::istringstream lines(run.err);
    std::size_t sentences = 0;
    for (std::string line; std::getline(lines, line); ++sentences)
    {
        const std::string warning = "warning: ";
        EXPECT_THAT(page, HasSubstr(line.substr(line.starts_with(warning) ? warning.size() : 0)));
    }
    EXPECT_GE(sentences, 1u);
}

TEST_F(ReportGpu, RefusesWhatItCannotMeasure)
{
    EXPECT_THAT(RunCommand({"report", "s.scene.yaml", "-o", "r", "--technique", "stroke"}).err,
                Mentions("unknown technique", "'stroke'", "'Strokes'"));
    m_Working.folder.Write("bare.scene.yaml", "camera: {}\nobjects: [{name: Cube, mesh: cube}]\n");
    const CommandRun bare = RunCommand({"report", "bare.scene.yaml", "-o", "r"});
    EXPECT_EQ(bare.exitCode, 1);
    EXPECT_THAT(bare.err, HasSubstr("no active feature outlines anything"));
    const std::string away = std::string(k_Scene).replace(
        std::string(k_Scene).find("lookAt: [0, 0"), 13, "lookAt: [0, 9");
    m_Working.folder.Write("away.scene.yaml", away);
    const CommandRun unseen = RunCommand({"report", "away.scene.yaml", "-o", "r"});
    EXPECT_EQ(unseen.exitCode, 1);
    EXPECT_THAT(unseen.err, Mentions("none of the objects", "outlines", "view"));
    EXPECT_FALSE(std::filesystem::exists("r"));
    EXPECT_EQ(RunCommand({"report", "a", "b", "-o", "r"}).exitCode, 2);
}

/// What is found of strokes around a cube, in a scene with these lines in place of the plain
/// camera.
CellResult MeasureStrokes(const test::WorkingFolder& working, AssetContext& assets,
                          VulkanDevice& device, const std::string& name, const std::string& camera,
                          const std::string& more)
{
    const std::string head = "size: [160, 120]\n" + more + "camera: {position: [0, 1, -3], " +
                             "lookAt: [0, 0, 0]" + camera + "}\n";
    working.folder.Write(name, head + R"(renderingLayers: {8: Selected}
renderer:
  features: [{type: StrokeOutlineRendererFeature, m_RenderingLayerMask: Selected}]
objects:
  - {name: Floor, mesh: plane, position: [0, -0.5, 0]}
  - {name: Cube, mesh: cube, renderingLayerMask: [Default, Selected], rotation: [0, 30, 0]}
  - {name: Unseen, mesh: sphere, layer: 9, renderingLayerMask: [Selected], position: [1, 0, 0]}
  - {name: Off, mesh: sphere, active: false, renderingLayerMask: [Selected], position: [-1, 0, 0]}
)");
    StudyBench bench{working.folder / name, "", assets, device};
    const CellResult result =
        bench.Measure({CellKind::Geometry, "Strokes", "scene", 4.0, 160, 120, ""});
    EXPECT_GT(result.Value("bandPixels"), 300.0);
    return result;
}

TEST(StudyOfScenesGpu, IsOfTheOutlineWhateverTheCameraClearsAndStoresAndTheSceneHas)
{
    const test::WorkingFolder working;
    VulkanDevice device;
    AssetContext assets{test::CachedCompiler()};
    const auto error =
        [&](const std::string& name, const std::string& camera, const std::string& more = "")
    {
        const CellResult result =
            MeasureStrokes(working, assets, device, name, ", cullingMask: [0]" + camera, more);
        EXPECT_EQ(result.notes.empty(), !more.starts_with("renderScale")) << name;
        return result.Value("meanAbsoluteError");
    };
    EXPECT_LT(error("plain.scene.yaml", ""), 0.005);
    EXPECT_LT(error("sky.scene.yaml", ", clearFlags: Skybox",
                    "skybox: sky\nmaterials: {sky: {shader: Skybox/Procedural}}\n"),
              0.005);
    EXPECT_LT(error("white.scene.yaml", ", clearFlags: Skybox, backgroundColor: [1, 1, 1]"), 0.005);
    EXPECT_LT(error("half.scene.yaml", "", "renderScale: 0.5\n"), 0.01);
    EXPECT_LT(error("twice.scene.yaml", "", "renderScale: 2\n"), 0.005);
    EXPECT_THAT(MeasureStrokes(working, assets, device, "half.scene.yaml", ", cullingMask: [0]",
                               "renderScale: 0.5\n")
                    .notes,
                testing::ElementsAre(Mentions("80x60", "renderScale")));
    // A code of sRGB near white is 0.009 apart from the next.
    EXPECT_LT(error("ldr.scene.yaml", ", allowHDR: false"), 0.005 + 0.0045);
}

/// A box of 80 x 60 pixels in the middle of a picture of 160 x 120, its corners on those of pixels,
/// and what the lines say in front of it: a wall there covers all that is left of the middle.
class PartlyHiddenGpu : public testing::Test
{
protected:
    static constexpr int k_Width = 4; // pixels

    CellResult Measure(const std::string& technique, const std::string& variant,
                       const std::string& more, const std::string& mesh = "cube",
                       const std::string& camera = "")
    {
        m_Working.folder.Write("hidden.scene.yaml", R"(size: [160, 120]
layers: {9: Away}
renderingLayers: {8: Selected}
camera: {orthographic: true, orthographicSize: 60, position: [0, 0, -100], nearClipPlane: 1)" +
                                                        camera +
                                                        R"(}
materials:
  glass: {shader: Universal Render Pipeline/Unlit, renderQueue: 3000}
  both: {shader: Universal Render Pipeline/Unlit, _Cull: 0}
renderer:
  features: [{type: StrokeOutlineRendererFeature, m_RenderingLayerMask: Selected}]
objects:
  - {name: Box, mesh: )" + mesh + R"(, scale: [80, 60, 40], renderingLayerMask: [Default, Selected]}
)" + more);
        StudyBench bench{m_Working.folder / "hidden.scene.yaml", "", m_Assets, m_Device};
        return bench.Measure({CellKind::Geometry, technique, "scene", k_Width, 160, 120, variant});
    }

    bool isPartlyHidden()
    {
        SceneAsset scene = LoadScene(m_Working.folder / "hidden.scene.yaml", m_Assets);
        MarkOutlined(scene);
        return IsPartlyHidden(scene);
    }

    /// Counts the pixels that a half of the outline touches: beside half of the upper side, half of
    /// the lower one, a short side and in two corners.
    static int PixelsOfHalf()
    {
        int corner = 0;
        for (int y = 0; y < k_Width; ++y)
        {
            for (int x = 0; x < k_Width; ++x)
            {
                corner += x * x + y * y < k_Width * k_Width ? 1 : 0; // its nearest place to the box
            }
        }
        return k_Width * (40 + 40 + 60) + 2 * corner;
    }

    /// A few pixels in each corner, which the arc passes by less than a pixel away, may be compared
    /// as well: the drawn line gives them 1/70.
    static void ExpectHalves(int halves, const CellResult& cell)
    {
        EXPECT_GE(cell.Value("bandPixels"), halves * PixelsOfHalf());
        EXPECT_LE(cell.Value("bandPixels"), halves * (PixelsOfHalf() + 2 * 4));
        EXPECT_LT(cell.Value("meanAbsoluteError"), 0.005);
        EXPECT_NEAR(cell.Value("areaRatio"), 1.0, 0.005);
    }

    test::WorkingFolder m_Working;
    VulkanDevice m_Device;
    AssetContext m_Assets{test::CachedCompiler()};
};

constexpr const char* k_Wall =
    "  - {name: Wall, mesh: cube, scale: [80, 200, 10], position: [-40, 0, -50]}\n";

TEST_F(PartlyHiddenGpu, IsMeasuredAgainstTheWholeTheSeenAndTheHiddenPart)
{
    const CellResult whole = Measure("Strokes", "", k_Wall);
    EXPECT_TRUE(isPartlyHidden());
    ExpectHalves(2, whole);
    EXPECT_THAT(whole.notes, testing::ElementsAre(Mentions("whole outline", "Wall", "in front")));
    const CellResult seen = Measure("Strokes", "seen part", k_Wall);
    EXPECT_THAT(seen.notes, testing::ElementsAre(Mentions("visible part", "Wall", "in front")));
    const CellResult hidden = Measure("Strokes", "hidden part", k_Wall);
    EXPECT_THAT(hidden.notes, testing::ElementsAre(Mentions("hidden part", "Wall", "in front")));
    for (const CellResult* part : {&seen, &hidden})
    {
        ExpectHalves(1, *part);
        EXPECT_FALSE(part->Has("contourOuter")) << "where it is cut off is no contour's end";
    }
}

TEST_F(PartlyHiddenGpu, IsHiddenByWhatTheCameraDrawsOpaqueInFrontAndByNothingElse)
{
    const char* const others[] = {
        "  - {name: Behind, mesh: cube, scale: [80, 200, 10], position: [-40, 0, 50]}\n",
        "  - {name: Beside, mesh: cube, scale: [20, 200, 10], position: [-60, 0, -50]}\n",
        "  - {name: Glass, mesh: cube, scale: [80, 200, 9], position: [-40, 0, -50], material: "
        "glass}\n",
        "  - {name: Away, mesh: cube, scale: [80, 200, 9], position: [-40, 0, -50], layer: Away}\n",
        "  - {name: Shadow, mesh: cube, scale: [80, 200, 9], position: [-40, 0, -50], "
        "shadowCastingMode: ShadowsOnly}\n",
        "  - {name: Off, mesh: cube, scale: [80, 200, 9], position: [-40, 0, -50], active: "
        "false}\n",
        "  - {name: Back, mesh: quad, scale: [80, 200, 1], position: [-40, 0, -50], rotation: [0, "
        "180, 0]}\n",
    };
    for (const char* other : others)
    {
        const CellResult seen =
            Measure("Strokes", "seen part", other, "cube", ", cullingMask: [0]");
        SCOPED_TRACE(other);
        EXPECT_FALSE(isPartlyHidden());
        EXPECT_THAT(seen.notes, testing::IsEmpty());
        ExpectHalves(2, seen);
    }
    const CellResult sheet =
        Measure("Strokes", "seen part",
                "  - {name: Sheet, mesh: quad, scale: [80, 200, 1], position: [-40, 0, -50], "
                "rotation: [0, 180, 0], material: both}\n");
    EXPECT_TRUE(isPartlyHidden());
    ExpectHalves(1, sheet);
}

TEST_F(PartlyHiddenGpu, IsTheReferenceOfAHullWhichSomethingHides)
{
    const CellResult alone = Measure("Inflated", "", "", "sphere");
    const CellResult behind = Measure("Inflated", "", k_Wall, "sphere");
    EXPECT_TRUE(alone.notes.empty());
    EXPECT_THAT(behind.notes, testing::ElementsAre(Mentions("visible part", "Wall", "in front")));
    // The picture and the ball are the same on both sides of the middle.
    EXPECT_NEAR(behind.Value("bandPixels"), 0.5 * alone.Value("bandPixels"), 1.0);
    EXPECT_NEAR(behind.Value("areaRatio"), alone.Value("areaRatio"), 0.01);
    EXPECT_NEAR(behind.Value("meanAbsoluteError"), alone.Value("meanAbsoluteError"), 0.01);
}

TEST_F(ReportGpu, SaysWhatStandsInFrontAndWhichCamerasItLeavesOut)
{
    const std::string plain = k_Scene;
    const std::string wall = "  - {name: Wall, mesh: cube, position: [-0.5, 0.3, -1], "
                             "scale: [1, 3, 0.1]}\n";
    const std::string stack = ", cameraStack: [{position: [0, 1, -3], lookAt: [0, 0, 0]}]}";
    const std::size_t camera = plain.find("lookAt: [0, 0, 0]}") + 17;
    m_Working.folder.Write("s.scene.yaml", std::string(plain).replace(camera, 1, stack) + wall);
    const CommandRun run = Report("r", {"--technique", "strokes"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::string page = test::ReadText("r/report.md");
    const std::vector<std::string> notes[] = {
        {"Strokes, Screen space:", "whole outline", "Wall"},
        {"Strokes (seen part):", "visible part", "Wall"},
        {"Strokes (hidden part):", "hidden part", "Wall"},
        {"The scene:", "base camera", "overlay camera", "cameraStack", "times", "errors"}};
    for (const std::vector<std::string>& parts : notes)
    {
        EXPECT_THAT(test::LinesOf(run.err), testing::Contains(test::MentionsInOrder(parts)));
        EXPECT_THAT(test::LinesOf(page), testing::Contains(test::MentionsInOrder(parts)));
    }
    EXPECT_THAT(page, HasSubstr("What is seen and what is hidden of the outline"));
}

TEST_F(ReportGpu, WritesTheNameOfWhatStandsInFrontAsText)
{
    m_Working.folder.Write("s.scene.yaml",
                           std::string(k_Scene) +
                               "  - {name: \"<b>Wall\\nerror: \\e[31m\", mesh: cube, position: "
                               "[-0.5, 0.3, -1], scale: [1, 3, 0.1]}\n");
    const CommandRun run = Report("r");
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("also where <b>Wall"));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("\nerror: ")));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("\033[31m")));
    const std::string page = test::ReadText("r/report.html");
    EXPECT_THAT(page, HasSubstr("also where &lt;b&gt;Wall"));
    EXPECT_THAT(page, testing::Not(HasSubstr("<b>Wall")));
}

TEST_F(ReportGpu, RefusesAnOutlineThatOnlyAnOverlayDraws)
{
    const std::string plain = k_Scene;
    const std::string stack = ", cullingMask: [0], cameraStack: [{position: [0, 1, -3]}]}";
    const std::size_t camera = plain.find("lookAt: [0, 0, 0]}") + 17;
    m_Working.folder.Write("s.scene.yaml", std::string(plain).replace(camera, 1, stack));
    const CommandRun run = Report("r");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, Mentions("none of its 2 objects", "cameraStack", "not measured"));
    // limn's cameras draw over the whole picture.
    m_Working.folder.Write("s.scene.yaml",
                           std::string(plain).replace(camera, 1, ", rect: [0, 0, 0.5, 1]}"));
    EXPECT_THAT(Report("r").err, HasSubstr("'rect'"));
    EXPECT_FALSE(std::filesystem::exists("r"));
}

TEST(StudyOfScenesGpu, IsOfTheBaseCameraAndItsTimesAreOfAllCameras)
{
    const test::WorkingFolder working;
    VulkanDevice device;
    AssetContext assets{test::CachedCompiler()};
    const std::string overlay = "{position: [0, 1, -2], lookAt: [0, 0, 0], cullingMask: [0]}";
    const CellResult stack =
        MeasureStrokes(working, assets, device, "stack.scene.yaml",
                       ", cullingMask: [0], cameraStack: [" + overlay + ", " + overlay + "]", "");
    EXPECT_LT(stack.Value("meanAbsoluteError"), 0.005);
    EXPECT_THAT(stack.notes, testing::ElementsAre(Mentions("base camera", "2 overlay cameras",
                                                           "cameraStack", "times", "errors")));
    MeasureStrokes(working, assets, device, "one.scene.yaml", ", cullingMask: [0]", "");
    const auto draws = [&](const char* scene)
    {
        StudyBench bench{working.folder / scene, "", assets, device};
        const CellId id{CellKind::Cost, "Strokes", "scene", 4.0, 160, 120, ""};
        return bench.MeasureCosts(std::span(&id, 1), 1).front().Value("draws");
    };
    // The cube's own depth, its strokes and the composite, for either overlay.
    EXPECT_EQ(draws("stack.scene.yaml"), draws("one.scene.yaml") + 2 * 3);
}

class StudyBenchGpu : public testing::Test
{
protected:
    CellResult Measure(CellKind kind, const std::string& technique, double width)
    {
        return m_Bench.Measure({kind, technique, "disc", width, 96, 64, ""});
    }

    VulkanDevice m_Device;
    AssetContext m_Assets{test::CachedCompiler()};
    StudyBench m_Bench{"", "", m_Assets, m_Device};
};

TEST_F(StudyBenchGpu, FindsStrokesExactAndTheArticlesMaskTooWide)
{
    const CellResult strokes = Measure(CellKind::Geometry, "Strokes", 4.0);
    EXPECT_LT(strokes.Value("meanAbsoluteError"), 0.004);
    EXPECT_NEAR(strokes.Value("areaRatio"), 1.0, 0.01);
    // Contours are looked at a pixel apart, and the device may move corners along both axes.
    EXPECT_LT(strokes.Value("hausdorff"), 0.5 + std::sqrt(2.0) * test::SubPixel());
    EXPECT_NEAR(strokes.Value("contourOuter"), 0.0, 0.02);
    const CellResult article = Measure(CellKind::Geometry, "Screen space", 4.0);
    EXPECT_GT(article.Value("areaRatio"), 1.1);
    EXPECT_GT(article.Value("meanAbsoluteError"), 0.2);
}

TEST_F(StudyBenchGpu, SaysWhyThereAreNoFigures)
{
    const CellResult wide = Measure(CellKind::Geometry, "Screen space", 64.0);
    ASSERT_EQ(wide.notes.size(), 1u);
    EXPECT_THAT(wide.notes[0], Mentions("not drawn", "10 pixels"));
    const CellResult rim = Measure(CellKind::Geometry, "Rim", 4.0);
    ASSERT_EQ(rim.notes.size(), 1u);
    EXPECT_THAT(rim.notes[0], StartsWith("not compared: "));
    EXPECT_TRUE(wide.values.empty());
    EXPECT_TRUE(rim.values.empty());
}

TEST_F(StudyBenchGpu, SeesTheArticlesMaskFlickerAndStrokesHold)
{
    const CellResult strokes = Measure(CellKind::Temporal, "Strokes", 2.0);
    const CellResult article = Measure(CellKind::Temporal, "Screen space", 2.0);
    EXPECT_LT(strokes.Value("flicker"), 0.01);
    // A third of the pixels of an outline that is 2 wide and has soft borders are on the object's
    // border. The device may say of 2 SubPixel() of the places where that may pass a pixel's centre
    // that it is on the other side, and half of the pixel's coverage goes by it.
    const double rounded = 1.0 / 3.0 * 2.0 * test::SubPixel() * 0.5;
    EXPECT_GT(article.Value("flicker"), 10.0 * (strokes.Value("flicker") - rounded));
    EXPECT_LT(strokes.Value("areaWobble"), article.Value("areaWobble"));
    EXPECT_LT(strokes.Value("areaHigh") - strokes.Value("areaLow"), 0.01);
}

TEST_F(StudyBenchGpu, TakesTheTimeOfTechniquesInTurn)
{
    const CellId strokes{CellKind::Cost, "Strokes", "balls", 4.0, 96, 64, "3 objects"};
    CellId article = strokes;
    article.technique = "Screen space";
    const CellId ids[] = {strokes, article};
    const std::vector<CellResult> cells = m_Bench.MeasureCosts(ids, 9);
    ASSERT_EQ(cells.size(), 2u);
    for (const CellResult& cell : cells)
    {
        EXPECT_GT(cell.Value("gpuMilliseconds"), 0.0);
        const auto [low, high] = cell.quartiles.at("gpuMilliseconds");
        EXPECT_LE(low, cell.Value("gpuMilliseconds"));
        EXPECT_GE(high, cell.Value("gpuMilliseconds"));
        // The bound may be unknown, and after many rounds it is narrower than the quartiles, since
        // it is the median's: StatisticsUnsanitizedTest has what it promises.
        EXPECT_TRUE(cell.quartiles.contains("gpuAddedMilliseconds"));
        EXPECT_FALSE(cell.Value("gpuAddedUncertainty") < 0.0);
        EXPECT_GT(cell.Value("quietMilliseconds"), 0.0);
        EXPECT_GT(cell.Value("busyMilliseconds"), 0.0);
        EXPECT_GE(cell.Value("quietPart"), 0.0);
        EXPECT_LE(cell.Value("quietPart"), 1.0);
        EXPECT_GE(cell.Value("passes"), 1.0);
        EXPECT_GT(cell.Value("floorMilliseconds"), 0.0);
    }
    // Three discs of 24 pixels, of which the article draws a mask.
    EXPECT_GT(cells[1].Value("targetBytes"), 0.0);
}

} // namespace
} // namespace limn::study
