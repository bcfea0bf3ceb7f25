#include "Mentions.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

/// A shader with one pass, which stands on line 2.
std::string OnePass(const std::string& name, const std::string& pass,
                    const std::string& color = "1")
{
    return "Shader \"" + name + "\" { SubShader {\nPass { Name \"" + pass +
           "\"\nHLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
           "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
           "float4 F() : SV_Target { return " +
           color + "; }\nENDHLSL\n} } }\n";
}

const std::string k_ForeignSubShader =
    "SubShader { Tags { \"RenderPipeline\" = \"OtherPipeline\" } Pass { } }";

/// `limn shader` and other shaders: UsePass and Fallback.
class ShaderReference : public testing::Test
{
protected:
    std::string Write(const std::string& name, const std::string& text) const
    {
        return folder.Write(name, text).string();
    }

    std::string Folder() const { return (folder / "").string(); }

    TemporaryFolder folder;
};

} // namespace

TEST_F(ShaderReference, AUsePassIsFollowedAndCountsOnceInItsOwnFile)
{
    const std::string library = Write("library.shader", OnePass("Lib/Passes", "Hull"));
    const std::string user =
        Write("user.shader", "Shader \"User\" { SubShader { UsePass \"Lib/Passes/HULL\" } }");
    const CommandRun both = RunCommand({"shader", Folder()});
    EXPECT_EQ(0, both.exitCode);
    EXPECT_EQ("", both.err);
    EXPECT_EQ("2 files: 2 parsed (100.0 %); 1 of 1 pass compiled (100.0 %)\n", both.out);

    const CommandRun single = RunCommand({"shader", user});
    EXPECT_EQ(0, single.exitCode);
    EXPECT_THAT(single.out, HasSubstr("      UsePass \"Lib/Passes/HULL\": 'Hull' at " + library +
                                      ":2, compiled\n"));
}

TEST_F(ShaderReference, AUsePassInJsonSaysWhereItLeads)
{
    const std::string library = Write("library.shader", OnePass("Lib/Passes", "Hull"));
    const std::string user =
        Write("user.shader", "Shader \"User\" { SubShader { UsePass \"Lib/Passes/HULL\" } }");
    const nlohmann::json json = nlohmann::json::parse(RunCommand({"shader", user, "--json"}).out);
    const nlohmann::json& pass = json["files"][0]["subShaders"][0]["passes"][0];
    EXPECT_EQ("not tried", pass["outcome"]) << "as before: it counts where it stands";
    EXPECT_EQ("Hull", pass["use"]["name"]);
    EXPECT_EQ(library, pass["use"]["file"]);
    EXPECT_EQ(2, pass["use"]["line"]);
    EXPECT_EQ("compiled", pass["use"]["outcome"]);
    EXPECT_EQ(0, json["summary"]["passesTried"]);
}

TEST_F(ShaderReference, AnErrorInTheUsedPassIsAnErrorOfItsFileOnly)
{
    const std::string library = Write("library.shader", OnePass("Lib/Passes", "Hull", "nothing"));
    const std::string user =
        Write("user.shader", "Shader \"User\" { SubShader {\n  UsePass \"Lib/Passes/HULL\" } }");
    const std::string warning = user + ":2:3: warning: UsePass: the pass at " + library +
                                ":2 cannot be drawn: 'nothing': unknown variable\n";
    const CommandRun single = RunCommand({"shader", user});
    EXPECT_EQ(0, single.exitCode);
    EXPECT_THAT(single.err, HasSubstr(warning));
    const CommandRun both = RunCommand({"shader", Folder()});
    EXPECT_EQ(1, both.exitCode);
    EXPECT_THAT(LinesOf(both.out), testing::ElementsAre(Mentions("2 files", "2 parsed", "1 error",
                                                                 "0 of 1 pass", "1 failed")));
}

TEST_F(ShaderReference, AUsePassThatLeadsNowhereIsAnErrorAsInAScene)
{
    Write("library.shader", OnePass("Lib/Passes", "Hull"));
    const std::string user =
        Write("user.shader", "Shader \"User\" { SubShader {\n  UsePass \"Lib/Pases/HULL\" } }");
    const CommandRun run = RunCommand({"shader", user});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr(user + ":2:3: error: UsePass: unknown shader 'Lib/Pases'; did "
                                          "you mean 'Lib/Passes'?\n"));
}

TEST_F(ShaderReference, AnUnknownFallbackIsAWarningAtItsPlace)
{
    const std::string toon = Write("toon.shader", OnePass("Toon", "P"));
    const std::string user = Write("user.shader", "Shader \"User\" { SubShader { Pass { } }\n"
                                                  "  Fallback \"Toom\" }");
    const CommandRun run = RunCommand({"shader", user});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr(user + ":2:3: warning: Fallback: unknown shader 'Toom'; did you "
                                          "mean 'Toon'?\n"));
}

