#include "Mentions.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

constexpr const char* k_GoodShader = "Shader \"My/Good\"\n"
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

TEST_F(ShaderCommand, CompilesTheKernelsOfComputeFiles)
{
    const std::string path = Write("fill.compute", "#pragma kernel Fill\n"
                                                   "#pragma kernel Wide SIZE=32\n"
                                                   "#pragma multi_compile _ RED\n"
                                                   "#ifndef SIZE\n#define SIZE 8\n#endif\n"
                                                   "RWTexture2D<float4> _Result;\n"
                                                   "[numthreads(SIZE, 4, 1)]\n"
                                                   "void Fill(uint3 id : SV_DispatchThreadID)\n"
                                                   "{\n"
                                                   "#ifdef RED\n"
                                                   "    _Result[id.xy] = nothing;\n"
                                                   "#endif\n"
                                                   "}\n"
                                                   "[numthreads(SIZE, 1, 1)]\n"
                                                   "void Wide() { }\n");
    const CommandRun good = RunCommand({"shader", path});
    EXPECT_EQ(0, good.exitCode) << good.err;
    EXPECT_EQ(
        "kernel Fill: groups of 8 x 4 x 1 threads\nkernel Wide: groups of 32 x 1 x 1 threads\n",
        good.out);
    const CommandRun red = RunCommand({"shader", path, "--keywords", "RED"});
    EXPECT_EQ(1, red.exitCode);
    EXPECT_THAT(red.err, HasSubstr(path + ":12:"));
    EXPECT_THAT(red.err, HasSubstr("nothing"));
    EXPECT_EQ("kernel Fill\nkernel Wide\n", RunCommand({"shader", "--parse-only", path}).out);
    for (const std::string other : {"--json", "--print", "--variants", "a.shader"})
    {
        const CommandRun run = RunCommand({"shader", path, other});
        EXPECT_EQ(2, run.exitCode) << other;
        EXPECT_THAT(run.err, Mentions("shader:", ".compute", "on their own"));
    }
    const CommandRun none = RunCommand({"shader", Write("none.compute", "void Fill() { }\n")});
    EXPECT_EQ(1, none.exitCode);
    EXPECT_THAT(none.err, HasSubstr("none.compute: error: file: it has no kernel"));
}

TEST_F(ShaderCommand, PrintsFilesAsCanonicalText)
{
    const std::string loose =
        Write("loose.shader", "Shader \"My/Loose\" { // as somebody wrote it\n"
                              "SubShader { ZTEST always\n"
                              "UsePass \"My/Good/ONLY\" } }");
    const std::string canonical = "Shader \"My/Loose\"\n"
                                  "{\n"
                                  "    SubShader\n"
                                  "    {\n"
                                  "        UsePass \"My/Good/ONLY\"\n"
                                  "    }\n"
                                  "}\n";
    const CommandRun run = RunCommand({"shader", "--print", loose});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ(canonical, run.out);
    EXPECT_EQ("", run.err);
    // What is canonical stays as it is, and several files follow each other.
    const std::string same = Write("same.shader", canonical);
    EXPECT_EQ(canonical + canonical, RunCommand({"shader", "--print", same, same}).out);
}

TEST_F(ShaderCommand, PrintsWhatParsesBesideWhatDoesNot)
{
    Write("a_broken.shader", "Shader \"My/Broken\" { SubShader { Pass { Cull Sideways } } }");
    Write("b_good.shader", k_GoodShader);
    Write("c_empty.shader", "");
    const CommandRun run = RunCommand({"shader", "--print", (folder / "").string()});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("Sideways"));
    EXPECT_THAT(run.err, HasSubstr("c_empty.shader"));
    EXPECT_TRUE(run.out.starts_with("Shader \"My/Good\"\n{\n    Properties\n")) << run.out;
    EXPECT_EQ(2, RunCommand({"shader", "--print", "--json", (folder / "").string()}).exitCode);
}

TEST_F(ShaderCommand, DescribesASingleFile)
{
    const std::string path = Write("good.shader", k_GoodShader);
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
                                   "      2 variants\n"
                                   "      SPIR-V: vertex "));
    EXPECT_THAT(LinesOf(run.out), testing::Contains(Mentions("SRP Batcher: not compatible", "_Tint",
                                                             "$Global", "UnityPerMaterial")));
    EXPECT_THAT(run.out, HasSubstr("float4 _Tint @0"));
    EXPECT_THAT(run.out, HasSubstr("vertex input float4 POSITION, location 0\n"));
}

