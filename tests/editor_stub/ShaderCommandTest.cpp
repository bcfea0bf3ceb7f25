#include "CommandRun.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

constexpr const char* k_Good = "Shader \"My/Good\"\n"
                               "{\n"
                               "    Properties { _Tint (\"Tint\", Color) = (1, 0.5, 0, 1) }\n"
                               "    SubShader\n"
                               "    {\n"
                               "        Pass\n"
                               "        {\n"
                               "            Name \"Only\"\n"
                               "            Cull [_Cull]\n"
                               "            ZTest Always\n"
                               "            Blend SrcAlpha OneMinusSrcAlpha\n"
                               "            ColorMask RGB\n"
                               "            Stencil { Ref 2 Comp Equal Pass Replace }\n"
                               "            HLSLPROGRAM\n"
                               "            #pragma vertex V\n"
                               "            #pragma fragment F\n"
                               "            #pragma multi_compile _ FOG\n"
                               "            float4 _Tint;\n"
                               "            float4 V(float4 p : POSITION) : SV_POSITION\n"
                               "            {\n"
                               "                return p;\n"
                               "            }\n"
                               "            float4 F() : SV_Target\n"
                               "            {\n"
                               "                return _Tint;\n"
                               "            }\n"
                               "            ENDHLSL\n"
                               "        }\n"
                               "    }\n"
                               "}\n";

class ShaderCommand : public testing::Test
{
protected:
    std::string Write(const std::string& name, const std::string& text) const
    {
        return folder.Write(name, text).string();
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(ShaderCommand, DescribesASingleFile)
{
    const std::string path = Write("good.shader", k_Good);
    const CommandRun run = RunCommand({"shader", path});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("", run.err);
    EXPECT_THAT(run.out, HasSubstr("Shader \"My/Good\" (" + path +
                                   ")\n"
                                   "  property _Tint Color = (1, 0.5, 0, 1)\n"
                                   "  SubShader 0, used\n"
                                   "    pass 0 'Only', LightMode SRPDefaultUnlit\n"
                                   "      Cull [_Cull], ZTest Always, ZWrite On, Blend SrcAlpha "
                                   "OneMinusSrcAlpha, ColorMask RGB, Stencil {Ref 2 ReadMask 255 "
                                   "WriteMask 255 Comp Equal Pass Replace Fail Keep ZFail Keep}\n"
                                   "      multi_compile: (none) FOG\n"
                                   "      SPIR-V: vertex "));
    EXPECT_THAT(run.out, HasSubstr("float4 _Tint @0"));
    EXPECT_THAT(run.out, HasSubstr("vertex input float4 POSITION, location 0\n"));
}

TEST_F(ShaderCommand, ReportsEveryErrorOfAllFilesAndSumsUp)
{
    Write("a.shader", k_Good);
    Write("b.shader", "Shader \"B\" {\n SubShader { Pas { } } }");
    Write("notes.txt", "no shader");
    const CommandRun run = RunCommand({"shader", (folder / "").string()});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("b.shader:2:14: error: SubShader: unknown command 'Pas'; did "
                                   "you mean 'Pass'?"));
    EXPECT_EQ("2 files: 1 good, 1 with 1 error; 1 pass compiled\n", run.out);
}

TEST_F(ShaderCommand, ParseOnlyLeavesProgramsAlone)
{
    std::string text = k_Good;
    text.replace(text.find("return _Tint"), 12, "return _Tnt");
    const std::string path = Write("good.shader", text);
    EXPECT_EQ(0, RunCommand({"shader", path, "--parse-only"}).exitCode);
    const CommandRun run = RunCommand({"shader", path});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ(path + ":25: error: '_Tnt': unknown variable\n", run.err);
}

TEST_F(ShaderCommand, GivesTheSameAsJson)
{
    const std::string good = Write("good.shader", k_Good);
    const std::string bad = Write("bad.shader", "Shader \"B\" { Oops }");
    const CommandRun run = RunCommand({"shader", good, bad, "--json"});
    EXPECT_EQ(1, run.exitCode);
    const nlohmann::json json = nlohmann::json::parse(run.out);
    ASSERT_EQ(2u, json.size());
    EXPECT_EQ("My/Good", json[0]["name"]);
    EXPECT_EQ("_Tint", json[0]["properties"][0]["name"]);
    const nlohmann::json& pass = json[0]["subShaders"][0]["passes"][0];
    EXPECT_EQ("Only", pass["name"]);
    EXPECT_EQ(6, pass["line"]);
    EXPECT_EQ("FOG", pass["keywords"][0]["keywords"][1]);
    EXPECT_EQ("POSITION", pass["layout"]["vertexInputs"][0]["semantic"]);
    EXPECT_TRUE(json[0]["errors"].empty());
    EXPECT_EQ(1, json[1]["errors"][0]["line"]);
}

TEST_F(ShaderCommand, EmitsBothStagesInEveryLanguage)
{
    const std::string path = Write("good.shader", k_Good);
    const std::vector<std::pair<std::string, std::string>> languages{
        {"glsl", "#version 450"}, {"hlsl", "SV_Position"}, {"msl", "#include <metal_stdlib>"}};
    const std::string output = (folder / "emitted").string();
    for (const auto& [language, content] : languages)
    {
        const CommandRun run = RunCommand({"shader", path, "--emit", language, "-o", output});
        const std::string stem = output + "/My_Good.0.";
        EXPECT_EQ(0, run.exitCode) << run.err;
        EXPECT_EQ(stem + "vert." + language + "\n" + stem + "frag." + language + "\n", run.out);
        EXPECT_THAT(ReadText(stem + "vert." + language), HasSubstr(content));
        EXPECT_FALSE(ReadText(stem + "frag." + language).empty());
    }
    EXPECT_EQ(0, RunCommand({"shader", path, "--emit", "spirv", "-o", output}).exitCode);
    const std::string spirv = ReadText(output + "/My_Good.0.vert.spv");
    EXPECT_EQ("\x03\x02\x23\x07", spirv.substr(0, 4)) << "SPIR-V's magic number, little-endian";
}

TEST_F(ShaderCommand, NamesAFileThatIsNotThere)
{
    const std::string path = (folder / "no.shader").string();
    const CommandRun run = RunCommand({"shader", path});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ(path + ": error: file: no such file\n", run.err);
}

TEST_F(ShaderCommand, NamesAFolderWithoutShaders)
{
    const std::string path = (folder / "").string();
    const CommandRun run = RunCommand({"shader", path});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ(path + ": error: the folder has no .shader file in it\n", run.err);
}

} // namespace limn::test
