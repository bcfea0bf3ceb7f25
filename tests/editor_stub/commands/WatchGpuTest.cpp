#include "Mentions.h"
#include "commands/WatchTest.h"

#include <atomic>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

constexpr const char* k_WatchedScene =
    "size: [160, 90]\n"
    "renderingLayers: {8: Selected}\n"
    "camera: {position: [0, 0, -4], backgroundColor: \"#000000\"}\n"
    "renderer:\n"
    "  features:\n"
    "    - type: ScreenSpaceOutlineRenderFeature\n"
    "      m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline\n"
    "      m_LayerMask: Everything\n"
    "      m_RenderingLayerMask: Selected\n"
    "volumes: [{name: All, profile: p.profile.yaml}]\n"
    "materials: {black: {_BaseColor: \"#000000\"}}\n"
    "objects: [{name: Piece, mesh: cube, material: black, renderingLayerMask: [Selected]}]\n";

/// Matches what a run says whose lines do not go out.
auto SaysThatNothingGoesOut()
{
    return testing::ElementsAre(Mentions("results", "standard output", "disk is full"));
}

std::string Profile(const std::string& color)
{
    return "ScreenSpaceOutline: {m_Enable: true, m_OutlineColor: \"" + color + "\"}\n";
}

/// A black cube with an outline in the profile's colour.
class Watch : public WatchTest
{
protected:
    void SetUp() override
    {
        WatchTest::SetUp();
        folder.Write("s.scene.yaml", k_WatchedScene);
        folder.Write("p.profile.yaml", Profile("#ff0000"));
    }

    /// Whether the picture has an outline in this channel and none in the others.
    bool IsOutlined(std::size_t channel) const
    {
        if (!std::filesystem::exists(folder / "out.png"))
        {
            return false;
        }
        const Image image = ReadPng(folder / "out.png");
        int counts[3] = {0, 0, 0};
        for (std::size_t i = 0; i < image.texels.size(); ++i)
        {
            counts[i % 4 % 3] += i % 4 < 3 && std::to_integer<int>(image.texels[i]) > 200 ? 1 : 0;
        }
        return counts[channel] > 0 && counts[0] + counts[1] + counts[2] == counts[channel];
    }

    bool WaitForOutline(std::size_t channel) const
    {
        return WaitFor([&] { return IsOutlined(channel); });
    }
};

} // namespace

TEST_F(Watch, FollowsEveryWayOfSavingAProfile)
{
    Start();
    ASSERT_TRUE(WaitForOutline(0)) << ReadText(folder / "err");
    {
        std::fstream file(folder / "p.profile.yaml", std::ios::in | std::ios::out);
        file << Profile("#00ff00");
    }
    EXPECT_TRUE(WaitForOutline(1)) << "written in place";
    folder.Write("p.tmp", Profile("#0000ff"));
    std::filesystem::rename(folder / "p.tmp", folder / "p.profile.yaml");
    EXPECT_TRUE(WaitForOutline(2)) << "renamed";
    folder.Write("p.profile.yaml", Profile("#ff0000"));
    EXPECT_TRUE(WaitForOutline(0)) << "truncated, then written";
    EXPECT_EQ("", ReadText(folder / "err"));
    EXPECT_THAT(ReadText(folder / "out"), testing::StartsWith(Path("out.png") + " 160x90 "));
}

TEST_F(Watch, KeepsTheLastPictureWhileAProfileIsBroken)
{
    Start();
    ASSERT_TRUE(WaitForOutline(0)) << ReadText(folder / "err");
    const std::string before = ReadText(folder / "out.png");
    folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 14}\n");
    EXPECT_TRUE(WaitFor(
        [&]
        {
            return ReadText(folder / "err")
                       .find(Path("p.profile.yaml") + ":1:38: error: ScreenSpaceOutline."
                                                      "m_OutlineWidth: 14 is outside [1, 10]\n") !=
                   std::string::npos;
        }));
    EXPECT_EQ(before, ReadText(folder / "out.png"));
    folder.Write("p.profile.yaml", Profile("#00ff00"));
    EXPECT_TRUE(WaitForOutline(1));
}

TEST_F(Watch, GoesOnWhenTheCompilerDies)
{
    folder.Write("dies.shader", "Shader \"Dies\" { SubShader { Pass { HLSLPROGRAM\n"
                                "#pragma vertex V\n#pragma fragment F\n"
                                "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                                "float4 F() : SV_Target { return 1; }\nENDHLSL } } }");
    setenv("LIMN_TEST_ABORT", "dies.shader", 1);
    Start();
    unsetenv("LIMN_TEST_ABORT");
    ASSERT_TRUE(WaitForOutline(0)) << ReadText(folder / "err");
    std::string scene = k_WatchedScene;
    const std::string color = "_BaseColor: \"#000000\"";
    scene.replace(scene.find(color), color.size(), "shader: dies.shader");
    folder.Write("s.scene.yaml", scene);
    const auto err = [&]
    {
        return ReadText(folder / "err");
    };
    EXPECT_TRUE(WaitFor([&] { return err().find("signal 6") != std::string::npos; })) << err();
    EXPECT_THAT(err(), Mentions("dies.shader:1:36:", "compiler crashes", "Aborted", "signal 6"));
    folder.Write("p.profile.yaml", Profile("#00ff00"));
    folder.Write("s.scene.yaml", k_WatchedScene);
    EXPECT_TRUE(WaitForOutline(1)) << ReadText(folder / "err");
    EXPECT_EQ(0, Stop(SIGTERM));
}

