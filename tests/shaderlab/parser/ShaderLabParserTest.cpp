#include "Mentions.h"
#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

using test::Mentions;
using test::ParseGood;
using test::ParsePass;

TEST(ShaderLabParser, ReadsTheStructureOfAFile)
{
    const ShaderLabDocument document = ParseGood(R"(
Shader "Folder/Name"
{
    Properties { _A ("A", Float) = 1 }
    SubShader
    {
        Tags { "Queue" = "Transparent+1" "RenderType"="Opaque" }
        LOD 300
        Pass { Name "First" }
        Pass { Tags { "LightMode" = "UniversalForward" } }
    }
    SubShader { }
    Fallback "Other/Shader"
    CustomEditor "My.Editor"
    CustomEditorForRenderPipeline "E" "Asset"
    Dependency "BaseMapShader" = "Hidden/Base"
}
)");
    EXPECT_EQ(document.name, "Folder/Name");
    EXPECT_EQ(document.location, (SourceLocation{2, 1}));
    ASSERT_EQ(document.subShaders.size(), 2u);
    const ShaderLabSubShader& first = document.subShaders[0];
    EXPECT_EQ(*first.tags.Find("queue"), "Transparent+1");
    EXPECT_EQ(*first.tags.Find("RenderType"), "Opaque");
    EXPECT_EQ(first.tags.Find("LightMode"), nullptr);
    EXPECT_EQ(first.lod, 300);
    ASSERT_EQ(first.passes.size(), 2u);
    EXPECT_EQ(first.passes[0].name, "First");
    EXPECT_EQ(first.passes[0].location, (SourceLocation{9, 9}));
    EXPECT_EQ(first.passes[0].lightMode(), "SRPDefaultUnlit");
    EXPECT_EQ(first.passes[1].lightMode(), "UniversalForward");
    EXPECT_EQ(document.fallback, "Other/Shader");
    EXPECT_EQ(document.customEditor, "My.Editor");
    EXPECT_EQ(document.pipelineEditors.at(0).pipelineAsset, "Asset");
    EXPECT_EQ(document.dependencies.at(0).shader, "Hidden/Base");
}

TEST(ShaderLabParser, IgnoresTheCaseOfKeywords)
{
    const ShaderLabDocument document =
        ParseGood("SHADER \"x\" { properties { _A (\"a\", RANGE(0,1)) = .5 } Subshader { TAGS { "
                  "\"a\" = \"b\" } pass { NAME \"n\" CULL fRONT } } FallBack OFF }");
    EXPECT_EQ(document.properties.at(0).type, ShaderPropertyType::Range);
    EXPECT_EQ(document.subShaders.at(0).passes.at(0).name, "n");
    EXPECT_EQ(document.subShaders.at(0).passes.at(0).state.cull.value, CullMode::Front);
}

TEST(ShaderLabParser, ReadsFilesWithByteOrderMarksAndWindowsLineEnds)
{
    const std::string mark = "\xEF\xBB\xBF";
    const ShaderLabDocument document = ParseGood(
        mark + mark + "Shader \"x\"\r\n{\r\n  SubShader { Pass { ZWrite Off } }\r\n}\r\n");
    EXPECT_EQ(document.location, (SourceLocation{1, 1}));
    EXPECT_EQ(document.subShaders.at(0).location, (SourceLocation{3, 3}));
    EXPECT_FALSE(document.subShaders.at(0).passes.at(0).state.zWrite.value);
}

TEST(ShaderLabParser, SkipsCommentsInAnyLanguageAndNestedOnes)
{
    const ShaderLabPass pass =
        ParsePass("Cull Off // 剔除 } \n /* a /* 描边 */ ZWrite Off */ ZTest Less");
    EXPECT_EQ(pass.state.cull.value, CullMode::Off);
    EXPECT_TRUE(pass.state.zWrite.value);
    EXPECT_EQ(pass.state.zTest.value, CompareFunction::Less);
}

TEST(ShaderLabParser, ClosesACommentThatOpensTwiceAndClosesOnce)
{
    EXPECT_EQ(ParsePass("/* a /* b */ Cull Off").state.cull.value, CullMode::Off);
}

