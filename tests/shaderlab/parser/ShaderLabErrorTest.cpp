#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::Mentions;
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
                ElementsAre(Mentions("4:1: error: Pass", "command 'ZWrit'", "'ZWrite'")));
}

TEST(ShaderLabError, SuggestsTheValueThatWasMeant)
{
    EXPECT_THAT(PassMessages("Cull Bakc"),
                ElementsAre(Mentions("4:6: error: Cull", "value 'Bakc'", "'Back'")));
    EXPECT_THAT(PassMessages("Stencil { Comp Allways }"),
                ElementsAre(Mentions("4:16: error: Comp", "value 'Allways'", "'Always'")));
}

TEST(ShaderLabError, GoesOnBehindAMaskThatIsNone)
{
    EXPECT_THAT(PassMessages("ColorMask"),
                ElementsAre(Mentions("5:1: error: ColorMask: '}'", "RGBA")));
    EXPECT_THAT(PassMessages("ColorMask Cull Bakc"),
                ElementsAre(Mentions("4:11: error: ColorMask: 'Cull'", "RGBA"),
                            Mentions("4:16: error: Cull", "value 'Bakc'", "'Back'")));
}

TEST(ShaderLabError, ReportsEveryMistakeOfAFileInOrder)
{
    const std::vector<std::string> messages =
        PassMessages("Cul Off\nZTest Foo\nBlend One\nZWrite Off\nStencil { Ref 300 Pas Keep }");
    EXPECT_THAT(messages,
                ElementsAre(StartsWith("4:1: error: Pass: unknown command 'Cul'"),
                            StartsWith("5:7: error: ZTest: unknown value 'Foo'"),
                            Mentions("7:1: error: Blend", "missing before 'ZWrite'", "[_Property]"),
                            Mentions("8:15: warning: Ref: 300", "8 bits", "0...255"),
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
                ElementsAre(Mentions("5:1: error: SubShader: '{' of line 2", "never closed")));
}

TEST(ShaderLabError, NoticesAMissingBraceAtTheNextOuterCommand)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" {\nSubShader {\nPass {\nCull Off\nPass { }\n}\n}"),
        ElementsAre(Mentions("5:1: error: Pass: '}'", "missing before 'Pass'", "line 3")));
}

TEST(ShaderLabError, ReportsTextBehindTheShader)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" { } }"),
                ElementsAre(Mentions("1:16: error: file: '}'", "behind", "remove")));
}

TEST(ShaderLabError, ReportsAFileThatIsNoShader)
{
    EXPECT_THAT(test::ParseMessages("float4 x;"),
                ElementsAre(Mentions("1:1: error: file", "Shader \"name\"", "'float4'")));
}

TEST(ShaderLabError, ShowsWhatATerminalCannotAsItsNumber)
{
    EXPECT_THAT(PassMessages("Cull \"a~\x7F\""), ElementsAre(testing::HasSubstr("a~\\u007F")));
}

TEST(ShaderLabError, ReportsABadPropertyAndReadsTheNext)
{
    const ShaderLabParseResult result =
        ParseShaderLab("Shader \"T\" { Properties {\n_A (\"a\", Flaot) = 1\n_B (\"b\", float) = "
                       "pi / 180.0\n_C (\"c\", Color) = (1,1\n_D (\"d\", Int) = 4\n} }",
                       "t.shader");
    EXPECT_THAT(test::Messages(result.diagnostics),
                ElementsAre(Mentions("2:10: error: _A", "type 'Flaot'", "'Float'"),
                            "3:19: error: _B: a number is missing before 'pi'",
                            "5:1: error: _C: ')' is missing before '_D'"));
}

TEST(ShaderLabError, ReportsABlockThatNoKeywordCloses)
{
    EXPECT_THAT(PassMessages("HLSLPROGRAM\nfloat x;\n"),
                ElementsAre("4:1: error: HLSLPROGRAM: no ENDHLSL closes this block"));
}

TEST(ShaderLabError, ReportsATextWithoutItsClosingQuote)
{
    EXPECT_THAT(PassMessages("Name \"abc"),
                ElementsAre(Mentions("4:6: error: string: '\"'", "never closed"),
                            StartsWith("7:2: error: Pass: '{' of line 3 is never closed")));
}

