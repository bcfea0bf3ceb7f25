#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::CompileMessages;
using test::Mentions;
using test::Program;
using testing::ElementsAre;

/// What the compiler says of a program with the third line `line`.
std::vector<std::string> FragmentMessages(const std::string& line, const std::string& before = "")
{
    return CompileMessages(
        Program("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n" + before + "\n" +
                line + "\n"));
}

/// "t.shader:3:C: error: ", where C is the column of `word` in the line.
std::string At(const std::string& line, const std::string& word)
{
    return "t.shader:3:" + std::to_string(line.find(word) + 1) + ": error: ";
}

TEST(ErrorPlace, IsTheOneOfEqualWordsThatIsWrong)
{
    const std::string line =
        "float4 frag() : SV_Target { float2 a = 1; float3 b = 2; return a.xyxy + b.xyzw; }";
    EXPECT_THAT(FragmentMessages(line), ElementsAre(testing::StartsWith(At(line, "xyzw"))));
}

TEST(ErrorPlace, IsToldOfEachMistakeOfALine)
{
    const std::string line = "float4 frag() : SV_Target { float4x4 m = float3(1, 2, 3); float3 v = "
                             "float2(4, 5); return v.q; }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(testing::StartsWith(At(line, "= float3") + "'='"),
                            testing::StartsWith(At(line, "= float2") + "'='"),
                            testing::StartsWith(At(line, "q;"))));
}

TEST(ErrorPlace, LeavesOutWhatFollowsFromAnother)
{
    const std::string line =
        "float4 frag() : SV_Target { return float4x4(Nowhere(1).xyz, 1) * 2 + 1; }";
    EXPECT_THAT(FragmentMessages(line), ElementsAre(testing::StartsWith(At(line, "Nowhere"))));
}

TEST(ErrorPlace, OfWhatAMacroMakesIsTheMacros)
{
    const std::string line =
        "float4 frag() : SV_Target { float a = 1; /* DOUBLE */ a = a + DOUBLE(a); return a; }";
    EXPECT_THAT(FragmentMessages(line, "#define DOUBLE(x) (x + _Missing)"),
                ElementsAre(At(line, "DOUBLE(") + "'_Missing': unknown variable"));
}

TEST(ErrorPlace, IsThatOfAnArgumentOfAMacro)
{
    const std::string line =
        "float4 frag() : SV_Target { float a = 1; return DOUBLE(a) + DOUBLE(_Missing); }";
    EXPECT_THAT(FragmentMessages(line, "#define DOUBLE(x) ((x) * 2)"),
                ElementsAre(At(line, "_Missing") + "'_Missing': unknown variable"));
}

// The words that the macro makes are not the line's, though the same ones stand at its end.
TEST(ErrorPlace, IsThatOfAnArgumentOfAMacroWhoseOtherWordsFollow)
{
    const std::string line =
        "float4 frag() : SV_Target { float b = 1, c = 2; return TIMES_B(_Missing) + c + b; }";
    EXPECT_THAT(FragmentMessages(line, "#define TIMES_B(x) b * x"),
                ElementsAre(At(line, "_Missing") + "'_Missing': unknown variable"));
}

TEST(ErrorPlace, DoesNotCountComments)
{
    const std::string line =
        "float4 frag() : SV_Target { return _Missing; } // _Missing, and more of it";
    EXPECT_THAT(FragmentMessages(line, "/* _Missing"
                                       "   _Missing */"),
                ElementsAre(At(line, "_Missing") + "'_Missing': unknown variable"));
}

TEST(ErrorPlace, IsKeptBehindAPragmaThatBeginsTheProgram)
{
    const std::string line = "float4 frag() : SV_Target { float2 a = 1; return a.xyzw; }";
    EXPECT_THAT(CompileMessages(
                    Program("#pragma pack_matrix(row_major)\n\n" + line +
                            "\nfloat4 vert(float4 p : POSITION) : SV_Position { return p; }\n")),
                ElementsAre(testing::StartsWith(At(line, "xyzw"))));
}

TEST(ErrorPlace, OfAParameterIsItsName)
{
    const std::string line =
        "float4 frag(float4 p : SV_Position, float2 uv) : SV_Target { return 1; }";
    EXPECT_THAT(FragmentMessages(line), ElementsAre(testing::StartsWith(At(line, "uv") + "frag:")));
}