TEST(ShaderLabParser, AcceptsACommentBehindTheShader)
{
    EXPECT_EQ(ParseGood("Shader \"x\" { } /*ASEBEGIN } { ASEEND*/ //CHKSM").name, "x");
}

TEST(ShaderLabParser, AddsTagBlocksTogetherAndLetsTheLaterValueWin)
{
    const ShaderLabPass pass =
        ParsePass("Tags { \"A\" = \"1\" \"B\" = \"2\" } Tags { \"a\" = \"3\" }");
    ASSERT_EQ(pass.tags.items.size(), 2u);
    EXPECT_EQ(*pass.tags.Find("A"), "3");
    EXPECT_EQ(*pass.tags.Find("B"), "2");
}

TEST(ShaderLabParser, GivesTheStateBeforeAPassInASubShaderToThatPassAndLaterOnes)
{
    const ShaderLabDocument document = ParseGood(R"(Shader "x" { SubShader {
        ZWrite Off
        Pass { }
        Cull Front
        Pass { ZWrite On }
        Pass { }
    } SubShader { Pass { } } })");
    const auto& passes = document.subShaders.at(0).passes;
    EXPECT_FALSE(passes.at(0).state.zWrite.value);
    EXPECT_EQ(passes.at(0).state.cull.value, CullMode::Back);
    EXPECT_TRUE(passes.at(1).state.zWrite.value);
    EXPECT_EQ(passes.at(1).state.cull.value, CullMode::Front);
    EXPECT_FALSE(passes.at(2).state.zWrite.value);
    EXPECT_EQ(passes.at(2).state.cull.value, CullMode::Front);
    EXPECT_EQ(document.subShaders.at(1).passes.at(0).state, RenderState{});
}

TEST(ShaderLabParser, GivesTheStateAndTagsOfACategoryToItsSubShaders)
{
    const ShaderLabDocument document = ParseGood(R"(Shader "x" {
        Category { Tags { "Queue" = "Overlay" } Blend One One SubShader { Pass { } } }
        SubShader { Pass { } } })");
    EXPECT_EQ(*document.subShaders.at(0).tags.Find("Queue"), "Overlay");
    EXPECT_TRUE(document.subShaders.at(0).passes.at(0).state.targets[0].enabled);
    EXPECT_EQ(document.subShaders.at(1).tags.Find("Queue"), nullptr);
    EXPECT_EQ(document.subShaders.at(1).passes.at(0).state, RenderState{});
}

TEST(ShaderLabParser, TakesTheLastFallbackAndSaysWhatItReplaces)
{
    const ShaderLabParseResult result =
        ParseShaderLab("Shader \"x\" { Fallback \"a\" Fallback \"b\", 1 }", "t.shader");
    EXPECT_EQ(result.document.fallback, "b");
    EXPECT_EQ(test::Messages(result.diagnostics),
              std::vector<std::string>{"1:27: note: Fallback: it replaces \"a\" given before"});
    EXPECT_EQ(
        ParseShaderLab("Shader \"x\" { Fallback \"a\" Fallback False }", "t").document.fallback,
        "");
    EXPECT_EQ(ParseGood("Shader \"x\" { Fallback \"None\" }").fallback, "None");
}

TEST(ShaderLabParser, KeepsUsePassAndGrabPassAsPasses)
{
    const ShaderLabDocument document = ParseGood(R"(Shader "x" { SubShader { Cull Off
        UsePass "A/B/NAME"
        GrabPass { }
        GrabPass { "_Grab" Name "G" Tags { "LightMode" = "Always" } }
        Pass { } } })");
    const auto& passes = document.subShaders.at(0).passes;
    ASSERT_EQ(passes.size(), 4u);
    EXPECT_EQ(passes[0].kind, ShaderLabPassKind::UsePass);
    EXPECT_EQ(passes[0].usePass, "A/B/NAME");
    EXPECT_EQ(passes[0].state, RenderState{});
    EXPECT_EQ(passes[0].lightMode(), "UsePass");
    EXPECT_EQ(passes[1].kind, ShaderLabPassKind::GrabPass);
    EXPECT_EQ(passes[1].grabTexture, "");
    EXPECT_EQ(passes[1].lightMode(), "GrabPass");
    EXPECT_EQ(passes[2].grabTexture, "_Grab");
    EXPECT_EQ(passes[2].name, "G");
    EXPECT_EQ(*passes[2].tags.Find("LightMode"), "Always");
    EXPECT_EQ(passes[3].kind, ShaderLabPassKind::Pass);
    EXPECT_EQ(passes[3].state.cull.value, CullMode::Off);
}