TEST(ShaderLabError, ReportsTargetsAndOperationsThatDoNotExist)
{
    EXPECT_THAT(PassMessages("Blend 8 One One\nBlendOp LogicalXorr\nColorMask RGX\nOffset 1"),
                ElementsAre(Mentions("4:7: error: Blend: target 8", "0...7"),
                            Mentions("5:9: error: BlendOp", "value 'LogicalXorr'", "'LogicalXor'"),
                            Mentions("6:11: error: ColorMask: 'RGX'", "RGBA"),
                            "8:1: error: Offset: ',' is missing before '}'"));
}

TEST(ShaderLabError, ReportsAReferenceWithoutAName)
{
    EXPECT_THAT(PassMessages("Cull [ ]\nZTest [_A (junk)]"),
                ElementsAre(Mentions("4:6: error: Cull: '['", "name of a property", "[_Name]"),
                            Mentions("5:7: warning: ZTest", "'[_A (junk)]'", "ignored")));
}

TEST(ShaderLabError, RefusesAUsePassWithoutAPassName)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" { SubShader {\nUsePass \"A\"\n } }"),
        ElementsAre(Mentions("2:9: error: UsePass", "missing", "\"shader name/PASS NAME\"")));
}

TEST(ShaderLabError, SaysWhereACommandBelongs)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" {\nZWrite Off\nSubShader { Comp Less } }"),
        ElementsAre(Mentions("2:1: error: Shader: 'ZWrite'", "not belong", "a Pass"),
                    Mentions("3:13: error: SubShader: 'Comp'", "not belong", "a Stencil block")));
}

TEST(ShaderLabError, ReportsAProgramThatAnotherKeywordCloses)
{
    EXPECT_THAT(PassMessages("CGPROGRAM\nENDHLSL } Pass { CGPROGRAM\nENDCG"),
                ElementsAre(Mentions("4:1: error: CGPROGRAM: ENDHLSL", "ENDCG")));
}

TEST(ShaderLabError, WarnsOfAProgramThatEndsInAComment)
{
    EXPECT_THAT(PassMessages("CGPROGRAM\nx // ENDCG\n} Pass { CGPROGRAM\nENDCG"),
                ElementsAre(Mentions("4:1: warning: CGPROGRAM", "ENDCG", "in a comment")));
}

TEST(ShaderLabError, WarnsOfAProgramInsideAnother)
{
    EXPECT_THAT(PassMessages("CGPROGRAM\nx // GLSLPROGRAM\nHlslProgram y\nENDCG"),
                ElementsAre(Mentions("4:1: warning: CGPROGRAM: 'HlslProgram'", "inside", "ENDCG")));
}

TEST(ShaderLabError, WarnsOfACommentThatAnIncludeBlockLeavesOpen)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" {\nCGINCLUDE\na /* b */ // /*\nENDCG\n"
                                    "HLSLINCLUDE\n /* c\nENDHLSL\nSubShader { Pass { } } }"),
                ElementsAre(Mentions("5:1: warning: HLSLINCLUDE", "comment", "not closed")));
}

TEST(ShaderLabError, ReportsAnUnclosedPropertiesBlockAtTheNextCommand)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" { Properties {\n_A(\"a\", Int) = 1\nSubShader { "
                                    "} }"),
                ElementsAre(Mentions("3:1: error: Properties: '}'", "missing before 'SubShader'",
                                     "line 1")));
}

TEST(ShaderLabError, WarnsOfPropertiesWithTheSameNameAndKeepsThem)
{
    const ShaderLabParseResult result = ParseShaderLab(
        "Shader \"T\" { Properties {\n_A(\"a\", Int) = 1\n_B(\"b\", Int) = 1\n_A(\"c\", "
        "Int) = 2\n_A(\"d\", Int) = 3 } }",
        "t.shader");
    EXPECT_THAT(test::Messages(result.diagnostics),
                ElementsAre(Mentions("4:1: warning: _A", "line 2", "first one")));
    EXPECT_EQ(result.document.properties.size(), 4u);
}

TEST(ShaderLabError, WarnsOfTagsThatAreNearlyRight)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" { SubShader { Tags { \"RenderPipeline\" = "
                            "\"UniversalPipline\" \"Quue\" = \"Geometry\" } Pass {\nTags { "
                            "\"LightMode\" = \"UniversalForwad\" } } Pass { Tags { \"LightMode\" = "
                            "\"Outline\" \"MyKey\" = \"x\" } } } }"),
        ElementsAre(Mentions("1:52: warning: Tags: \"UniversalPipline\"", "\"UniversalPipeline\""),
                    Mentions("1:71: warning: Tags: \"Quue\"", "\"Queue\""),
                    Mentions("2:22: warning: Tags: \"UniversalForwad\"", "\"UniversalForward\"")));
}

