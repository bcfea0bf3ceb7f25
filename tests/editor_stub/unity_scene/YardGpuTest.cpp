// What the project `data/yard` looks like. Its materials are unlit, so that a pixel shows what its
// picture file says.

#include "Paths.h"
#include "commands/WatchTest.h"

#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

constexpr int k_YardWidth = 640;
constexpr int k_YardHeight = 360;
const std::string k_Wood = "#c87828";  // Wood.png: 200, 120, 40
const std::string k_Paint = "#2850c8"; // Paint.tif: 40, 80, 200

class YardOnDevice : public WatchTest
{
protected:
    void SetUp() override
    {
        WatchTest::SetUp();
        std::filesystem::copy(SourcePath("tests/editor_stub/data/yard"), folder / "yard",
                              std::filesystem::copy_options::recursive);
    }
    Image Draw(const std::vector<std::string>& more = {})
    {
        std::vector<std::string> args = {"render", Path("yard"), "-o",       Path("a.png"),
                                         "--size", "640x360",    "--device", "software"};
        args.insert(args.end(), more.begin(), more.end());
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return ReadPng(folder / "a.png");
    }
    static std::string At(const Image& image, int x, int y)
    {
        const std::byte* texel =
            image.texels.data() + static_cast<std::size_t>(y * image.width + x) * 4;
        std::array<char, 8> text{};
        std::snprintf(text.data(), text.size(), "#%02x%02x%02x",
                      std::to_integer<unsigned>(texel[0]), std::to_integer<unsigned>(texel[1]),
                      std::to_integer<unsigned>(texel[2]));
        return text.data();
    }
    /// Returns where a point is in the picture, from the camera at (0, 1, -6) that looks along +z
    /// with a vertical field of view of 60 degrees.
    static glm::dvec2 PixelOf(const glm::dvec3& point)
    {
        const double half = (point.z + 6.0) * std::tan(glm::radians(30.0));
        return {k_YardWidth / 2.0 + point.x / half * k_YardHeight / 2.0,
                k_YardHeight / 2.0 - (point.y - 1.0) / half * k_YardHeight / 2.0};
    }
    /// Replaces a text of a file of the project, in one step, as Unity saves.
    void Replace(const std::string& file, const std::string& text, const std::string& by)
    {
        std::string whole = ReadText(folder / ("yard/" + file));
        ASSERT_NE(whole.find(text), std::string::npos);
        whole.replace(whole.find(text), text.size(), by);
        folder.Write("new", whole);
        std::filesystem::rename(folder / "new", folder / ("yard/" + file));
    }
    bool WaitForPixel(int x, int y, const std::string& color)
    {
        return WaitFor(
            [&]
            {
                std::error_code ignored;
                return std::filesystem::exists(folder / "out.png", ignored) &&
                       At(ReadPng(folder / "out.png"), x, y) == color;
            });
    }
};

TEST_F(YardOnDevice, ShowsItsPicturesWhereItsCratesAre)
{
    const Image image = Draw();
    const glm::dvec2 lower = PixelOf({1.5, 0.5, -0.5});
    const glm::dvec2 upper = PixelOf({-1.5, 1.25, -0.25});
    EXPECT_EQ(At(image, static_cast<int>(lower.x), static_cast<int>(lower.y)), k_Paint);
    EXPECT_EQ(At(image, static_cast<int>(upper.x), static_cast<int>(upper.y)), k_Wood);
    EXPECT_EQ(At(image, 320, 300), k_Wood) << "the floor";
    EXPECT_EQ(At(image, 320, 20), "#000000");
    // The painted crate from its back's left edge to its front's right one.
    const int row = static_cast<int>(lower.y);
    int left = k_YardWidth;
    int right = -1;
    for (int x = 0; x < k_YardWidth; ++x)
    {
        if (At(image, x, row) == k_Paint)
        {
            left = std::min(left, x);
            right = std::max(right, x + 1);
        }
    }
    EXPECT_NEAR(left, PixelOf({1.0, 0.5, 0.5}).x, 2.0);
    EXPECT_NEAR(right, PixelOf({2.0, 0.5, -0.5}).x, 2.0);
}

TEST_F(YardOnDevice, HasOneOutlineAsWideAsTheProfileSays)
{
    const Image image = Draw();
    const Image wide = Draw({"--set", "ScreenSpaceOutline.m_OutlineWidth=10"});
    const auto greenIn = [](const Image& picture, int from, int to)
    {
        int count = 0;
        for (int y = 0; y < k_YardHeight; ++y)
        {
            for (int x = from; x < to; ++x)
            {
                count += At(picture, x, y) == "#00ff00" ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_GT(greenIn(image, k_YardWidth / 2, k_YardWidth), 50) << "the right stack's upper crate";
    EXPECT_EQ(greenIn(image, 0, k_YardWidth / 2), 0) << "no other";
    EXPECT_GT(greenIn(wide, k_YardWidth / 2, k_YardWidth),
              greenIn(image, k_YardWidth / 2, k_YardWidth));
}

TEST_F(YardOnDevice, IsDrawnAnewWhenAFileOfItChanges)
{
    Start("'" + Path("yard") + "' --size 640x360 --cache-dir '" + Path("cache") + "' -o '" +
          Path("out.png") + "'");
    const glm::dvec2 at = PixelOf({1.5, 0.5, -0.5});
    const int x = static_cast<int>(at.x);
    const int y = static_cast<int>(at.y);
    ASSERT_TRUE(WaitForPixel(x, y, k_Paint)) << ReadText(folder / "err");
    Replace("Assets/Materials/Paint.mat", "_BaseColor: {r: 1, g: 1, b: 1",
            "_BaseColor: {r: 0, g: 1, b: 1");
    EXPECT_TRUE(WaitForPixel(x, y, "#0050c8")) << "a material" << ReadText(folder / "err");
    std::string all;
    std::string other;
    for (int i = 0; i < 16; ++i)
    {
        all += "\x28\x50\xc8";
        other += "\x28\xff\xc8";
    }
    Replace("Assets/Textures/Paint.tif", all, other);
    EXPECT_TRUE(WaitForPixel(x, y, "#00ffc8")) << "a texture" << ReadText(folder / "err");
    Replace("Assets/Scenes/Yard.unity", "m_BackGroundColor: {r: 0", "m_BackGroundColor: {r: 1");
    EXPECT_TRUE(WaitForPixel(320, 20, "#ff0000")) << "the scene" << ReadText(folder / "err");
    const glm::dvec2 upper = PixelOf({1.5, 1.5, -0.25});
    Replace("Assets/Settings/Profile.asset", "m_Value: {r: 0, g: 1, b: 0",
            "m_Value: {r: 0, g: 0, b: 1");
    EXPECT_TRUE(WaitForPixel(static_cast<int>(upper.x), static_cast<int>(upper.y) - 1, "#ff00ff"))
        << "the profile: blue is added to red" << ReadText(folder / "err");
}

} // namespace
} // namespace limn::test
