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

/// Messages for the only pass of a ShaderLab text.
std::vector<std::string> ShaderMessages(const std::string& text)
{
    return CompileMessages(test::ParseGood(text).subShaders.at(0).passes.at(0).program.value());
}

TEST(ShaderCompilerError, IsReportedAtTheLineOfTheShaderFile)
{
    EXPECT_THAT(ShaderMessages("Shader \"T\" { SubShader { Pass {\n"              // 1
                               "HLSLPROGRAM\n"                                    // 2
                               "#pragma vertex vert\n"                            // 3
                               "#pragma fragment frag\n"                          // 4
                               "float4 vert(float4 p : POSITION) : SV_Position\n" // 5
                               "{\n"                                              // 6
                               "    return p * _OutlneWidth;\n"                   // 7
                               "}\n"                                              // 8
                               "float4 frag() : SV_Target { return 1; }\n"        // 9
                               "ENDHLSL } } }"),
                ElementsAre("t.shader:7:16: error: '_OutlneWidth': unknown variable"));
}

TEST(ShaderCompilerError, IsReportedInsideAnIncludeBlockAndForBothStages)
{
    EXPECT_THAT(ShaderMessages("Shader \"T\" {\n"                                        // 1
                               "HLSLINCLUDE\n"                                           // 2
                               "float helper() { return missing; }\n"                    // 3
                               "ENDHLSL\n"                                               // 4
                               "SubShader { Pass { HLSLPROGRAM\n"                        // 5
                               "#pragma vertex vert\n"                                   // 6
                               "#pragma fragment frag\n"                                 // 7
                               "float4 vert(float4 p : POSITION) : SV_Position\n"        // 8
                               "{ return helper(); }\n"                                  // 9
                               "float4 frag() : SV_Target { helper(); return other; }\n" // 10
                               "ENDHLSL } } }"),
                ElementsAre("t.shader:3:25: error: 'missing': unknown variable",
                            "t.shader:10:46: error: 'other': unknown variable"));
}

TEST(ShaderCompilerError, IsReportedInTheIncludedFile)
{
    test::TemporaryFolder folder;
    folder.Write("inc/a.hlsl", "\nfloat4 helper() { return nothing; }\n");
    PassProgram program = Program("#include \"inc/a.hlsl\"\n"
                                  "float4 vert(float4 p : POSITION) : SV_Position\n"
                                  "{ return p + wrong; }\n"
                                  "float4 frag() : SV_Target { return helper(); }\n");
    const std::string folderName = folder.path().generic_string();
    program.file = folderName + "/t.shader";
    EXPECT_THAT(CompileMessages(program),
                ElementsAre(folderName + "/t.shader:3:14: error: 'wrong': unknown variable",
                            folderName + "/inc/a.hlsl:2:26: error: 'nothing': unknown variable"));
}

TEST(ShaderCompilerError, KeepsItsLineBehindMacrosAndContinuedLines)
{
    EXPECT_THAT(CompileMessages(Program("#define TWICE(x) \\\n ((x) + (x))\n"
                                        "/* two\nlines */ #define A 1\n"
                                        "float4 vert(float4 p : POSITION) : SV_Position\n"
                                        "{ return TWICE(\n p) + wrong; }\n"
                                        "float4 frag() : SV_Target { return 1; }\n")),
                ElementsAre("t.shader:7:7: error: 'wrong': unknown variable"));
}

TEST(ShaderCompilerError, KeepsItsLineBehindCommentsWithDirectives)
{
    EXPECT_THAT(CompileMessages(Program("/*\n#pragma A\n#pragma B */\n"
                                        "#define ONE /* of\ntwo */ 1 // and \\\n more\n"
                                        "float4 vert(float4 p : POSITION) : SV_Position\n"
                                        "{ return p * ONE + wrong; } /* another */\n"
                                        "float4 frag() : SV_Target { return 1; }\n")),
                ElementsAre("t.shader:8:20: error: 'wrong': unknown variable"));
}

TEST(ShaderCompilerError, IsInFilesOfAnyName)
{
    for (const auto& [name, shown] : {std::pair("a\"b", "a\"b"), std::pair("a\nb", "a\\nb"),
                                      std::pair("a\\b", "a\\b"), std::pair("#line 3", "#line 3")})
    {
        PassProgram program = Program("float4 vert(float4 p : POSITION) : SV_Position\n"
                                      "{ return wrong; }\n"
                                      "float4 frag() : SV_Target { return 1; }\n");
        program.file = name;
        EXPECT_THAT(CompileMessages(program),
                    ElementsAre(std::string(shown) + ":2:10: error: 'wrong': unknown variable"));
    }
}