TEST(ShaderLabError, ReportsATagOfWhichOneHalfIsInQuotes)
{
    EXPECT_THAT(PassMessages("Tags { LightMode = \"Meta\" }"),
                ElementsAre(Mentions("4:8: error: Tags", "both in quotes")));
    EXPECT_THAT(PassMessages("Tags { LightMode = Meta }"), ElementsAre());
}

TEST(ShaderLabError, WarnsOfNumbersThatUnityDoesNotWrite)
{
    EXPECT_THAT(PassMessages("Offset +1, 1e3f"),
                ElementsAre(Mentions("4:8: warning: Offset: '+1'", "no plain number"),
                            Mentions("4:12: warning: Offset: '1e3f'", "no plain number")));
}

TEST(ShaderLabError, ShowsAHundredErrorsAndTellsHowManyMoreThereAre)
{
    std::string commands;
    for (int i = 0; i < 250; ++i)
    {
        commands += "Cull Bak\n";
    }
    const std::vector<std::string> messages = PassMessages(commands);
    ASSERT_EQ(messages.size(), 101u);
    EXPECT_THAT(messages[99], StartsWith("103:6: error: Cull: unknown value 'Bak'"));
    EXPECT_THAT(messages[100], Mentions(" error: file: 150 more"));
}

TEST(ShaderLabError, LimitsTheDepthOfCategories)
{
    std::string text = "Shader \"T\" {\n";
    for (int i = 0; i < 33; ++i)
    {
        text += "Category {";
    }
    EXPECT_THAT(test::ParseMessages(text + std::string(34, '}')),
                ElementsAre(Mentions("2:321: error: Category", "more than 32")));
}

TEST(ShaderLabError, ShowsBytesThatAreNoLettersAsNumbers)
{
    EXPECT_THAT(PassMessages("Cull \xE2\x80\x9COff\xE2\x80\x9D"),
                testing::Contains(testing::HasSubstr("'\xE2\x80\x9C'")));
    EXPECT_THAT(PassMessages("\xE6"),
                ElementsAre("4:1: error: Pass: unexpected '\\xE6'; a command is expected"));
}

/// Text that some part of the parser could take too long for; each ends in bounded diagnostics.
class HostileText : public testing::TestWithParam<const char*>
{
};

TEST_P(HostileText, GivesABoundedNumberOfDiagnosticsInBoundedTime)
{
    for (const std::string& start :
         {std::string(), std::string("Shader \"T\" {"), std::string("Shader \"T\" { Properties {"),
          std::string("Shader \"T\" { SubShader { Pass {"),
          std::string("Shader \"T\" { SubShader { Pass { SetTexture [_A] {")})
    {
        std::string text = start;
        while (text.size() < (1u << 16))
        {
            text += GetParam();
        }
        const ShaderLabParseResult result = ParseShaderLab(text, "t.shader");
        EXPECT_TRUE(result.hasErrors());
        EXPECT_LE(result.diagnostics.size(), 303u);
        for (const Diagnostic& diagnostic : result.diagnostics)
        {
            EXPECT_LT(diagnostic.message.size(), 1200u);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Texts, HostileText,
                         testing::Values("{", "}", "\"", "/*", "/* /* */", "//", "[", "[]", "[\n",
                                         "Shader", "Shader ", "_ ", "SubShader{", "Pass{}",
                                         "Category{", "Category{}", "#error\n", "#line 1\n",
                                         "CGPROGRAM /* ENDCG ", "CGPROGRAM // ENDCG ",
                                         "CGPROGRAM ENDHLSL \"/*\" ", "HLSLINCLUDE ENDHLSL ",
                                         "Tags { \"a\"=\"b\" ", "\xC3", "1", "1 ", "-", "Cull ",
                                         "_A(\"\",Int)=1 ", "_A(\"\",2D)=\"\"{ ", "Combine ",
                                         "UsePass \"a/b\" "));

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

TEST(ShaderLabError, KnowsNothingOfWhatFollowsTheTextThatItWasGiven)
{
    const std::string_view more = "Shader \"T\" { SubShader { Pass { } } } /* a */";
    const ShaderLabParseResult result = ParseShaderLab(more.substr(0, more.size() - 1), "t.shader");
    EXPECT_THAT(test::Messages(result.diagnostics),
                ElementsAre(Mentions("1:39: error: comment: '/*'", "never closed")));
}

} // namespace
} // namespace limn