TEST_F(ShaderCommand, ReportsEveryErrorOfAllFilesAndSumsUp)
{
    Write("a.shader", k_GoodShader);
    Write("b.shader", "Shader \"B\" {\n SubShader { Pas { } } }");
    Write("notes.txt", "no shader");
    const CommandRun run = RunCommand({"shader", (folder / "").string()});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, Mentions("b.shader:2:14:", "unknown command", "'Pas'", "'Pass'"));
    EXPECT_THAT(run.err, HasSubstr("\n SubShader { Pas { } } }\n             ^\n"));
    EXPECT_EQ("2 files: 1 parsed (50.0 %), 1 error; 1 of 1 pass compiled (100.0 %)\n", run.out);
}

TEST_F(ShaderCommand, ParseOnlyLeavesProgramsAlone)
{
    std::string text = k_GoodShader;
    text.replace(text.find("return _Tint"), 12, "return _Tnt");
    const std::string path = Write("good.shader", text);
    EXPECT_EQ(0, RunCommand({"shader", path, "--parse-only"}).exitCode);
    const CommandRun run = RunCommand({"shader", path});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ(path + ":25:24: error: '_Tnt': unknown variable\n"
                     "                return _Tnt;\n"
                     "                       ^\n",
              run.err);
}

TEST_F(ShaderCommand, GivesTheSameAsJson)
{
    const std::string good = Write("good.shader", k_GoodShader);
    const std::string bad = Write("bad.shader", "Shader \"B\" { Oops }");
    const CommandRun run = RunCommand({"shader", good, bad, "--json"});
    EXPECT_EQ(1, run.exitCode);
    const nlohmann::json json = nlohmann::json::parse(run.out);
    const nlohmann::json& files = json["files"];
    ASSERT_EQ(2u, files.size());
    EXPECT_EQ("My/Good", files[0]["name"]);
    EXPECT_EQ(true, files[0]["parsed"]);
    EXPECT_EQ("_Tint", files[0]["properties"][0]["name"]);
    const nlohmann::json& pass = files[0]["subShaders"][0]["passes"][0];
    EXPECT_EQ("Only", pass["name"]);
    EXPECT_EQ(6, pass["line"]);
    EXPECT_EQ("compiled", pass["outcome"]);
    EXPECT_EQ("2", pass["variants"]);
    EXPECT_EQ("FOG", pass["keywords"][0]["keywords"][1]);
    EXPECT_EQ("POSITION", pass["layout"]["vertexInputs"][0]["semantic"]);
    EXPECT_THAT(pass["srpBatcherProblem"].get<std::string>(),
                Mentions("_Tint", "$Global", "UnityPerMaterial"));
    EXPECT_TRUE(files[0]["diagnostics"].empty());
    EXPECT_EQ(false, files[1]["parsed"]);
    EXPECT_EQ(1, files[1]["diagnostics"][0]["line"]);
    EXPECT_EQ("error", files[1]["diagnostics"][0]["severity"]);
    EXPECT_EQ(2, json["summary"]["files"]);
    EXPECT_EQ(1, json["summary"]["parsed"]);
    EXPECT_EQ(1, json["summary"]["passesCompiled"]);
}

