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
                                       "'ZWrite'?")));
}

TEST(ShaderLabError, SuggestsTheValueThatWasMeant)
{
    EXPECT_THAT(PassMessages("Cull Bakc"),
                ElementsAre("4:6: error: Cull: unknown value 'Bakc'; did you mean 'Back'?"));
    EXPECT_THAT(PassMessages("Stencil { Comp Allways }"),
                ElementsAre(StartsWith("4:16: error: Comp: unknown value 'Allways'; did you mean "
                                       "'Always'?")));
}

TEST(ShaderLabError, GoesOnBehindAMaskThatIsNone)
{
    const std::string rest = " is no mask; write letters of RGBA, 0 or [_Property]";
    EXPECT_THAT(PassMessages("ColorMask"), ElementsAre("5:1: error: ColorMask: '}'" + rest));
    EXPECT_THAT(PassMessages("ColorMask Cull Bakc"),
                ElementsAre("4:11: error: ColorMask: 'Cull'" + rest,
                            "4:16: error: Cull: unknown value 'Bakc'; did you mean 'Back'?"));
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
                            "8:15: warning: Ref: 300 does not fit into 8 bits, so only its lowest "
                            "8 count; write 0...255",
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

TEST(ShaderLabError, ShowsWhatATerminalCannotAsItsNumber)
{
    EXPECT_THAT(PassMessages("Cull \"a~\x7F\""), ElementsAre(testing::HasSubstr("a~\\x7F")));
}

TEST(ShaderLabError, ReportsABadPropertyAndReadsTheNext)
{
    const ShaderLabParseResult result =
        ParseShaderLab("Shader \"T\" { Properties {\n_A (\"a\", Flaot) = 1\n_B (\"b\", float) = "
                       "pi / 180.0\n_C (\"c\", Color) = (1,1\n_D (\"d\", Int) = 4\n} }",
                       "t.shader");
    EXPECT_THAT(test::Messages(result.diagnostics),
                ElementsAre(StartsWith("2:10: error: _A: unknown property type 'Flaot'; did you "
                                       "mean 'Float'?"),
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
                ElementsAre("4:6: error: string: '\"' is never closed; close it where the text "
                            "ends",
                            StartsWith("7:2: error: Pass: '{' of line 3 is never closed")));
}

TEST(ShaderLabError, ReportsTargetsAndOperationsThatDoNotExist)
{
    EXPECT_THAT(
        PassMessages("Blend 8 One One\nBlendOp LogicalXorr\nColorMask RGX\nOffset 1"),
        ElementsAre("4:7: error: Blend: target 8 does not exist; a target is 0...7",
                    StartsWith("5:9: error: BlendOp: unknown value 'LogicalXorr'; did you mean "
                               "'LogicalXor'?"),
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

TEST(ShaderLabError, RefusesAUsePassWithoutAPassName)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" { SubShader {\nUsePass \"A\"\n } }"),
                ElementsAre("2:9: error: UsePass: the name of a pass is missing; write \"shader "
                            "name/PASS NAME\""));
}

TEST(ShaderLabError, SaysWhereACommandBelongs)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" {\nZWrite Off\nSubShader { Comp Less } }"),
                ElementsAre("2:1: error: Shader: 'ZWrite' does not belong here; it is a command of "
                            "a Pass",
                            "3:13: error: SubShader: 'Comp' does not belong here; it is a command "
                            "of a Stencil block"));
}

TEST(ShaderLabError, ReportsAProgramThatAnotherKeywordCloses)
{
    EXPECT_THAT(PassMessages("CGPROGRAM\nENDHLSL } Pass { CGPROGRAM\nENDCG"),
                ElementsAre("4:1: error: CGPROGRAM: ENDHLSL stands at its end; write ENDCG"));
}

TEST(ShaderLabError, WarnsOfAProgramThatEndsInAComment)
{
    EXPECT_THAT(
        PassMessages("CGPROGRAM\nx // ENDCG\n} Pass { CGPROGRAM\nENDCG"),
        ElementsAre("4:1: warning: CGPROGRAM: the ENDCG that closes it stands in a comment; "
                    "put it on a line of its own"));
}

TEST(ShaderLabError, WarnsOfAProgramInsideAnother)
{
    EXPECT_THAT(PassMessages("CGPROGRAM\nx // GLSLPROGRAM\nHlslProgram y\nENDCG"),
                ElementsAre("4:1: warning: CGPROGRAM: 'HlslProgram' stands inside it; is an ENDCG "
                            "missing before that?"));
}