TEST(ErrorPlace, OfRecursionIsAFunctionInIt)
{
    const std::string line = "float F(float a) { return a > 0 ? F(a - 1) : 0; } float4 frag() : "
                             "SV_Target { return F(2); }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(Mentions(At(line, "F(float") + "'F'", "itself", "recursion")));
}

TEST(ErrorPlace, OfWhatTheGrammarDoesNotKnowIsTheWordThatIsTooMuch)
{
    const std::string line = "float4 frag() : SV_Target { float a = 1 2; return a; }";
    EXPECT_THAT(FragmentMessages(line), ElementsAre(testing::StartsWith(At(line, "2;"))));
}

TEST(ErrorPlace, OfABracketWithoutAnotherIsTheBracket)
{
    std::string line = "float4 frag() : SV_Target { float a = (1 + 2; return a; }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(Mentions(At(line, "(1") + "'('", "')' is missing", "'}' of line 3")));
    line = "float4 frag() : SV_Target { if (true) { return 1; }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(At(line, "{") + "'{': a '}' is missing for it"));
    line = "float4 frag() : SV_Target {";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(At(line, "{") + "'{': a '}' is missing for it"));
    line = "float4 frag() : SV_Target { return 1; }]";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(At(line, "]") + "']': this bracket closes nothing"));
}

TEST(ErrorPlace, OfAMemberWithoutItsSemicolonIsBehindIt)
{
    std::string line = "struct S { float a }; float4 frag() : SV_Target { return 1; }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(At(line, "};") + "'}': a ';' is missing before it"));
    line = "cbuffer S { float a; float b } float4 frag() : SV_Target { return 1; }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(At(line, "} float4") + "'}': a ';' is missing before it"));
}

TEST(ErrorPlace, OfAMisspeltTypeIsTheType)
{
    const std::string line =
        "float4 frag() : SV_Target { flaot a = 1; Structure s; return a + _Missing; }";
    EXPECT_THAT(FragmentMessages(line, "struct Structura { float a; };"),
                ElementsAre(Mentions(At(line, "flaot") + "'flaot'", "type", "'float'"),
                            Mentions(At(line, "Structure") + "'Structure'", "type", "'Structura'"),
                            At(line, "_Missing") + "'_Missing': unknown variable"));
}

TEST(ErrorPlace, OfAValueInAList)
{
    const std::string line =
        "float4 frag() : SV_Target { float2 a[] = { 1, 2, _Missing, 4 }; return a[0].xyxy; }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(At(line, "_Missing") + "'_Missing': unknown variable"));
}

TEST(ErrorPlace, NeverMeansTheTypeItself)
{
    const std::string line = "float4 frag() : SV_Target { fixed3 a = 1; return a.xyzz; }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(Mentions(At(line, "fixed3") + "'fixed3'", "type", "'half3'")));
}

TEST(ErrorPlace, TakesTypesOfAFunctionForTypes)
{
    EXPECT_THAT(FragmentMessages("float4 frag() : SV_Target { struct L { float a; }; typedef L K; "
                                 "K k; L l; l.a = 1; k.a = l.a; return k.a + _Missing; }"),
                ElementsAre(testing::HasSubstr("'_Missing': unknown variable")));
}

TEST(ErrorPlace, OfALabelIsTheLabelOrWhatIsNoConstantInIt)
{
    const std::string line =
        "float4 frag() : SV_Target { int k = 1; const int c = 2; default: switch (k) { case k: "
        "case c: case F() + 1: case _Uniform: case d: return 1; } return 1; }";
    EXPECT_THAT(
        FragmentMessages(line, "int _Uniform; static const int d = 4; int F() { return 1; }"),
        ElementsAre(Mentions(At(line, "default") + "'default'", "outside", "switch"),
                    Mentions(At(line, "k: ") + "'k'", "case", "constant"),
                    Mentions(At(line, "F()") + "'F'", "case", "constant"),
                    Mentions(At(line, "_Uniform") + "'_Uniform'", "case", "constant")));
}

TEST(ErrorPlace, OfAConstructorIsItsType)
{
    const std::string line = "float4 frag() : SV_Target { return float4(float2(1, 2), 3); }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(Mentions(At(line, "float4(") + "'float4'", "not enough data")));
}

TEST(ErrorPlace, NamesMethodsOfTexturesAsTheAuthorDoes)
{
    const std::string line = "Texture2D _T; float4 frag() : SV_Target { return _T.Sampel(1); }";
    EXPECT_THAT(FragmentMessages(line),
                ElementsAre(Mentions(At(line, "Sampel") + "'Sampel'", "no matching")));
}

} // namespace
} // namespace limn