TEST(ShaderLabParser, KeepsPackageRequirementsOfSubShadersAndPasses)
{
    const ShaderLabDocument document = ParseGood(R"x(Shader "x" { SubShader {
        PackageRequirements { "com.unity.a": "[1.0,2.0)" "com.unity.b" }
        Pass
{
    PackageRequirements
    {
        "unity" : "2021.2"
    }
}
}
})x");
    const ShaderLabSubShader& subShader = document.subShaders.at(0);
    ASSERT_EQ(subShader.packageRequirements.size(), 2u);
    EXPECT_EQ(subShader.packageRequirements[0].package, "com.unity.a");
    EXPECT_EQ(subShader.packageRequirements[0].range, "[1.0,2.0)");
    EXPECT_EQ(subShader.packageRequirements[1].range, "");
    EXPECT_EQ(subShader.packageRequirements[1].location, (SourceLocation{2, 58}));
    EXPECT_EQ(subShader.passes.at(0).packageRequirements.at(0).range, "2021.2");
}

TEST(ShaderLabParser, KeepsSurfaceShadersAsPassesWithTheStateInFrontOfThem)
{
    const ShaderLabParseResult result = ParseShaderLab(R"(Shader "x" { SubShader {
        ZWrite On
        CGPROGRAM
        #pragma surface a Lambert
        ENDCG
        ZWrite Off
        CGPROGRAM
        #pragma surface b Lambert
        ENDCG
        Pass { } } })",
                                                       "t.shader");
    EXPECT_FALSE(result.hasErrors());
    EXPECT_THAT(test::Messages(result.diagnostics).at(0),
                Mentions("3:9: warning: CGPROGRAM", "outside a Pass", "surface shader"));
    const auto& passes = result.document.subShaders.at(0).passes;
    ASSERT_EQ(passes.size(), 3u);
    EXPECT_TRUE(passes[0].isSurface);
    EXPECT_TRUE(passes[0].state.zWrite.value);
    EXPECT_TRUE(passes[0].program.has_value());
    EXPECT_EQ(passes[0].lightMode(), "ForwardBase");
    EXPECT_FALSE(passes[1].state.zWrite.value);
    EXPECT_FALSE(passes[2].isSurface);
    EXPECT_FALSE(passes[2].state.zWrite.value);
}

TEST(ShaderLabParser, HandsStateTagsAndLodFromCategoryToCategory)
{
    const ShaderLabDocument document = ParseGood(R"(Shader "x" {
        Category { Tags { "Queue" = "Overlay" "A" = "1" } LOD 200 Cull Off ZWrite Off
            Category { Tags { "A" = "2" } ZWrite On SubShader { Pass { } } }
            SubShader { LOD 50 Pass { } } }
        SubShader { Pass { } } })");
    const auto& subShaders = document.subShaders;
    EXPECT_EQ(*subShaders.at(0).tags.Find("A"), "2");
    EXPECT_EQ(*subShaders.at(0).tags.Find("Queue"), "Overlay");
    EXPECT_EQ(subShaders.at(0).lod, 200);
    EXPECT_EQ(subShaders.at(0).passes.at(0).state.cull.value, CullMode::Off);
    EXPECT_TRUE(subShaders.at(0).passes.at(0).state.zWrite.value);
    EXPECT_EQ(*subShaders.at(1).tags.Find("A"), "1");
    EXPECT_EQ(subShaders.at(1).lod, 50);
    EXPECT_FALSE(subShaders.at(1).passes.at(0).state.zWrite.value);
    EXPECT_EQ(subShaders.at(2).lod, 0);
    EXPECT_EQ(subShaders.at(2).passes.at(0).state, RenderState{});
}