TEST_F(ShaderReference, UnitysOwnShadersAreANote)
{
    for (const std::string name :
         {"FX/Flare", "Sprites/Diffuse", "Legacy Shaders/Transparent/VertexLit"})
    {
        const std::string user =
            Write("user.shader", "Shader \"User\" { SubShader {\n  UsePass \"" + name +
                                     "/SHADOWCASTER\"\nPass { } }\n"
                                     "  Fallback \"" +
                                     name + "\" }");
        const CommandRun run = RunCommand({"shader", user});
        EXPECT_EQ(0, run.exitCode) << name;
        EXPECT_THAT(run.err,
                    Mentions(user + ":2:3:", "note", "UsePass", "'" + name + "'", "Unity's own"));
        EXPECT_THAT(run.err,
                    Mentions(user + ":4:3:", "note", "Fallback", "'" + name + "'", "Unity's own"));
    }
}

TEST_F(ShaderReference, ShadowsOfUnitysOwnShadersAreThere)
{
    for (const auto& [name, pass] :
         {std::pair("VertexLit", "SHADOWCASTER"),
          std::pair("Legacy Shaders/VertexLit", "SHADOWCASTER"),
          std::pair("Legacy Shaders/Transparent/Cutout/VertexLit", "CASTER")})
    {
        const std::string user =
            Write("user.shader", std::string("Shader \"User\" { SubShader {\n  UsePass \"") + name +
                                     "/" + pass + "\"\nPass { } }\n  Fallback \"" + name + "\" }");
        const CommandRun run = RunCommand({"shader", user});
        EXPECT_EQ(0, run.exitCode) << name;
        EXPECT_THAT(run.err, testing::Not(HasSubstr("note"))) << name;
        EXPECT_THAT(run.err, testing::Not(HasSubstr("warning"))) << name;
    }
    const std::string lit = Write("lit.shader", "Shader \"Lit\" { SubShader {\n"
                                                "UsePass \"Diffuse/FORWARD\"\nPass { } } }\n");
    const CommandRun run = RunCommand({"shader", lit});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(run.err, Mentions(lit + ":2:1:", "note", "UsePass", "'Diffuse'", "Unity's own"));
}

TEST_F(ShaderReference, UnitysErrorShaderAsAFallbackIsNothingToSay)
{
    for (const std::string name :
         {"Hidden/InternalErrorShader", "Hidden/Universal Render Pipeline/FallbackError"})
    {
        const std::string user = Write("user.shader", "Shader \"User\" { SubShader { Pass { } }\n"
                                                      "  Fallback \"" +
                                                          name + "\" }");
        const CommandRun run = RunCommand({"shader", user});
        EXPECT_EQ(0, run.exitCode) << name;
        EXPECT_THAT(run.err, testing::Not(HasSubstr("Fallback"))) << name;
    }
}

TEST_F(ShaderReference, TheFallbackThatDrawsIsNamed)
{
    Write("base.shader", OnePass("Lib/Base", "P"));
    const std::string user = Write("user.shader", "Shader \"User\" { " + k_ForeignSubShader +
                                                      " Fallback \"Lib/Base\" }");
    EXPECT_THAT(RunCommand({"shader", user}).out,
                HasSubstr("  drawn with its Fallback \"Lib/Base\"\n  SubShader 0: "));
    const nlohmann::json json = nlohmann::json::parse(RunCommand({"shader", user, "--json"}).out);
    EXPECT_EQ("Lib/Base", json["files"][0]["fallback"]);
    EXPECT_EQ("Lib/Base", json["files"][0]["drawnFallback"]);
    EXPECT_EQ(false, json["files"][0]["subShaders"][0]["used"]);
}

TEST_F(ShaderReference, IncludesMayLieAnywhereInAFolderThatIsGiven)
{
    Write("Library/Color.hlsl", "float4 Red() { return float4(1, 0, 0, 1); }\n");
    const std::string user =
        Write("Shaders/Toon/User.shader",
              "Shader \"User\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex V\n"
              "#pragma fragment F\n#include \"../../Library/Color.hlsl\"\n"
              "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
              "float4 F() : SV_Target { return Red(); }\nENDHLSL } } }\n");
    const CommandRun alone = RunCommand({"shader", user});
    EXPECT_EQ(1, alone.exitCode);
    EXPECT_THAT(alone.err, Mentions("Color.hlsl", "outside", "--root"));
    const CommandRun whole = RunCommand({"shader", Folder()});
    EXPECT_EQ(0, whole.exitCode) << whole.err;
}

TEST_F(ShaderReference, OtherShadersAreLookedForInTheAssetsAround)
{
    std::filesystem::create_directories(folder / "Assets/Toon");
    std::filesystem::create_directories(folder / "Assets/Library");
    Write("Assets/Library/library.shader", OnePass("Lib/Passes", "Hull"));
    const std::string user = Write("Assets/Toon/user.shader",
                                   "Shader \"User\" { SubShader { UsePass \"Lib/Passes/HULL\" } }");
    const CommandRun run = RunCommand({"shader", user});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, HasSubstr("library.shader:2, compiled\n"));
}

} // namespace limn::test
