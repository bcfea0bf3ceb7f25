#include <limn/shaderlab/ProgramRequirements.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::Mentions;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> PragmaNames(const PassProgram& program)
{
    std::vector<std::string> names;
    for (const ProgramPragma& pragma : program.pragmas)
    {
        names.push_back(pragma.name);
    }
    return names;
}

std::string Reason(const std::string& hlsl, std::vector<std::string> missing = {})
{
    const auto reason = ReasonNotSupported(test::ProgramOf(hlsl), missing);
    return reason ? ToString(*reason) : "";
}

TEST(ProgramPragma, CountsWhereTheProgramsOwnMacrosSaySo)
{
    const PassProgram program = test::ProgramOf(R"(
#define OWN 2
#define EMPTY
#if OWN >= 2 && defined(SHADER_API_DESKTOP) && !defined(SHADER_API_MOBILE)
#pragma multi_compile _ YES
#elif 1
#pragma multi_compile _ NO
#else
#pragma multi_compile _ NO
#endif
#ifdef KEYWORD
#  if 1
#pragma multi_compile _ NO
#  endif
#else
#  ifndef EMPTY
#pragma multi_compile _ NO
#  elif (OWN << 2) == 8
#pragma multi_compile _ ALSO
#  endif
#endif
#undef OWN
#if OWN
#pragma multi_compile _ NO
#endif
#if defined SHADER_API_VULKAN && UNITY_VERSION >= 202200 && SHADER_API_METAL == 0
#pragma vertex vert
#endif
)");
    ASSERT_EQ(program.keywordSets.size(), 2u);
    EXPECT_THAT(program.keywordSets[0].keywords, ElementsAre("", "YES"));
    EXPECT_THAT(program.keywordSets[1].keywords, ElementsAre("", "ALSO"));
    EXPECT_EQ(program.vertex.name, "vert");
}

TEST(ProgramPragma, ComesToAnEndOnMacrosThatNameEachOther)
{
    std::string hlsl = "\n#define A0 A1 + A1\n";
    for (int i = 1; i < 60; ++i)
    {
        const std::string next = "A" + std::to_string(i + 1);
        hlsl += "#define A" + std::to_string(i) + " " + next + " + " + next + "\n";
    }
    hlsl += "#define LOOP LOOP\n#if A0\n#pragma vertex a\n#endif\n#if LOOP\n#pragma fragment b\n"
            "#endif\n#if " +
            std::string(5000, '(') + "\n#endif\n";
    EXPECT_EQ(test::ProgramOf(hlsl).fragment.name, "");
}

TEST(ProgramPragma, ReadsPragmaAndDefinitionGluedTogether)
{
    const PassProgram program =
        test::ProgramOf("\n#pragma multi_compile_instancing#define GLUED 1\n"
                        "#if GLUED\n#pragma vertex v\n#endif\n");
    EXPECT_THAT(program.keywordSets.at(0).keywords, ElementsAre("", "INSTANCING_ON"));
    EXPECT_EQ(program.vertex.name, "v");
    const auto pass = test::CompileHlsl("#pragma multi_compile_instancing#define GLUED 1\n"
                                        "float4 vert() : SV_POSITION { return GLUED; }\n"
                                        "float4 frag() : SV_Target { return 1; }");
    EXPECT_FALSE(pass->vertexSpirv.empty());
}

TEST(ProgramPragma, KnowsTheSuffixesOfKeywordDirectives)
{
    const PassProgram program = test::ProgramOf(
        "\n#pragma shader_feature_fragment_local _A\n#pragma multi_compile_hull _ B\n"
        "#pragma dynamic_branch_local C\n#pragma multi_compile_fgo\n");
    ASSERT_EQ(program.keywordSets.size(), 3u);
    EXPECT_TRUE(program.keywordSets[0].isLocal);
    EXPECT_EQ(program.keywordSets[0].stages, ShaderStage::Fragment);
    EXPECT_EQ(program.keywordSets[1].stages, ShaderStage::None);
    EXPECT_TRUE(program.keywordSets[2].isDynamic);
    EXPECT_THAT(program.keywordSets[2].keywords, ElementsAre("", "C"));
    EXPECT_THAT(PragmaNames(program), ElementsAre("multi_compile_fgo"));
}