TEST(ShaderCompilerError, IsWhatGlslangCrashesOn)
{
    const auto messages = [](const std::string& statement)
    {
        return CompileMessages(Program("float4 Twice(float4 other) { return other * 2; }\n"
                                       "float4 vert(float4 p : POSITION) : SV_Position\n"
                                       "{\n" +
                                       statement +
                                       "\nreturn p; }\n"
                                       "float4 frag() : SV_Target { return 1; }\n"));
    };
    for (const auto& [statement, column] :
         {std::pair("return (other)++;", 9), std::pair("return other--;", 8),
          std::pair("return 1 ? other : p;", 12)})
    {
        EXPECT_THAT(messages(statement), ElementsAre("t.shader:4:" + std::to_string(column) +
                                                     ": error: 'other': unknown variable"))
            << statement;
    }
    EXPECT_THAT(messages("return Twice(p)++;"),
                ElementsAre(Mentions("t.shader:4:8: error: 'Twice'", "no variable", "'++'",
                                     "into a variable")));
}

TEST(ShaderCompilerError, NamesEveryIncludeThatIsMissing)
{
    EXPECT_THAT(
        CompileMessages(Program("#include \"no.hlsl\"\n\n#include <Packages/x/y.hlsl>\n")),
        ElementsAre(Mentions("t.shader:1: error: #include", "no file \"no.hlsl\"", "ShaderLibrary"),
                    Mentions("t.shader:3: error: #include", "no file \"Packages/x/y.hlsl\"",
                             "ShaderLibrary")));
}

TEST(ShaderCompilerError, SpellsTypesAsHlslDoes)
{
    EXPECT_THAT(
        CompileMessages(Program("float4 vert(float3 p : POSITION) : SV_Position\n"
                                "{\n float3 a = float2(1, 2);\n float4x4 m = p;\n"
                                " return 1; }\nfloat4 frag() : SV_Target { return 1; }")),
        ElementsAre(Mentions("t.shader:3:11: error: '='", "convert", "'float2'", "'float3'"),
                    Mentions("t.shader:4:13: error: '='", "convert", "'float3'", "'float4x4'")));
}

TEST(ShaderCompilerError, ReportsAMissingSemicolonOnce)
{
    EXPECT_THAT(CompileMessages(Program("float4 vert(float4 p : POSITION) : SV_Position\n"
                                        "{\n float a = 1\n return a; }\n"
                                        "float4 frag() : SV_Target { return 1; }")),
                ElementsAre("t.shader:4:2: error: 'return': a ';' is missing before it"));
}

TEST(ShaderCompilerError, AsksForTheFunctionThatAPragmaNames)
{
    PassProgram program = Program("float4 Vert(float4 p : POSITION) : SV_Position { return p; }\n");
    program.vertex = {"Vretx", {4, 2}};
    EXPECT_THAT(CompileMessages(program),
                ElementsAre(testing::AllOf(
                    Mentions("t.shader:4:2: error: #pragma vertex", "no function 'Vretx'"),
                    testing::Not(testing::HasSubstr("'Vert'")))));
    program.vertex = {"Vetr", {4, 2}};
    EXPECT_THAT(CompileMessages(program),
                ElementsAre(Mentions("t.shader:4:2: error: #pragma vertex", "no function 'Vetr'",
                                     "'Vert'")));
}