TEST(ShaderLabError, WarnsOfACommentThatAnIncludeBlockLeavesOpen)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" {\nCGINCLUDE\na /* b */ // /*\nENDCG\n"
                                    "HLSLINCLUDE\n /* c\nENDHLSL\nSubShader { Pass { } } }"),
                ElementsAre("5:1: warning: HLSLINCLUDE: a comment in it is not closed; write */ "
                            "before ENDHLSL"));
}

TEST(ShaderLabError, ReportsAnUnclosedPropertiesBlockAtTheNextCommand)
{
    EXPECT_THAT(test::ParseMessages("Shader \"T\" { Properties {\n_A(\"a\", Int) = 1\nSubShader { "
                                    "} }"),
                ElementsAre("3:1: error: Properties: '}' is missing before 'SubShader'; the '{' of "
                            "line 1 is still open"));
}

TEST(ShaderLabError, WarnsOfPropertiesWithTheSameNameAndKeepsThem)
{
    const ShaderLabParseResult result = ParseShaderLab(
        "Shader \"T\" { Properties {\n_A(\"a\", Int) = 1\n_B(\"b\", Int) = 1\n_A(\"c\", "
        "Int) = 2\n_A(\"d\", Int) = 3 } }",
        "t.shader");
    EXPECT_THAT(test::Messages(result.diagnostics),
                ElementsAre("4:1: warning: _A: a property of this name stands in line 2 already; "
                            "materials have the first one"));
    EXPECT_EQ(result.document.properties.size(), 4u);
}

TEST(ShaderLabError, WarnsOfTagsThatAreNearlyRight)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" { SubShader { Tags { \"RenderPipeline\" = "
                            "\"UniversalPipline\" \"Quue\" = \"Geometry\" } Pass {\nTags { "
                            "\"LightMode\" = \"UniversalForwad\" } } Pass { Tags { \"LightMode\" = "
                            "\"Outline\" \"MyKey\" = \"x\" } } } }"),
        ElementsAre(
            "1:52: warning: Tags: \"UniversalPipline\" is no name that Unity knows; did you "
            "mean \"UniversalPipeline\"?",
            "1:71: warning: Tags: \"Quue\" is no name that Unity knows; did you mean "
            "\"Queue\"?",
            "2:22: warning: Tags: \"UniversalForwad\" is no name that Unity knows; did you "
            "mean \"UniversalForward\"?"));
}

TEST(ShaderLabError, ReportsATagOfWhichOneHalfIsInQuotes)
{
    EXPECT_THAT(
        PassMessages("Tags { LightMode = \"Meta\" }"),
        ElementsAre(
            "4:8: error: Tags: only one of key and value is in quotes; put both in quotes"));
    EXPECT_THAT(PassMessages("Tags { LightMode = Meta }"), ElementsAre());
}

TEST(ShaderLabError, WarnsOfNumbersThatUnityDoesNotWrite)
{
    EXPECT_THAT(PassMessages("Offset +1, 1e3f"),
                ElementsAre("4:8: warning: Offset: '+1' is no plain number; write digits, '.' and "
                            "'-' only, within the limits of a float",
                            "4:12: warning: Offset: '1e3f' is no plain number; write digits, '.' "
                            "and '-' only, within the limits of a float"));
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
    EXPECT_EQ(messages[100], " error: file: 150 more errors are not shown");
}

TEST(ShaderLabError, LimitsHowManyPropertiesAFileDeclares)
{
    constexpr std::size_t k_Most = std::size_t{1} << 20;
    const std::string head = "Shader \"T\" { Properties {\n";
    const std::string tail = "} SubShader { Pass { } } }";
    std::string properties;
    for (std::size_t i = 0; i <= k_Most; ++i)
    {
        properties += "_P" + std::to_string(i) + "(\"\",Int)=0\n";
    }
    const ShaderLabParseResult result = ParseShaderLab(head + properties + tail, "t.shader");
    ASSERT_TRUE(result.hasErrors());
    EXPECT_THAT(ToString(result.diagnostics.back()),
                testing::HasSubstr("file: it declares more than limn can hold (1048576 "));
    EXPECT_EQ(result.document.properties.size(), k_Most);
}

TEST(ShaderLabError, LimitsTheDepthOfCategories)
{
    std::string text = "Shader \"T\" {\n";
    for (int i = 0; i < 33; ++i)
    {
        text += "Category {";
    }
    EXPECT_THAT(test::ParseMessages(text + std::string(34, '}')),
                ElementsAre("2:321: error: Category: they are nested more than 32 deep; remove "
                            "some of the braces"));
}

TEST(ShaderLabError, ShowsBytesThatAreNoLettersAsNumbers)
{
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
                ElementsAre("1:39: error: comment: '/*' is never closed; close it with '*/'"));
}

} // namespace
} // namespace limn