TEST(ProgramPragma, StandsForSeveralSetsInTheShortcutsOfTheBuiltInPipeline)
{
    const PassProgram program = test::ProgramOf("\n#pragma multi_compile_fwdadd_fullshadows\n");
    ASSERT_EQ(program.keywordSets.size(), 5u);
    EXPECT_THAT(program.keywordSets[0].keywords,
                ElementsAre("POINT", "DIRECTIONAL", "SPOT", "POINT_COOKIE", "DIRECTIONAL_COOKIE"));
    EXPECT_THAT(program.keywordSets[2].keywords, ElementsAre("", "SHADOWS_SOFT"));
    EXPECT_THAT(test::ProgramOf("\n#pragma multi_compile_fwdbase\n").keywordSets.at(0).keywords,
                ElementsAre("DIRECTIONAL"));
}

TEST(ProgramPragma, RequiresTheFeaturesOfItsShaderModel)
{
    EXPECT_THAT(RequiredFeatures(test::ProgramOf("\n#pragma target 2.0\n")), IsEmpty());
    EXPECT_THAT(RequiredFeatures(test::ProgramOf("\n")), ElementsAre("derivatives"));
    EXPECT_THAT(
        RequiredFeatures(test::ProgramOf("\n#pragma target 3.0\n#pragma require 2DArray MRT8\n")),
        ElementsAre("2darray", "derivatives", "fragcoord", "interpolators10", "mrt8", "samplelod"));
    const auto model45 = RequiredFeatures(test::ProgramOf("\n#pragma target 4.5\n"));
    EXPECT_THAT(model45, ElementsAre("2darray", "compute", "derivatives", "fragcoord", "instancing",
                                     "integers", "interpolators10", "interpolators15", "mrt4",
                                     "msaatex", "randomwrite", "samplelod"));
    const auto model50 = RequiredFeatures(test::ProgramOf("\n#pragma target 5.0\n"));
    EXPECT_THAT(model50, Contains("tessellation"));
    EXPECT_THAT(model50, Not(Contains("cubearray")));
    EXPECT_THAT(RequiredFeatures(test::ProgramOf("\n#pragma geometry g\n")), Contains("geometry"));
    EXPECT_THAT(RequiredFeatures(test::ProgramOf("\n#pragma require cubearray : _KEYWORD\n")),
                ElementsAre("derivatives"));
}

TEST(ProgramPragma, RefusesWhatLimnDoesNotDoInOneSentence)
{
    EXPECT_THAT(
        Reason("\n#pragma surface surf Lambert\n"),
        Mentions("t.shader:2:1: error: #pragma surface", "not supported", "fragment function"));
    EXPECT_THAT(
        Reason("\n#pragma raytracing hit\n"),
        Mentions("t.shader:2:1: error: #pragma raytracing", "not supported", "fragment function"));
    EXPECT_THAT(Reason("\n#pragma kernel main\n"),
                Mentions("t.shader:2:1: error: #pragma kernel", ".compute file"));
    EXPECT_THAT(Reason("\n#pragma domain d\n"),
                Mentions("t.shader:2:1: error: #pragma domain", "no #pragma hull", "needs both"));
    EXPECT_THAT(Reason("\n#pragma geometry g\n", {"geometry"}),
                Mentions("t.shader:1:33: error: program", "'geometry'", "device"));
    EXPECT_THAT(Reason("\n#pragma require framebufferfetch\n"),
                Mentions("t.shader:1:33: error: program", "'framebufferfetch'", "limn"));
    EXPECT_THAT(Reason("\n#pragma target 4.0\n", {"geometry"}),
                Mentions("t.shader:1:33: error: program", "'geometry'", "device"));
    EXPECT_EQ(Reason("\n#pragma target 4.0\n"), "");
}