TEST(ShaderCompilerError, AsksForTheFunctionWhateverThePragmaNames)
{
    PassProgram program = Program("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                                  "float4 frag() : SV_Target { return 1; }\n");
    for (const std::string name : {"1(", "a'b", "v#x", "\"x\\", "(a,a)", "v/*"})
    {
        program.vertex = {name, {4, 2}};
        EXPECT_THAT(CompileMessages(program),
                    ElementsAre(Mentions("t.shader:4:2: error: #pragma vertex",
                                         "there is no function '" + name + "'")));
    }
}

TEST(ShaderCompilerError, AsksForMissingPragmas)
{
    PassProgram program = Program("");
    program.vertex = {};
    program.fragment = {};
    EXPECT_THAT(
        CompileMessages(program),
        ElementsAre(Mentions("t.shader:1:1: error: program", "'#pragma vertex' is missing"),
                    Mentions("t.shader:1:1: error: program", "'#pragma fragment' is missing")));
}

TEST(ShaderCompilerError, ReportsSemanticsThatAreMissingDoubledOrOutOfPlace)
{
    const std::string frag = "\nfloat4 frag() : SV_Target { return 1; }";
    EXPECT_THAT(
        CompileMessages(Program("float4 vert(float4 p) : SV_Position { return p; }" + frag)),
        ElementsAre(Mentions("t.shader:1: error: vert: 'p'", "no semantic", "': TEXCOORD0'")));
    EXPECT_THAT(
        CompileMessages(Program("\nfloat4 vert(float4 p : SV_Depth) : SV_Position { return "
                                "p; }" +
                                frag)),
        ElementsAre(Mentions("t.shader:2:20: error: vert: 'p'", "'SV_Depth'", "not possible")));
    EXPECT_THAT(CompileMessages(Program("float4 vert(float4 a : POSITION, float4 b : POSITION) : "
                                        "SV_Position { return a; }" +
                                        frag)),
                ElementsAre(Mentions("t.shader:1: error: vert", "'POSITION'", "two values")));
    const std::string vert = "\nfloat4 vert(float4 p : POSITION) : SV_Position { return p; }\n";
    EXPECT_THAT(CompileMessages(Program(
                    vert + "float4 frag(out float4 a : SV_Target) : SV_Target { return a = 1; }")),
                ElementsAre(Mentions("t.shader:3:8: error: frag", "'SV_TARGET'", "two values")));
}

TEST(ShaderCompilerError, TellsATypeThatNobodyDeclaresFromOneThatNoStageMayHave)
{
    const std::string frag = "\nfloat4 frag() : SV_Target { return 1; }";
    EXPECT_THAT(
        CompileMessages(Program("float4 vert(Attributes i) : SV_Position { return 1; }" + frag)),
        ElementsAre(Mentions("t.shader:1: error: vert: 'i'", "unknown type 'Attributes'")));
    EXPECT_THAT(
        CompileMessages(
            Program("float4 vert(Texture2D t : TEXCOORD0) : SV_Position { return 1; }" + frag)),
        ElementsAre(Mentions("t.shader:1: error: vert: 't'", "'Texture2D'", "border of a stage")));
}

TEST(ShaderCompilerError, IsReportedForStructsWithoutAnEnd)
{
    const std::string frag = "float4 frag() : SV_Target { return 1; }";
    EXPECT_THAT(
        CompileMessages(Program("\nstruct A { float4 p : SV_Position; A a; };\n"
                                "A vert() { A a; return a; }\n" +
                                frag)),
        ElementsAre(Mentions("t.shader:2:38: error: vert: 'a'", "'A'", "contains itself", "16")));
    std::string structs = "\nstruct S0 { float x : A; };\n";
    for (int i = 1; i < 15; ++i)
    {
        const std::string inner = "S" + std::to_string(i - 1);
        structs += "struct S" + std::to_string(i) + " { " + inner + " a; " + inner + " b; };\n";
    }
    EXPECT_THAT(
        CompileMessages(Program(structs + "S14 vert() { S14 s; return s; }\n" + frag)).at(0),
        Mentions("'S", "more than 256 values"));
}

TEST(ShaderCompilerError, RefusesSurfaceShaders)
{
    PassProgram program = Program("");
    program.pragmas = {{{2, 1}, "surface", "surf Lambert"}};
    EXPECT_THAT(CompileMessages(program),
                ElementsAre(Mentions("t.shader:2:1: error: #pragma surface", "not supported",
                                     "fragment function")));
}

TEST(ShaderCompilerError, ReportsDeclarationsThatDoNotEnd)
{
    // The compiler reads over them and what follows.
    EXPECT_THAT(
        CompileMessages(Program("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                                "float4 frag() : SV_Target\n{\n"
                                "    float a = 1\n    float b = 2;\n"
                                "    float2 c = a * b d = 3; return a;\n}")),
        ElementsAre("t.shader:5:5: error: 'float': a ';' is missing before it",
                    "t.shader:6:22: error: 'd': a ';' is missing before it"));
}

TEST(ShaderCompilerError, ReportsEveryNameThatNobodyDeclares)
{
    const std::vector<std::string> messages = CompileMessages(
        Program("struct v2f { float4 pos : SV_Position; float2 uv : TEXCOORD0; };\n"
                "v2f vert(float4 p : POSITION) { v2f o; o.pos = p; o.uv = Nowhere(p); return o; }\n"
                "float4 frag(v2f i) : SV_Target\n{\n"
                "    for (;;) { if (i.uv.x > 1) break; else continue; }\n"
                "    if (i.uv.y > 1) discard;\n"
                "    float2 uv = i.uw * _Scale;\n"
                "    return Neither(uv) + lerp(uv.x, missing, 1);\n}"));
    EXPECT_THAT(messages, testing::UnorderedElementsAre(
                              Mentions("t.shader:2:58: error: 'Nowhere'", "no matching"),
                              Mentions("t.shader:7:19: error: 'uw'", "no such field"),
                              "t.shader:7:24: error: '_Scale': unknown variable",
                              Mentions("t.shader:8:12: error: 'Neither'", "no matching"),
                              "t.shader:8:37: error: 'missing': unknown variable"));
}

TEST(ShaderCompilerError, RefusesWhatWouldBeInvalidSpirv)
{
    // Vulkan takes an offset of a sampled texel only where it is a constant.
    EXPECT_THAT(CompileMessages(Program(
                    "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                    "Texture2D _Map; SamplerState sampler_Map; int2 _Offset;\n"
                    "float4 frag() : SV_Target { return _Map.SampleLevel(sampler_Map, 0, 0, "
                    "_Offset); }")),
                ElementsAre(Mentions("t.shader:3:72: error: program", "invalid SPIR-V", "Offset")));
}

TEST(ShaderCompilerError, RefusesWhatIsInvalidOnlyBeforeItIsOptimised)
{
    // The optimiser drops what is not used, and with it what is wrong.
    EXPECT_THAT(
        CompileMessages(Program("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                                "float2x2 Rests(float4 v, float2x2 m) { return frac(v * m); }\n"
                                "float4 frag() : SV_Target { Rests(1, 2); return 1; }")),
        ElementsAre(Mentions("t.shader:2:52: error: program", "invalid SPIR-V")));
}

TEST(ShaderCompilerError, NamesEachThingThatIsMissingOnALine)
{
    EXPECT_THAT(
        CompileMessages(Program("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                                "float4 frag() : SV_Target { return mul(_M, _V) + _N; }\n")),
        ElementsAre("t.shader:2:40: error: '_M': unknown variable",
                    "t.shader:2:44: error: '_V': unknown variable",
                    "t.shader:2:50: error: '_N': unknown variable"));
}

TEST(ShaderCompilerError, NamesTheFunctionsOfARecursion)
{
    const std::string vert = "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n";
    EXPECT_THAT(CompileMessages(Program(vert + "float f(float x) { return f(x - 1); }\n"
                                               "float4 frag() : SV_Target { return f(1); }")),
                ElementsAre(Mentions("t.shader:2:7: error: 'f'", "itself", "recursion")));
    EXPECT_THAT(CompileMessages(Program(vert + "float g(float x);\n"
                                               "float f(float x) { return g(x - 1); }\n"
                                               "float g(float x) { return f(x - 1); }\n"
                                               "float4 frag() : SV_Target { return f(1); }")),
                ElementsAre(Mentions("t.shader:3:7: error: 'f'", "itself", "'g'", "recursion")));
}

TEST(ShaderCompilerError, TellsWhereAnEntryFunctionIsOnlyDeclared)
{
    EXPECT_THAT(CompileMessages(Program("float4 vert(float4 p : POSITION) : SV_Position;\n"
                                        "float4 frag() : SV_Target { return 1; }")),
                ElementsAre(Mentions("t.shader:1:1: error: #pragma vertex", "'vert'",
                                     "only declared", "t.shader:1", "body")));
}

TEST(ShaderCompilerError, TellsWhereAStaticTextureArrayIsIndexedByAVariable)
{
    const std::string code = "Texture2D _A; Texture2D _B; SamplerState sampler_A;\n"
                             "static Texture2D All[2] = {_A, _B};\n"
                             "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                             "float4 frag(float4 p : SV_Position) : SV_Target\n"
                             "{ int i = p.x; return All[i].Load(int3(0, 0, 0)) +\n"
                             "  All[2].Load(int3(0, 0, 0)) +\n"
                             "  All[1.0].Load(int3(0, 0, 0)); }";
    EXPECT_THAT(CompileMessages(Program(code)),
                ElementsAre(Mentions("t.shader:5:", "'All[i]'", "constant", "less than 2", "'if'"),
                            Mentions("t.shader:6:", "'All[2]'", "constant", "less than 2"),
                            Mentions("t.shader:7:", "'All[1.0]'", "whole number")));
}

TEST(ShaderCompilerError, NamesTheMissingFileThatPragmasWereToComeFrom)
{
    EXPECT_THAT(ShaderMessages("Shader \"T\" { SubShader { Pass {\n"
                               "HLSLPROGRAM\n"
                               "#include_with_pragmas \"entries.hlsl\"\n"
                               "ENDHLSL } } }"),
                ElementsAre(Mentions("t.shader:3:1: error: #include_with_pragmas",
                                     "no file \"entries.hlsl\"", "ShaderLibrary")));
}

std::string Repeat(const std::string& text, int count)
{
    std::string result;
    for (int i = 0; i < count; ++i)
    {
        result += text;
    }
    return result;
}

/// Each line with its number in the place of N and the number before in the place of M.
std::string Chain(const std::string& first, const std::string& line, int count)
{
    std::string result = first + "\n";
    for (int i = 1; i < count; ++i)
    {
        for (const char c : line)
        {
            result += c == 'N'   ? std::to_string(i)
                      : c == 'M' ? std::to_string(i - 1)
                                 : std::string(1, c);
        }
        result += "\n";
    }
    return result;
}

const std::string k_PlainVert = "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n";

/// Statements in a function, on line 3 if there are no declarations before it.
std::string InFragment(const std::string& code, const std::string& declarations = "")
{
    return k_PlainVert + declarations +
           "float4 frag() : SV_Target { float4 v = 1; float x = 1; int n = 1;\n" + code +
           "\nreturn v + x + n; }";
}

TEST(ShaderCompilerError, IsReportedWhereTheNestingIsTooDeep)
{
    constexpr int k_Many = 20'000;
    const std::pair<const char*, std::string> expressions[] = {
        {"brackets", "x = " + Repeat("(", k_Many) + "1" + Repeat(")", k_Many) + ";"},
        {"calls in calls", "x = " + Repeat("abs(", k_Many) + "x" + Repeat(")", k_Many) + ";"},
        {"indices in indices", "x = " + Repeat("v[", k_Many) + "0" + Repeat("]", k_Many) + ";"},
        {"initial values", "float y = " + Repeat("{", k_Many) + "1" + Repeat("}", k_Many) + ";"},
        {"swizzles", "v = v" + Repeat(".xyzw", k_Many) + ";"},
        {"members", "x = v" + Repeat(".a", k_Many) + ";"},
        {"indices", "x = v" + Repeat("[0]", k_Many) + ";"},
        {"calls", "x = f" + Repeat("()", k_Many) + ";"},
        {"casts", "x = " + Repeat("(float)(int)", k_Many) + "x;"},
        {"signs", "x = " + Repeat("- ", k_Many) + "x;"},
        {"negations", "x = " + Repeat("!", k_Many) + "x;"},
        {"increments", "x" + Repeat("++", k_Many) + ";"},
        {"sums", "x = 1" + Repeat(" + 1", k_Many) + ";"},
        {"shifts", "n = n" + Repeat(" << 1", k_Many) + ";"},
        {"conditions", "n = x > 1" + Repeat(" && x > 1", k_Many) + ";"},
        {"assignments", "x = " + Repeat("x = ", k_Many) + "1;"},
        {"commas in brackets", "x = (x" + Repeat(", x", k_Many) + ");"},
        {"commas", "x = 1" + Repeat(", x = 2", k_Many) + ";"},
        {"choices", "x = " + Repeat("x > 1 ? 2 : ", k_Many) + "3;"},
        {"choices in choices", "x = " + Repeat("x > 1 ? ", k_Many) + "3" + Repeat(" : 2", k_Many)},
        {"if", Repeat("if (x > 1) ", k_Many) + "x = 2;"},
        {"if with blocks", Repeat("if (x > 1) { ", k_Many) + Repeat("}", k_Many)},
        {"else if", "if (x > 1) x = 2;" + Repeat(" else if (x > 1) x = 3;", k_Many)},
        {"for", Repeat("for (; x > 1;) ", k_Many) + "x = 2;"},
        {"do", Repeat("do ", k_Many) + "x = 2;" + Repeat(" while (x > 1);", k_Many)},
        {"blocks", Repeat("{", k_Many) + Repeat("}", k_Many)},
    };
    for (const auto& [name, code] : expressions)
    {
        EXPECT_THAT(
            CompileMessages(Program(InFragment(code))),
            ElementsAre(Mentions("t.shader:3: error: HLSL", "more than 500 brackets", "apart")))
            << name;
    }
    const std::pair<const char*, std::string> structs[] = {
        {"members", Chain("struct S0 { float a; };", "struct SN { SM s; };", k_Many)},
        {"arrays", Chain("struct S0 { float a; };", "struct SN { float b; SM s[1]; };", k_Many)},
        {"bases", Chain("struct S0 { float a; };", "struct SN : SM { float bN; };", k_Many)},
        {"aliases", Chain("struct S0 { float a; }; typedef S0 T0;",
                          "struct SN { TM s; }; typedef SN TN;", k_Many)},
        {"types without a name",
         Chain("typedef struct { float a; } S0;", "typedef struct { SM s; } SN;", k_Many)},
    };
    for (const auto& [name, declarations] : structs)
    {
        EXPECT_THAT(CompileMessages(Program(InFragment("", declarations))),
                    ElementsAre(Mentions("t.shader:102:", ": error: HLSL", "more than 100 structs",
                                         "apart")))
            << name;
    }
}

TEST(ShaderCompilerError, IsReportedWhereThePreprocessorWouldGoTooDeep)
{
    constexpr int k_Many = 20'000;
    const auto nested = [](const std::string& open)
    {
        return Repeat(open, k_Many) + "1" + Repeat(")", k_Many);
    };
    for (const std::string& condition :
         {nested("("), Repeat("!", k_Many) + "1", Repeat("- ", k_Many) + "1", nested("defined(")})
    {
        EXPECT_THAT(CompileMessages(Program("\n#if " + condition + "\n#endif\n")),
                    ElementsAre(Mentions("t.shader:2: error: HLSL", "more than 500 brackets")));
    }
    EXPECT_THAT(CompileMessages(Program("#define F(x) x\n\n" + nested("F(") + ";")),
                ElementsAre(Mentions("t.shader:3: error: HLSL", "more than 500 brackets")));
    EXPECT_THAT(CompileMessages(Program(Repeat("#if 1\n", k_Many) + Repeat("#endif\n", k_Many))),
                ElementsAre(Mentions("t.shader:66: error: '#if'", "nesting depth")));
    test::TemporaryFolder folder;
    folder.Write("deep.hlsl", "\n#if " + nested("(") + "\n#endif\n");
    PassProgram program = Program("#include \"deep.hlsl\"\n");
    program.file = folder.path().generic_string() + "/t.shader";
    EXPECT_THAT(CompileMessages(program),
                ElementsAre(Mentions(program.file + ":1: error: #include", "\"deep.hlsl\"",
                                     "500 brackets", "line 2")));
}

TEST(ShaderCompiler, TakesWhatIsLongAndNotDeep)
{
    constexpr int k_Many = 5'000;
    const std::string list = "{ " + Repeat("1, ", k_Many - 1) + "1 }";
    const std::string size = "[" + std::to_string(k_Many) + "]";
    for (const auto& [code, declarations] : {
             std::pair<std::string, std::string>("x = " + Repeat("(", 200) + "x" +
                                                     Repeat(")", 200) + Repeat("+ x", 1000) +
                                                     ";\n" + Repeat("x = x + 1 - x * 2;", 1000),
                                                 ""),
             {"x = k_Table[n];", "static const float k_Table" + size + " = " + list + ";"},
             {"x = A4999;", Chain("#define A0 x", "#define AN AM", k_Many)},
             {"T4999 y = x; x = y;", Chain("typedef float T0;", "typedef TM TN;", k_Many)},
         })
    {
        EXPECT_NO_THROW(test::CompileHlsl(InFragment(code, declarations + "\n")))
            << code.substr(0, 40);
    }
    std::string sum = "x = v.x * v.y";
    for (int i = 0; i < 400; ++i)
    {
        sum += " + v.x * (v.yz.x - 1)";
    }
    EXPECT_NO_THROW(test::CompileHlsl(InFragment(sum + ";")));
}

TEST(ShaderCompilerError, PassesOnErrorDirectives)
{
    EXPECT_THAT(CompileMessages(Program("\n#error turn X on\n")),
                ElementsAre("t.shader:2: error: '#error': turn X on"));
}

} // namespace
} // namespace limn