TEST(ShaderLabParser, TakesZeroBytesAndSpacesOfOtherAlphabetsForBlanks)
{
    const std::string text = std::string("Shader\0 \"x\"", 11) +
                             "\xC2\xA0{ SubShader\xE3\x80\x80{ \xEF\xBB\xBF Pass { Cull Off } } }";
    EXPECT_EQ(ParseGood(text).subShaders.at(0).passes.at(0).state.cull.value, CullMode::Off);
}

TEST(ShaderLabParser, KeepsTheBytesOfOtherEncodings)
{
    EXPECT_EQ(ParseGood("Shader \"\xC3\xE8\xB1\xDF\" { } // \xC3\xE8").name, "\xC3\xE8\xB1\xDF");
}

TEST(ShaderLabParser, ReportsTheDirectivesOfUnitysLexerAndGoesOn)
{
    const ShaderLabParseResult result = ParseShaderLab(
        "Shader \"x\" {\n#warning  look { out\nSubShader {\n#line 7\nPass {\n#error bad \"\nCull "
        "Off } } }",
        "t.shader");
    EXPECT_THAT(test::Messages(result.diagnostics),
                testing::ElementsAre("2:1: warning: #warning: look { out",
                                     Mentions("4:1: note: #line", "ignored"),
                                     "6:1: error: #error: bad \""));
    EXPECT_EQ(result.document.subShaders.at(0).passes.at(0).state.cull.value, CullMode::Off);
}

TEST(ShaderLabParser, AcceptsCommandsBehindTheProgramAndSharpsInNames)
{
    const ShaderLabDocument document =
        ParseGood("Shader \"x\" { Properties { #C_o_l#or3 (\"c\", Color) = (1,1,1,1) } SubShader { "
                  "Pass { HLSLPROGRAM\nENDHLSL Cull [#C#] } } }");
    EXPECT_EQ(document.properties.at(0).name, "#C_o_l#or3");
    EXPECT_EQ(document.subShaders.at(0).passes.at(0).state.cull.property, "#C#");
}

TEST(ShaderLabParser, AcceptsAShaderWithoutSubShadersAndIncludesBeforeProperties)
{
    const ShaderLabDocument document =
        ParseGood("Shader \"x\" { CGINCLUDE\n#pragma vertex v\nENDCG CustomEditor \"E\" Properties "
                  "{ _A(\"a\", Int)=1 } Fallback \"VertexLit\" }");
    EXPECT_EQ(document.properties.size(), 1u);
    EXPECT_EQ(document.customEditor, "E");
    EXPECT_TRUE(document.subShaders.empty());
}

TEST(ShaderLabParser, ReadsPragmasOfAnEmptyProgramFromTheIncludeBlock)
{
    const ShaderLabDocument document = ParseGood(
        "Shader \"x\" { SubShader { CGINCLUDE\n#pragma vertex v\n#pragma fragment f\nENDCG "
        "Pass { CGPROGRAM ENDCG } } }");
    const PassProgram& program = document.subShaders.at(0).passes.at(0).program.value();
    EXPECT_EQ(program.vertex.name, "v");
    EXPECT_EQ(program.fragment.name, "f");
}

TEST(ShaderLabParser, HandsIncludeBlocksToAllProgramsBehindThem)
{
    const ShaderLabDocument document = ParseGood(R"(Shader "x" {
        Category { HLSLINCLUDE A ENDHLSL SubShader { Pass { HLSLINCLUDE B ENDHLSL HLSLPROGRAM 1 ENDHLSL }
            Pass { HLSLPROGRAM 2 ENDHLSL } } }
        SubShader { Pass { HLSLPROGRAM 3 ENDHLSL } } })");
    const auto chunks = [&](std::size_t subShader, std::size_t pass)
    {
        return document.subShaders.at(subShader).passes.at(pass).program.value().chunks.size();
    };
    EXPECT_EQ(chunks(0, 0), 3u);
    EXPECT_EQ(chunks(0, 1), 3u);
    EXPECT_EQ(chunks(1, 0), 3u);
}

} // namespace
} // namespace limn