TEST(ProgramPragma, GlslIsReadAndRefused)
{
    const ShaderLabDocument document = test::ParseGood(
        "Shader \"T\" { GLSLINCLUDE\nA ENDGLSL SubShader { Pass { GLSLPROGRAM } {\nENDGLSL } } }");
    const PassProgram& program = document.subShaders.at(0).passes.at(0).program.value();
    EXPECT_EQ(program.language, ProgramLanguage::Glsl);
    EXPECT_EQ(program.chunks.at(0).text, "\nA ");
    EXPECT_EQ(program.chunks.at(1).text, " } {\n");
    EXPECT_THAT(ToString(ReasonNotSupported(program).value()),
                Mentions("t.shader:2:30: error: GLSLPROGRAM", "not supported", "HLSL"));
}

TEST(ProgramPragma, LetsVulkanDecideOverRenderers)
{
    EXPECT_EQ(Reason("\n#pragma exclude_renderers gles d3d11_9x\n"), "");
    EXPECT_EQ(Reason("\n#pragma only_renderers d3d11 Vulkan metal\n"), "");
    EXPECT_THAT(
        Reason("\n#pragma exclude_renderers gles vulkan\n"),
        Mentions("t.shader:2:1: error: #pragma exclude_renderers", "Vulkan", "remove 'vulkan'"));
    EXPECT_THAT(Reason("\n#pragma only_renderers gles ps4\n"),
                Mentions("t.shader:2:1: error: #pragma only_renderers", "Vulkan", "add 'vulkan'"));
}

// Direct3D 11 is what Unity's editor draws with on Windows.
TEST(ProgramPragma, TakesWhatIsMadeForDirect3D11)
{
    EXPECT_EQ(Reason("\n#pragma only_renderers gles gles3 glcore d3d11\n"), "");
    EXPECT_EQ(Reason("\n#pragma only_renderers d3d11 ps4\n"), "");
}

TEST(ProgramPragma, OfTessellationNamesFunctionsThatAreThere)
{
    PassProgram program =
        test::Program("float4 vert(float4 p : POSITION) : SV_POSITION { return p; }"
                      " float4 frag() : SV_Target { return 1; }");
    program.pragmas = {{{3, 1}, "hull", "Hull"}, {{4, 1}, "domain", "Domain"}};
    EXPECT_THAT(
        test::CompileMessages(program),
        ElementsAre(Mentions("t.shader:3:1: error: #pragma hull", "no function 'Hull'"),
                    Mentions("t.shader:4:1: error: #pragma domain", "no function 'Domain'")));
}

TEST(ProgramPragma, IsRefusedByTheCompilerAsUnsupported)
{
    PassProgram program = test::Program("");
    program.pragmas = {{{3, 1}, "hull", "hull"}};
    ShaderCompiler compiler;
    EXPECT_THROW(compiler.Compile(program), UnsupportedProgramError);
    EXPECT_THAT(
        test::CompileMessages(test::Program(
            "\n#include \"Packages/com.unity.render-pipelines.high-definition/Runtime/X.hlsl\"")),
        ElementsAre(Mentions("t.shader:1:1: error: program", "High Definition")));
}

TEST(ProgramPragma, IsQuestionedWhereNobodyKnowsIt)
{
    const PassProgram program = test::ProgramOf(
        "\n#pragma multi_compile_fgo\n#pragma fragmnet frag\n#pragma zzz\n"
        "#pragma target high\n#pragma require cubearay\n#pragma only_renderers vulcan\n"
        "#pragma prefer_hlslcc gles\n#pragma fragmentoption ARB_x\n"
        "#pragma editor_sync_compilation\n#pragma warning (disable : 3206)\n");
    EXPECT_THAT(
        test::Messages(CheckPragmas(program)),
        ElementsAre(Mentions("2:1: warning: #pragma multi_compile_fgo", "no such pragma",
                             "'multi_compile_fog'"),
                    Mentions("3:1: warning: #pragma fragmnet", "no such pragma", "'fragment'"),
                    Mentions("4:1: warning: #pragma zzz", "no such pragma", "no effect"),
                    Mentions("5:1: warning: #pragma target", "'high'", "2.0 to 5.0"),
                    Mentions("6:1: warning: #pragma require", "'cubearay'", "'cubearray'"),
                    Mentions("7:1: warning: #pragma only_renderers", "'vulcan'", "'vulkan'")));
}

