#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

#include <gmock/gmock.h>
#include <limn/features/Version.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using Json = nlohmann::json;

Json RunForJson(const std::vector<std::string>& args)
{
    const CommandRun run = RunCommand(args);
    EXPECT_EQ(0, run.exitCode) << run.err;
    return Json::parse(run.out);
}

} // namespace

TEST(FactsAsJson, AreVersions)
{
    const Json json = RunForJson({"version", "--json"});
    EXPECT_EQ(LIMN_VERSION_TEXT, json["limn"]);
    EXPECT_THAT(json["libraries"]["glslang"].get<std::string>(),
                testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
    EXPECT_TRUE(json["libraries"].contains("yaml-cpp"));
}

TEST(FactsAsJson, AreWhatTheDoctorFinds)
{
    const CommandRun run = RunCommand({"doctor", "--json", "--device", "no such device"});
    EXPECT_EQ(3, run.exitCode);
    const Json json = Json::parse(run.out);
    EXPECT_EQ(LIMN_VERSION_TEXT, json["limn"]);
    EXPECT_EQ(std::string(std::getenv("XDG_CACHE_HOME")) + "limn", json["cache"]["folder"]);
    EXPECT_TRUE(json["chosenDevice"].is_null());
    EXPECT_THAT(json["whyNoDevice"].get<std::string>(), testing::HasSubstr("no such device"));
    EXPECT_FALSE(json["validationLayer"].get<bool>());
    const std::string text = RunCommand({"doctor"}).out;
    EXPECT_THAT(text, testing::HasSubstr("Vulkan devices      " +
                                         std::to_string(json["devices"].size()) + "\n"));
    for (const Json& device : json["devices"])
    {
        EXPECT_THAT(text, testing::HasSubstr(device["name"].get<std::string>() + ", "));
    }
}

TEST(FactsAsJson, AreTheChangesOfSet)
{
    const WorkingFolder working;
    WriteProject(working.folder);
    Json json =
        RunForJson({"set", "p.profile.yaml", "ScreenSpaceOutline.m_OutlineWidth=7", "--json"});
    EXPECT_EQ("p.profile.yaml", json["file"]);
    ASSERT_EQ(1u, json["changes"].size());
    EXPECT_EQ("ScreenSpaceOutline.m_OutlineWidth", json["changes"][0]["name"]);
    EXPECT_EQ("4", json["changes"][0]["before"]);
    EXPECT_EQ("7", json["changes"][0]["after"]);
    json = RunForJson({"set", "p.profile.yaml", "--undo", "--json"});
    EXPECT_TRUE(json["undone"].get<bool>());
}

TEST(FactsAsJson, StayWholeOnATerminal)
{
    const std::string text = Terminal(20).Run({"version", "--json"});
    EXPECT_EQ(RunCommand({"version", "--json"}).out, text);
    const std::string shown = Terminal(20).Run({"inspect", "StrokeOutline", "--json"});
    EXPECT_EQ(RunCommand({"inspect", "StrokeOutline", "--json"}).out, shown);
}

} // namespace limn::test
