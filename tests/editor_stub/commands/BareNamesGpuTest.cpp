#include "commands/HostileNames.h"
#include "commands/WatchTest.h"
#include "commands/WorkingFolder.h"

namespace limn::test
{

namespace
{

/// The verbs that draw, run from inside the files' own folder.
class BareNamesGpu : public WatchTest
{
protected:
    void SetUp() override
    {
        WatchTest::SetUp();
        WriteProject(working.folder);
    }

    WorkingFolder working;
};

} // namespace

TEST_F(BareNamesGpu, DoForRender)
{
    const CommandRun run =
        RunCommand({"render", "s.scene.yaml", "-o", "out.png", "--profile", "p.profile.yaml",
                    "--cache-dir", "cache", "--stats", "stats.json", "--trace", "trace.json"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("", run.err);
    EXPECT_EQ("out.png 16x9\n", run.out);
    EXPECT_EQ(16, ReadPng("out.png").width);
    EXPECT_TRUE(std::filesystem::exists("stats.json"));
    EXPECT_TRUE(std::filesystem::exists("trace.json"));
}

TEST_F(BareNamesGpu, DoForWatch)
{
    Start("s.scene.yaml -o out.png --cache-dir cache");
    ASSERT_TRUE(WaitFor([] { return std::filesystem::exists("out.png"); }))
        << ReadText(folder / "err");
    std::filesystem::remove("out.png");
    working.folder.Write("a.hlsl", "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                                   "float4 F() : SV_Target { return 0.5; }\n");
    EXPECT_TRUE(WaitFor([] { return std::filesystem::exists("out.png"); }))
        << ReadText(folder / "err");
    EXPECT_EQ(0, Stop(SIGINT));
    EXPECT_EQ("", ReadText(folder / "err"));
}

TEST_F(BareNamesGpu, ThatAreHostileReachNoStreamAsTheyAre)
{
    WriteHostileProject(working.folder);
    const std::string out = k_HostileFile + ".png";
    const CommandRun run = RunCommand({"render", "s.scene.yaml", "-o", out, "-v"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_TRUE(std::filesystem::exists(out));
    ExpectHarmless(run.out, "render > out");
    ExpectHarmless(run.err, "render > err");
    for (const std::vector<std::string>& form : {std::vector<std::string>{}, {"--json"}})
    {
        std::vector<std::string> args{"explain", "s.scene.yaml", "--pixel", "8,4", "-v"};
        args.insert(args.end(), form.begin(), form.end());
        const CommandRun pixel = RunCommand(args);
        EXPECT_EQ(0, pixel.exitCode);
        ExpectHarmless(pixel.out, "explain --pixel > out");
        ExpectHarmless(pixel.err, "explain --pixel > err");
    }
    Start("s.scene.yaml -o \"$(printf 'w\\033[2J\\nFORGED.png')\"");
    EXPECT_TRUE(WaitFor([this] { return !ReadText(folder / "out").empty(); }));
    EXPECT_EQ(0, Stop(SIGTERM));
    ExpectHarmless(ReadText(folder / "out"), "watch > out");
    ExpectHarmless(ReadText(folder / "err"), "watch > err");
}

} // namespace limn::test
