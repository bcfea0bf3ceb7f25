#include "commands/HostileNames.h"
#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

/// Every verb that needs no device, in a folder of files with hostile names.
class HostileNames : public testing::Test
{
protected:
    HostileNames() { WriteHostileProject(working.folder); }

    WorkingFolder working;
};

} // namespace

TEST_F(HostileNames, ReachNoStreamAsTheyAre)
{
    const std::string shader = k_HostileFile + ".shader";
    const std::string profile = k_HostileFile + ".profile.yaml";
    const std::vector<std::vector<std::string>> runs{
        {"inspect", "s.scene.yaml"},
        {"inspect", "s.scene.yaml", "--json"},
        {"inspect", profile},
        {"explain", "s.scene.yaml"},
        {"explain", "s.scene.yaml", "-v"},
        {"explain", "s.scene.yaml", "--json"},
        {"explain", "s.scene.yaml", "--object", k_Hostile},
        {"explain", "s.scene.yaml", "--object", k_Hostile, "-v"},
        {"check", "s.scene.yaml", "e.yaml", "--update"}, // which writes the names
        {"check", "s.scene.yaml", "e.yaml", "--junit", "j.xml"},
        {"check", "s.scene.yaml", "e.yaml", "--json"},
        {"shader", shader},
        {"shader", shader, "--json"},
        {"shader", shader, "--variants"},
        {"shader", shader, "--parse-only"},
        {"shader", "plain.shader", "--emit", "glsl", "-o", k_HostileFile},
        {"shader", "plain.shader", "--keywords", k_Hostile},
        {"shader", "."},
        {"set", profile, "ScreenSpaceOutline.m_OutlineWidth=5"},
        {"completion", "bash"},
        {"schema", "scene"}};
    for (const std::vector<std::string>& args : runs)
    {
        const CommandRun run = RunCommand(args);
        const std::string what = testing::PrintToString(args);
        EXPECT_EQ(0, run.exitCode) << what << run.err;
        EXPECT_NE("", run.out) << what;
        ExpectHarmless(run.out, what + " > out");
        ExpectHarmless(run.err, what + " > err");
    }
}

TEST_F(HostileNames, ReachNoStreamAsTheyAreInErrors)
{
    const std::vector<std::vector<std::string>> runs{
        {"explain", "s.scene.yaml", "--object", k_Hostile + "!"},
        {"check", "s.scene.yaml", k_Hostile},
        {"inspect", k_Hostile},
        {"shader", k_Hostile},
        {"render", k_Hostile, "-o", "o.png"},
        {"watch", k_Hostile, "-o", "o.png"},
        {"set", k_HostileFile + ".profile.yaml", "ScreenSpaceOutline.m_OutlineWidth=" + k_Hostile},
        {"schema", k_Hostile},
        {"completion", k_Hostile},
        {"help", k_Hostile},
        {"version", k_Hostile},
        {"doctor", k_Hostile},
        {k_Hostile}};
    for (const std::vector<std::string>& args : runs)
    {
        const CommandRun run = RunCommand(args);
        const std::string what = testing::PrintToString(args);
        EXPECT_THAT(run.exitCode, testing::AnyOf(1, 2)) << what;
        EXPECT_EQ("", run.out) << what;
        EXPECT_NE("", run.err) << what;
        ExpectHarmless(run.err, what);
    }
}

TEST_F(HostileNames, StayThemselvesInJson)
{
    const auto scene = nlohmann::json::parse(RunCommand({"inspect", "s.scene.yaml", "--json"}).out);
    EXPECT_EQ(k_Hostile, scene["volumes"][0]["name"]);
    EXPECT_EQ(k_Hostile, scene["features"][0]["name"]);
    const auto shader =
        nlohmann::json::parse(RunCommand({"shader", k_HostileFile + ".shader", "--json"}).out);
    EXPECT_EQ(k_HostileFile + ".shader", shader["files"][0]["file"]);
}

TEST_F(HostileNames, OfFoldersReachNoStreamInDoctorsReport)
{
    std::ostringstream out;
    std::ostringstream err;
    setenv("XDG_CACHE_HOME", (working.folder / "f\x1B[2J\nFORGED").c_str(), 1);
    RunLimn(std::vector<std::string>{"doctor"}, out, err);
    EXPECT_NE(std::string::npos, out.str().find("f\\x1B[2J\\nFORGED"));
    ExpectHarmless(out.str(), "doctor > out");
}

} // namespace limn::test
