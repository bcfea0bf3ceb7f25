#include "precision/DevicePrecision.h"

#include "CachedCompiler.h"
#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"
#include "study/StudyBench.h"
#include "study/StudyFiles.h"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>

namespace limn::study
{
namespace
{

using test::CommandRun;
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
                HasSubstr("unknown technique 'stroke'; did you mean 'Strokes'?"));
    m_Working.folder.Write("bare.scene.yaml", "camera: {}\nobjects: [{name: Cube, mesh: cube}]\n");
    const CommandRun bare = RunCommand({"report", "bare.scene.yaml", "-o", "r"});
    EXPECT_EQ(bare.exitCode, 1);
    EXPECT_THAT(bare.err, HasSubstr("no active feature outlines anything"));
    const std::string away = std::string(k_Scene).replace(
        std::string(k_Scene).find("lookAt: [0, 0"), 13, "lookAt: [0, 9");
    m_Working.folder.Write("away.scene.yaml", away);
    const CommandRun unseen = RunCommand({"report", "away.scene.yaml", "-o", "r"});
    EXPECT_EQ(unseen.exitCode, 1);
    EXPECT_THAT(unseen.err,
                HasSubstr("none of the objects that it outlines is in the camera's view"));
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
                testing::ElementsAre("the camera draws 80x60 pixels (renderScale): its widths and "
                                     "errors are in these"));
    // A code of sRGB near white is 0.009 apart from the next.
    EXPECT_LT(error("ldr.scene.yaml", ", allowHDR: false"), 0.005 + 0.0045);
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
    EXPECT_EQ(wide.notes[0], "not drawn: it is 10 pixels wide at most");
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
        // The bound may be unknown; one that is known holds half of the pairs at least.
        const auto [lower, upper] = cell.quartiles.at("gpuAddedMilliseconds");
        EXPECT_FALSE(cell.Value("gpuAddedUncertainty") < (upper - lower) / 2.0);
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