TEST(ProgramPragma, ReachesTheCallerAsAWarningTogetherWithWarningDirectives)
{
    PassProgram program = test::Program("#ifdef NEVER\n#warning not this\n#endif\n"
                                        "  #warning mind the gap\n"
                                        "float4 vert() : SV_POSITION { return 0; }\n"
                                        "float4 frag() : SV_Target { return 1; }");
    program.pragmas = {{{9, 1}, "zzz", ""}};
    test::TemporaryFolder folder;
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path();
    for (int i = 0; i < 2; ++i)
    {
        ShaderCompiler compiler(options);
        EXPECT_THAT(test::Messages(compiler.Compile(program)->diagnostics),
                    ElementsAre(Mentions("9:1: warning: #pragma zzz", "no such pragma"),
                                "4: warning: '#warning': mind the gap"));
        EXPECT_EQ(compiler.statistics().loadedFromCache, i);
    }
}

TEST(ProgramPragma, IsWarnedAboutAtItsNewLineWhenTheProgramMoves)
{
    PassProgram program = test::Program("#warning here\n"
                                        "float4 vert() : SV_POSITION { return 0; }\n"
                                        "float4 frag() : SV_Target { return 1; }");
    test::TemporaryFolder folder;
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path();
    ShaderCompiler compiler(options);
    for (const int line : {1, 6})
    {
        program.chunks[0].firstLine = line;
        EXPECT_THAT(test::Messages(compiler.Compile(program)->diagnostics),
                    ElementsAre(std::to_string(line) + ": warning: '#warning': here"));
    }
}

TEST(ProgramPragma, IsReadFromFilesIncludedWithPragmasAndFromNoOthers)
{
    test::TemporaryFolder folder;
    folder.Write("a.hlsl", "#pragma vertex vert\n#include_with_pragmas \"sub/b.hlsl\"\n"
                           "float4 vert(float4 p : POSITION) : SV_POSITION { return p; }\n");
    folder.Write("sub/b.hlsl", "#pragma once\n#pragma fragment frag\n#pragma multi_compile A B\n"
                               "#include_with_pragmas \"../a.hlsl\"\n");
    folder.Write("c.hlsl", "#pragma multi_compile C D\n#pragma vertex wrong\n"
                           "float4 frag() : SV_Target { return A; }\n");
    PassProgram program =
        test::ProgramOf("\n#include_with_pragmas \"a.hlsl\"\n#include \"c.hlsl\"\n"
                        "#if 0\n#include_with_pragmas \"c.hlsl\"\n#endif\n");
    program.file = (folder.path() / "t.shader").string();
    EXPECT_EQ(program.vertex.name, "");
    ShaderCompiler compiler;
    const PassProgram complete = compiler.ReadPragmas(program);
    EXPECT_EQ(complete.vertex, (EntryPoint{"vert", {2, 1}}));
    EXPECT_EQ(complete.fragment.name, "frag");
    ASSERT_EQ(complete.keywordSets.size(), 1u);
    EXPECT_THAT(complete.keywordSets[0].keywords, ElementsAre("A", "B"));
}

TEST(ProgramPragma, ThatIsMissingIsSaidToBeInAFileThatIsIncludedPlainly)
{
    test::TemporaryFolder folder;
    folder.Write("a.hlsl", "#pragma vertex vert\n"
                           "float4 vert(float4 p : POSITION) : SV_POSITION { return p; }\n");
    PassProgram program =
        test::ProgramOf("\n#include \"a.hlsl\"\nfloat4 frag() : SV_Target { return 1; }\n");
    program.file = (folder.path() / "t.shader").string();
    ShaderCompiler compiler;
    try
    {
        compiler.Compile(program);
        FAIL() << "it compiles";
    }
    catch (const AssetError& error)
    {
        EXPECT_THAT(test::Messages(error.diagnostics()),
                    ElementsAre(Mentions("'#pragma vertex' is missing", "an included file has it",
                                         "only #include_with_pragmas takes pragmas"),
                                Mentions("'#pragma fragment' is missing",
                                         "it names the fragment function")));
    }
}

} // namespace
} // namespace limn
