#include "Mentions.h"
#include "commands/CommandRun.h"
#include "console/FitLines.h"
#include "vulkan/GpuTestDevice.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using nlohmann::json;
using testing::HasSubstr;

/// A white sphere in front of a floor, with what has a colour between 0 and 1 everywhere.
constexpr const char* k_BallScene =
    "size: [48, 32]\n"
    "camera: {position: [0, 1, -4], backgroundColor: \"#304860\"}\n"
    "light: {rotation: [50, -30, 0], color: \"#fff0d0\"}\n"
    "layers: {6: Selectable}\n"
    "renderingLayers: {8: Selected}\n"
    "renderer:\n"
    "  features:\n"
    "    - {type: WideOutlineRendererFeature, name: Line, m_LayerMask: Selectable,\n"
    "       m_RenderingLayerMask: Selected}\n"
    "volumes: [{name: V, profile: p.profile.yaml}]\n"
    "objects:\n"
    "  - {name: Ball, mesh: sphere, position: [0, 1, 0], layer: Selectable,\n"
    "     renderingLayerMask: [Default, Selected]}\n"
    "  - {name: Floor, mesh: plane}\n";

class ExplainPixel : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        folder.Write("s.scene.yaml", k_BallScene);
        folder.Write("p.profile.yaml", "WideOutline: {m_Enable: true, m_OutlineColor: \"#ff8000\", "
                                       "m_OutlineWidth: 3}\n");
    }

    /// With the device that the tests share.
    std::vector<std::string> Words(const std::string& verb, std::vector<std::string> more) const
    {
        std::vector<std::string> args{verb, (folder / "s.scene.yaml").string()};
        args.insert(args.end(), more.begin(), more.end());
        if (const char* device = std::getenv("LIMN_TEST_DEVICE"))
        {
            args.insert(args.end(), {"--device", device});
        }
        return args;
    }

    CommandRun Run(const std::string& verb, std::vector<std::string> more) const
    {
        return RunCommand(Words(verb, std::move(more)));
    }

    CommandRun Explain(std::vector<std::string> more) const { return Run("explain", more); }

    TemporaryFolder folder;
};

std::string HexOf(const Image& image, int x, int y)
{
    const auto at = 4 * static_cast<std::size_t>(y * image.width + x);
    char text[8];
    std::snprintf(text, sizeof(text), "#%02x%02x%02x", std::to_integer<unsigned>(image.texels[at]),
                  std::to_integer<unsigned>(image.texels[at + 1]),
                  std::to_integer<unsigned>(image.texels[at + 2]));
    return text;
}

double ToLinear(double s)
{
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

} // namespace

TEST_F(ExplainPixel, TellsThePictureThatRenderDraws)
{
    ASSERT_EQ(0, Run("render", {"-o", (folder / "o.png").string()}).exitCode);
    const Image image = ReadPng(folder / "o.png");
    for (const auto& [x, y] : std::vector<std::pair<int, int>>{
             {0, 0}, {47, 31}, {24, 16}, {24, 30}, {12, 16}, {14, 14}, {34, 17}, {24, 4}, {3, 28}})
    {
        const CommandRun run =
            Explain({"--json", "--pixel", std::to_string(x) + "," + std::to_string(y)});
        ASSERT_EQ(0, run.exitCode) << run.err;
        const json pixel = json::parse(run.out);
        EXPECT_EQ(HexOf(image, x, y), pixel["written"]) << x << "," << y;
        // The last that writes into the picture leaves just that, to its eight bits.
        json last;
        for (const json& event : pixel["events"])
        {
            for (const json& color : event["colors"])
            {
                last = color["texture"] == "limn_Output" ? color["after"] : last;
            }
        }
        ASSERT_EQ(4u, last.size()) << x << "," << y;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const auto at = 4 * static_cast<std::size_t>(y * image.width + x) + i;
            const double byte = std::to_integer<int>(image.texels[at]) / 255.0;
            EXPECT_NEAR(ToLinear(byte), last[i].get<double>(), 1e-6) << x << "," << y;
        }
    }
}

TEST_F(ExplainPixel, SaysTheSameAsTextAndAsJson)
{
    const CommandRun text = Explain({"--pixel", "24,16"});
    EXPECT_EQ(0, text.exitCode);
    EXPECT_EQ("", text.err);
    EXPECT_THAT(text.out, testing::StartsWith("pixel 24,16 of 48x32 is #"));
    EXPECT_THAT(text.out, HasSubstr("Draw Opaque Objects draws Ball: material "));
    EXPECT_THAT(text.out, HasSubstr("\nleft out there by a filter:\n"
                                    "  Draw Transparent Objects leaves out Ball"));
    const json pixel = json::parse(Explain({"--pixel", "24,16", "--json"}).out);
    EXPECT_THAT(text.out, HasSubstr(pixel["written"].get<std::string>()));
    bool hasBall = false;
    for (const json& event : pixel["events"])
    {
        hasBall = hasBall || (event["objects"] == json::array({"Ball"}) &&
                              event["fate"] == "drawn" && event["pass"] == "Draw Opaque Objects");
        EXPECT_EQ(event["reason"].is_null(), event["fate"] == "drawn" || event["fate"] == "cleared")
            << event;
        EXPECT_TRUE(event["reason"].is_null() ||
                    text.out.find(event["reason"].get<std::string>().substr(0, 20)) !=
                        std::string::npos)
            << event;
    }
    EXPECT_TRUE(hasBall);
    EXPECT_EQ(24, pixel["x"]);
    EXPECT_EQ(16, pixel["y"]);
    EXPECT_EQ(48, pixel["width"]);
    EXPECT_EQ(32, pixel["height"]);
}

TEST_F(ExplainPixel, FitsATerminal)
{
    for (const char* pixel : {"24,16", "0,0", "24,30", "12,16"})
    {
        std::istringstream lines(Terminal(80).Run(Words("explain", {"--pixel", pixel, "-v"})));
        int count = 0;
        for (std::string line; std::getline(lines, line); ++count)
        {
            EXPECT_LE(ColumnsOf(line), 80u) << line;
        }
        EXPECT_GT(count, 5);
    }
}

TEST_F(ExplainPixel, TakesOtherValuesThanTheScenes)
{
    const auto line = [&](const std::string& width)
    {
        return json::parse(
            Explain({"--json", "--pixel", "24,2", "--set", "WideOutline.m_OutlineWidth=" + width})
                .out)["written"];
    };
    EXPECT_EQ("#ff8000", line("40"));
    EXPECT_NE("#ff8000", line("1"));
}

TEST_F(ExplainPixel, RefusesWhatLiesOutsideOfThePicture)
{
    for (const char* pixel : {"48,0", "0,32", "-1,3"})
    {
        const CommandRun run = Explain({"--pixel", pixel});
        EXPECT_EQ(1, run.exitCode) << pixel;
        EXPECT_EQ("", run.out) << pixel;
        EXPECT_THAT(LinesOf(run.err),
                    testing::ElementsAre(Mentions("--pixel " + std::string(pixel) + ":", "outside",
                                                  "48x32", "47,31")));
    }
}

TEST_F(ExplainPixel, NeedsADevice)
{
    const CommandRun run = RunCommand({"explain", (folder / "s.scene.yaml").string(), "--pixel",
                                       "1,1", "--device", "no such one"});
    EXPECT_EQ(3, run.exitCode);
    EXPECT_EQ("", run.out);
    EXPECT_THAT(run.err, Mentions("error:", "no usable Vulkan device", "'no such one'"));
}

} // namespace limn::test