TEST_F(Watch, FollowsTheScene)
{
    Start();
    ASSERT_TRUE(WaitForOutline(0)) << ReadText(folder / "err");
    folder.Write("q.profile.yaml", Profile("#0000ff"));
    std::string scene = k_WatchedScene;
    scene.replace(scene.find("p.profile"), 1, "q");
    folder.Write("s.scene.yaml", scene);
    EXPECT_TRUE(WaitForOutline(2));
    folder.Write("q.profile.yaml", Profile("#00ff00"));
    EXPECT_TRUE(WaitForOutline(1)) << "a profile that the scene did not reach at first";
}

TEST_F(Watch, DrawsWhileAProfileIsSavedWithoutAPause)
{
    Start();
    ASSERT_TRUE(WaitForOutline(0)) << ReadText(folder / "err");
    std::atomic<bool> isOver = false;
    std::thread slider(
        [&]
        {
            while (!isOver)
            {
                std::filesystem::rename(folder.Write("p.tmp", Profile("#00ff00")),
                                        folder / "p.profile.yaml");
                std::this_thread::sleep_for(std::chrono::milliseconds(4));
            }
        });
    EXPECT_TRUE(WaitForOutline(1));
    isOver = true;
    slider.join();
}

TEST_F(Watch, GoesOnWhenItsFolderIsReplacedByAnother)
{
    const TemporaryFolder other;
    Start();
    ASSERT_TRUE(WaitForOutline(0)) << ReadText(folder / "err");
    const std::filesystem::path here = folder / "s.scene.yaml";
    std::filesystem::rename(here.parent_path(), other / "old");
    std::filesystem::create_directory(here.parent_path());
    folder.Write("s.scene.yaml", k_WatchedScene);
    folder.Write("p.profile.yaml", Profile("#00ff00"));
    EXPECT_TRUE(WaitForOutline(1)) << ReadText(other / "old/err");
    folder.Write("p.profile.yaml", Profile("#0000ff"));
    EXPECT_TRUE(WaitForOutline(2)) << ReadText(other / "old/err");
}

TEST_F(Watch, EndsWith0OnSigintAndSigterm)
{
    for (const int signal : {SIGINT, SIGTERM})
    {
        Start();
        ASSERT_TRUE(WaitForOutline(0)) << ReadText(folder / "err");
        EXPECT_EQ(0, Stop(signal));
        std::filesystem::remove(folder / "out.png");
    }
}

TEST_F(Watch, DoesNotDrawOverATextureOfItsScene)
{
    WritePng(folder / "out.png",
             Image{1, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(4)});
    const std::string before = ReadText(folder / "out.png");
    std::string scene = k_Scene;
    scene.replace(scene.find("{_BaseColor"), 1, "{_BaseMap: out.png, ");
    folder.Write("s.scene.yaml", scene);
    Start();
    EXPECT_TRUE(WaitFor(
        [&]
        {
            return ReadText(folder / "err")
                       .find(Path("out.png") + ": error: the file cannot be written") !=
                   std::string::npos;
        }))
        << ReadText(folder / "err");
    EXPECT_EQ(0, Stop(SIGTERM));
    EXPECT_EQ(before, ReadText(folder / "out.png"));
}

TEST_F(Watch, WithAPipeForAProfileStillEndsOnASignal)
{
    std::filesystem::remove(folder / "p.profile.yaml");
    ASSERT_EQ(0, mkfifo((folder / "p.profile.yaml").c_str(), 0600));
    Start();
    EXPECT_TRUE(WaitFor(
        [&] { return ReadText(folder / "err").find("is a named pipe") != std::string::npos; }));
    EXPECT_EQ(0, Stop(SIGINT));
}

TEST_F(Watch, EndsWith3WhereItsLinesDoNotGoOut)
{
    const std::string arguments = "'" + Path("s.scene.yaml") + "' -o '" + Path("out.png") + "'";
    for (const std::string out : {"> /dev/full", ">&-"})
    {
        Start(arguments, out);
        EXPECT_EQ(3, End()) << out;
        EXPECT_THAT(LinesOf(ReadText(folder / "err")), SaysThatNothingGoesOut()) << out;
    }
}

TEST_F(Watch, EndsWith3OnceNobodyReadsItsLines)
{
    ASSERT_EQ(0, mkfifo((folder / "lines").c_str(), 0600));
    const int reader = open((folder / "lines").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const auto before = signal(SIGPIPE, SIG_IGN); // as many a program that starts others has it
    Start("'" + Path("s.scene.yaml") + "' -o '" + Path("out.png") + "'",
          "> '" + Path("lines") + "'");
    signal(SIGPIPE, before);
    char line[1];
    ASSERT_TRUE(WaitFor([&] { return read(reader, line, 1) == 1; })) << ReadText(folder / "err");
    close(reader);
    folder.Write("p.profile.yaml", Profile("#00ff00"));
    EXPECT_EQ(3, End());
    EXPECT_THAT(LinesOf(ReadText(folder / "err")), SaysThatNothingGoesOut());
}

TEST_F(Watch, WithoutItsSceneOrItsOutputFolderDoesNotStart)
{
    const CommandRun noScene = RunCommand({"watch", Path("no.scene.yaml"), "-o", Path("o.png")});
    EXPECT_EQ(1, noScene.exitCode);
    EXPECT_EQ(Path("no.scene.yaml") + ": error: there is no such file\n", noScene.err);
    const CommandRun noFolder = RunCommand({"watch", Path("s.scene.yaml"), "-o", Path("no/o.png")});
    EXPECT_EQ(1, noFolder.exitCode);
    EXPECT_THAT(LinesOf(noFolder.err),
                testing::ElementsAre(Mentions(Path("no/o.png") + ":", "written", "No such file")));
    EXPECT_EQ(2, RunCommand({"watch"}).exitCode);
}

} // namespace limn::test