TEST_F(ShaderCommand, TellsApartWhatFailsIsRefusedOrLacksAnInclude)
{
    const auto replaced = [](const std::string& what, const std::string& by)
    {
        std::string text = k_GoodShader;
        return text.replace(text.find(what), what.size(), by);
    };
    Write("compute.shader", replaced("#pragma fragment F", "#pragma fragment F\n#pragma hull H"));
    Write("fails.shader", replaced("return _Tint", "return _Tnt"));
    Write("good.shader", k_GoodShader);
    Write("include.shader", replaced("float4 _Tint;", "#include \"nosuch.hlsl\"\nfloat4 _Tint;"));
    Write("hdrp.shader",
          replaced("SubShader\n    {", "SubShader\n    {\n        Tags { \"RenderPipeline\" = "
                                       "\"HDRenderPipeline\" }"));
    const CommandRun run = RunCommand({"shader", (folder / "").string(), "-j", "2"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(LinesOf(run.out), testing::ElementsAre(Mentions(
                                      "5 files", "5 parsed", "2 errors", "1 of 2 passes",
                                      "1 failed", "2 refused", "1 with a missing include")));
    EXPECT_THAT(LinesOf(run.err),
                testing::Contains(Mentions("note:", "SubShader", "HDRenderPipeline")));
    EXPECT_THAT(run.err, Mentions("include.shader:18:", "#include", "\"nosuch.hlsl\""));
}

TEST_F(ShaderCommand, TellsOfEveryOtherFileWhenTheCompilerDiesOnOne)
{
    Write("a.shader", k_GoodShader);
    Write("dies.shader", k_GoodShader);
    Write("good.shader", k_GoodShader);
    std::string constant = k_GoodShader;
    constant.replace(constant.find("float4 _Tint;"), 13,
                     "uniform const sampler2D _T; float4 _Tint;");
    Write("object.shader",
          constant.replace(constant.find("return _Tint"), 12, "return _Tint * tex2D(_T, 0)"));
    const std::string path = (folder / "").string();
    setenv("LIMN_TEST_ABORT", "dies.shader", 1);
    const CommandRun text = RunCommand({"shader", path, "-j", "2"});
    const CommandRun json = RunCommand({"shader", path, "-j", "2", "--json"});
    unsetenv("LIMN_TEST_ABORT");
    EXPECT_EQ(1, text.exitCode);
    EXPECT_THAT(LinesOf(text.out), testing::ElementsAre(Mentions("4 files", "4 parsed", "1 error",
                                                                 "3 of 4 passes", "1 failed")));
    EXPECT_THAT(text.err,
                Mentions("dies.shader:14:13:", "compiler crashes", "Aborted", "signal 6"));
    EXPECT_EQ(1, json.exitCode);
    const nlohmann::json files = nlohmann::json::parse(json.out)["files"];
    ASSERT_EQ(4u, files.size());
    for (const nlohmann::json& file : files)
    {
        const bool dies = file["file"].get<std::string>().ends_with("dies.shader");
        const nlohmann::json& pass = file["subShaders"][0]["passes"][0];
        EXPECT_EQ(dies ? "failed" : "compiled", pass["outcome"]) << file["file"];
        EXPECT_THAT(pass.value("reason", ""),
                    testing::Conditional(dies, Mentions("compiler crashes", "signal 6"),
                                         testing::IsEmpty()));
    }
}

TEST_F(ShaderCommand, GivesAnErrorForTheReasonNotTheWarningsBeforeIt)
{
    std::string text = k_GoodShader;
    text.replace(text.find("return _Tint"), 12, "#warning first\nreturn _Tnt");
    const CommandRun run = RunCommand({"shader", Write("good.shader", text), "--json"});
    const nlohmann::json file = nlohmann::json::parse(run.out)["files"][0];
    EXPECT_EQ("'_Tnt': unknown variable", file["subShaders"][0]["passes"][0]["reason"]);
}

TEST_F(ShaderCommand, RefusesAGrabPassByName)
{
    std::string text = k_GoodShader;
    text.insert(text.find("Pass\n"), "GrabPass { \"_Grab\" }\n");
    const std::string path = Write("good.shader", text);
    const CommandRun run = RunCommand({"shader", path, "--json"});
    EXPECT_EQ(0, run.exitCode);
    const nlohmann::json passes =
        nlohmann::json::parse(run.out)["files"][0]["subShaders"][0]["passes"];
    EXPECT_EQ("refused", passes[0]["outcome"]);
    EXPECT_THAT(passes[0]["reason"].get<std::string>(),
                Mentions("GrabPass", "not supported", "_CameraOpaqueTexture"));
    EXPECT_EQ("compiled", passes[1]["outcome"]);
    EXPECT_THAT(run.err, Mentions("good.shader:6:9:", "note", "GrabPass", "not supported",
                                  "_CameraOpaqueTexture"));
}

TEST_F(ShaderCommand, CountsVariantsWithoutCompiling)
{
    std::string text = k_GoodShader;
    text.replace(text.find("return _Tint"), 12, "return _Tnt");
    const std::string path = Write("good.shader", text);
    const CommandRun run = RunCommand({"shader", path, "--variants"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ(path + ":6: pass 'Only': 2\ntotal: 2\n", run.out);
}

TEST_F(ShaderCommand, CompilesTheVariantOfTheKeywords)
{
    std::string text = k_GoodShader;
    const std::string line = "float4 _Tint;\n";
    text.insert(text.find(line) + line.size(), "#ifdef FOG\n#error foggy\n#endif\n");
    const std::string path = Write("good.shader", text);
    EXPECT_EQ(0, RunCommand({"shader", path}).exitCode);
    const CommandRun run = RunCommand({"shader", path, "--keywords", "FOG"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("foggy"));
}

TEST_F(ShaderCommand, ShowsWarningsOfFilesWithoutErrors)
{
    std::string text = k_GoodShader;
    text.insert(text.find("Cull [_Cull]"), "LOD 1e2\n");
    const CommandRun run = RunCommand({"shader", Write("good.shader", text), "--parse-only"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("good.shader:9:17: warning: "));
}

TEST_F(ShaderCommand, EmitsBothStagesInEveryLanguage)
{
    const std::string path = Write("good.shader", k_GoodShader);
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
    EXPECT_EQ(path + ": error: there is no such file\n", run.err);
}

TEST_F(ShaderCommand, LosesNoOtherFileToOneThatIsNotThere)
{
    std::string text = k_GoodShader;
    text.insert(text.rfind('}'), "Fallback \"My/Other\"\n"); // which is looked for in all folders
    const CommandRun run = RunCommand(
        {"shader", "--json", Write("good.shader", text), (folder / "none" / "no.shader").string()});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("no.shader: error: there is no such file"));
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(2u, json["files"].size());
    EXPECT_EQ(1, json["summary"]["passesCompiled"]);
}

TEST_F(ShaderCommand, WritesTwoShadersOfOneNameSideBySide)
{
    std::string other = k_GoodShader;
    other.replace(other.find("return _Tint;"), 13, "return _Tint * 2;");
    std::string alike = k_GoodShader;
    alike.replace(alike.find("My/Good"), 7, "my_good");
    const CommandRun run =
        RunCommand({"shader", Write("a.shader", k_GoodShader), Write("b.shader", other),
                    Write("c.shader", alike), "--emit", "glsl", "-o", (folder / "out").string()});
    EXPECT_EQ(0, run.exitCode) << run.err;
    const std::string first = ReadText((folder / "out/My_Good.0.frag.glsl").string());
    const std::string second = ReadText((folder / "out/My_Good-2.0.frag.glsl").string());
    EXPECT_FALSE(first.empty());
    EXPECT_FALSE(second.empty());
    EXPECT_NE(first, second);
    EXPECT_FALSE(ReadText((folder / "out/my_good-3.0.frag.glsl").string()).empty());
}

TEST_F(ShaderCommand, TakesPackagesByTheNamesTheyHaveThemselves)
{
    const auto write = [&](const std::string& name, const std::string& macro)
    {
        folder.Write("given/" + name + "@1/package.json", "{\"name\": \"com.me." + name + "\"}");
        folder.Write("given/" + name + "@1/a.hlsl", "#define " + macro + " 1\n");
        return (folder / ("given/" + name + "@1")).string();
    };
    const std::string one = write("one", "ONE");
    const std::string two = write("two", "TWO");
    std::string text = k_GoodShader;
    text.insert(text.find("float4 _Tint;"), "#include \"Packages/com.me.one/a.hlsl\"\n"
                                            "#include \"Packages/com.me.two/a.hlsl\"\n"
                                            "#if !ONE || !TWO\n#error none\n#endif\n");
    const std::string file = Write("t.shader", text);
    const std::vector<std::vector<std::string>> ways = {
        {"shader", file, "--package", one, "--package", two},
        {"shader", file, "--package", one, two},
        {"shader", file, "--package", "com.me.one=" + one, "com.me.two=" + two},
        {"shader", "--package", "com.me.one=" + one, "com.me.two=" + two, file},
        {"shader", "--package", one, "com.me.two=" + two, file},
        {"shader", "--package", (folder / "given").string(), file}};
    for (const std::vector<std::string>& way : ways)
    {
        const CommandRun run = RunCommand(way);
        EXPECT_EQ(0, run.exitCode) << run.err << testing::PrintToString(way);
    }
    EXPECT_EQ(1, RunCommand({"shader", file, "--package", one}).exitCode);
    // A folder that is a package may be what is to be checked.
    folder.Write("given/one@1/Own.shader", k_GoodShader);
    EXPECT_EQ(0, RunCommand({"shader", "--package", "com.me.two=" + two, one}).exitCode);
}

TEST_F(ShaderCommand, NamesAFolderWithoutShaders)
{
    const std::string path = (folder / "").string();
    const CommandRun run = RunCommand({"shader", path});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(LinesOf(run.err), testing::ElementsAre(Mentions(path + ":", "no .shader file")));
}

TEST_F(ShaderCommand, NotesOnceWhatAShaderUsesThatLimnDoesNotHave)
{
    const std::string pass =
        "Pass { HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl\"\n"
        "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
        "float4 F(float4 p : SV_POSITION) : SV_Target\n"
        "{ return float4(SampleLightmap(p.xy, p.xyz) * SampleMainLightCookie(p.xyz), 1); }\n"
        "ENDHLSL }\n";
    const std::string path =
        Write("baked.shader", "Shader \"My/Baked\" { SubShader {\n" + pass + pass + "} }");
    const CommandRun run = RunCommand({"shader", path});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(Mentions(path + ":", "note", "light cookies", "white"),
                                     Mentions(path + ":", "note", "light maps", "white")));
}

TEST_F(ShaderCommand, NotesOfManyFilesWhatTheyAllUseOnce)
{
    for (const char* name : {"a", "b", "c"})
    {
        std::string text = k_GoodShader;
        text.replace(text.find("return _Tint;"), 13, "return float4(SampleLightmap(0, 0), 1);");
        text.replace(text.find("#pragma vertex"), 0,
                     "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
                     "Lighting.hlsl\"\n");
        Write(name + std::string(".shader"), text);
    }
    const CommandRun run = RunCommand({"shader", (folder / "").string()});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(
        LinesOf(run.err),
        testing::ElementsAre(Mentions((folder / "a.shader").string() + ":", "note", "light maps"),
                             Mentions("note", "2 more files", "light maps")));
}

TEST_F(ShaderCommand, WithNothingButRefusalsFailsAndSaysSo)
{
    std::string surface = k_GoodShader;
    surface.replace(surface.find("#pragma fragment F"), 18, "#pragma surface F");
    const std::string path = Write("surface.shader", surface);
    const CommandRun single = RunCommand({"shader", path});
    EXPECT_EQ(1, single.exitCode);
    EXPECT_THAT(single.err, Mentions("error:", "nothing was compiled", "1 pass,"));
    Write("second.shader", surface);
    const CommandRun all = RunCommand({"shader", (folder / "").string()});
    EXPECT_EQ(1, all.exitCode);
    EXPECT_THAT(all.err, Mentions("error:", "nothing was compiled", "2 passes"));
    EXPECT_EQ("2 files: 2 parsed (100.0 %); 0 of 0 passes compiled, 2 refused\n", all.out);
    EXPECT_EQ(0, RunCommand({"shader", path, "--parse-only"}).exitCode);
    Write("good.shader", k_GoodShader);
    EXPECT_EQ(0, RunCommand({"shader", (folder / "").string()}).exitCode);
}

TEST_F(ShaderCommand, WarnsOfKeywordsThatNoPassDeclares)
{
    const std::string path = Write("good.shader", k_GoodShader);
    const CommandRun near = RunCommand({"shader", path, "--keywords", "FOG,FOGG"});
    EXPECT_EQ(0, near.exitCode);
    EXPECT_THAT(LinesOf(near.err),
                testing::ElementsAre(Mentions("warning: --keywords:", "'FOGG'", "'FOG'")));
    EXPECT_THAT(LinesOf(RunCommand({"shader", path, "--keywords", "_SHADOWS"}).err),
                testing::ElementsAre(Mentions("warning: --keywords:", "'_SHADOWS'", "FOG")));
    EXPECT_EQ("", RunCommand({"shader", path, "--keywords", "FOG"}).err);
}

} // namespace limn::test
