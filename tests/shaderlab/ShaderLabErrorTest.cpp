#include "ShaderTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> PassMessages(const std::string& commands)
{
    return test::ParseMessages("Shader \"T\" {\nSubShader {\nPass {\n" + commands + "\n}\n}\n}");
}

TEST(ShaderLabError, SuggestsTheCommandThatWasMeant)
{
    EXPECT_THAT(PassMessages("ZWrit Off"),
                ElementsAre(StartsWith("4:1: error: Pass: unknown command 'ZWrit'; did you mean "
                                       "'ZWrite'? (known: Name, Tags, ")));
}

TEST(ShaderLabError, SuggestsTheValueThatWasMeant)
{
    EXPECT_THAT(PassMessages("Cull Bakc"),
                ElementsAre("4:6: error: Cull: unknown value 'Bakc'; did you mean 'Back'? (known: "
                            "Back, Front, Off, False)"));
    EXPECT_THAT(PassMessages("Stencil { Comp Allways }"),
                ElementsAre(StartsWith("4:16: error: Comp: unknown value 'Allways'; did you mean "
                                       "'Always'? (known: Never, Less, ")));
}

TEST(ShaderLabError, ReportsEveryMistakeOfAFileInOrder)
{
    const std::vector<std::string> messages =
        PassMessages("Cul Off\nZTest Foo\nBlend One\nZWrite Off\nStencil { Ref 300 Pas Keep }");
    EXPECT_THAT(messages,
                ElementsAre(StartsWith("4:1: error: Pass: unknown command 'Cul'"),
                            StartsWith("5:7: error: ZTest: unknown value 'Foo'"),
                            "7:1: error: Blend: value is missing before 'ZWrite'; write a name or "
                            "[_Property]",
                            "8:15: error: Ref: 300 does not fit into 8 bits; write 0...255",
                            StartsWith("8:19: error: Stencil: unknown command 'Pas'")));
}

TEST(ShaderLabError, KeepsWhatIsRightBesideAMistake)
{
    const ShaderLabParseResult result =
        ParseShaderLab(test::WrapPass("Name \"N\" Culll Off ZWrite Off"), "t.shader");
    EXPECT_TRUE(result.hasErrors());
    const ShaderLabPass& pass = result.document.subShaders.at(0).passes.at(0);
    EXPECT_EQ(pass.name, "N");
    EXPECT_FALSE(pass.state.zWrite.value);
}

TEST(ShaderLabError, NamesTheBraceThatIsNeverClosed)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" {\n SubShader {\n  Pass {\n  }\n"),
                ElementsAre("5:1: error: SubShader: '{' of line 2 is never closed; add '}'"));
}

TEST(ShaderLabError, NoticesAMissingBraceAtTheNextOuterCommand)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" {\nSubShader {\nPass {\nCull Off\nPass { }\n}\n}"),
        ElementsAre("5:1: error: Pass: '}' is missing before 'Pass'; the '{' of line 3 is "
                    "still open"));
}

TEST(ShaderLabError, ReportsTextBehindTheShader)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" { } }"),
                ElementsAre("1:16: error: file: '}' behind the closing '}' of the shader; remove "
                            "it"));
}

TEST(ShaderLabError, ReportsAFileThatIsNoShader)
{
    EXPECT_THAT(test::ParseMessages("float4 x;"),
                ElementsAre("1:1: error: file: it must start with Shader \"name\", not with "
                            "'float4'"));
}

TEST(ShaderLabError, ReportsABadPropertyAndReadsTheNext)
{
    const ShaderLabParseResult result =
        ParseShaderLab("Shader \"T\" { Properties {\n_A (\"a\", Flaot) = 1\n_B (\"b\", float) = "
                       "pi / 180.0\n_C (\"c\", Color) = (1,1\n_D (\"d\", Int) = 4\n} }",
                       "t.shader");
    EXPECT_THAT(test::Messages(result.diagnostics),
                ElementsAre(StartsWith("2:10: error: _A: unknown property type 'Flaot'; did you "
                                       "mean 'Float'? (known: Float, Range, "),
                            "3:19: error: _B: a number is missing before 'pi'",
                            "5:1: error: _C: ')' is missing before '_D'"));
}

TEST(ShaderLabError, ReportsABlockThatNoKeywordCloses)
{
    EXPECT_THAT(PassMessages("HLSLPROGRAM\nfloat x;\nENDCG"),
                ElementsAre("4:1: error: HLSLPROGRAM: no ENDHLSL closes this block"));
}

TEST(ShaderLabError, ReportsATextWithoutItsClosingQuote)
{
    EXPECT_THAT(PassMessages("Name \"abc"),
                ElementsAre("4:6: error: string: '\"' is never closed; close it where the text "
                            "ends",
                            StartsWith("7:2: error: Pass: '{' of line 3 is never closed")));
}

TEST(ShaderLabError, ReportsTargetsAndOperationsThatDoNotExist)
{
    EXPECT_THAT(PassMessages("Blend 8 One One\nBlendOp LogicalXor\nColorMask RGX\nOffset 1"),
                ElementsAre("4:7: error: Blend: target 8 does not exist; a target is 0...7",
                            "5:9: error: BlendOp: 'LogicalXor' is not supported; use Add, Sub, "
                            "RevSub, Min or Max",
                            "6:11: error: ColorMask: 'RGX' is no mask; write letters of RGBA, 0 "
                            "or [_Property]",
                            "8:1: error: Offset: ',' is missing before '}'"));
}

TEST(ShaderLabError, ReportsAReferenceWithoutAName)
{
    EXPECT_THAT(PassMessages("Cull [ ]\nZTest [_A (junk)]"),
                ElementsAre("4:6: error: Cull: '[' needs the name of a property and ']', as in "
                            "[_Name]",
                            "5:7: warning: ZTest: what follows the name in '[_A (junk)]' is "
                            "ignored"));
}

TEST(ShaderLabError, SaysWhichCommandsAreNotSupportedYet)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" { SubShader {\nUsePass \"A/B\"\nGrabPass { }\n"
                                    "CGPROGRAM\n#pragma surface s Lambert\nENDCG\n} }"),
                ElementsAre("2:1: error: UsePass: not supported yet; copy the pass into this "
                            "shader",
                            "3:1: error: GrabPass: not supported yet; remove the block",
                            HasSubstr("4:1: error: CGPROGRAM: a program outside a Pass is a "
                                      "surface shader")));
}

TEST(ShaderLabError, SurvivesEveryTruncationOfAFile)
{
    const std::string text = R"(Shader "T" { Properties { [HDR] _A ("a", Range(0,1)) = .5
        _T ("t", 2D) = "white" {} } SubShader { Tags { "A"="B" } Pass { Blend 1 One [_Z], Zero One
        Stencil { Ref 1 } HLSLPROGRAM float x; ENDHLSL } } Fallback Off })";
    int withErrors = 0;
    for (std::size_t size = 0; size < text.size(); ++size)
    {
        withErrors += ParseShaderLab(text.substr(0, size), "t").hasErrors() ? 1 : 0;
    }
    EXPECT_EQ(withErrors, static_cast<int>(text.size()));
}

} // namespace
} // namespace limn
