#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/VariantCount.h>

#include "ShaderTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

PassProgram ProgramWith(const std::string& pragmas)
{
    return test::ParsePass("HLSLPROGRAM\n" + pragmas + "\nENDHLSL").program.value();
}

std::string CountOf(const std::string& pragmas)
{
    return CountVariants(ProgramWith(pragmas)).ToString();
}

TEST(VariantCount, MultipliesTheSizesOfTheKeywordSets)
{
    EXPECT_EQ(CountOf(""), "1");
    EXPECT_EQ(CountOf("#pragma multi_compile _ A B\n#pragma shader_feature C\n"
                      "#pragma multi_compile D E"),
              "12");
    EXPECT_EQ(CountOf("#pragma multi_compile_fog\n#pragma multi_compile_instancing"), "8");
    EXPECT_EQ(CountOf("#pragma multi_compile_fwdbase"), "256"); // DIRECTIONAL and 8 that may be on
}

TEST(VariantCount, CountsEqualSetsOnceAndDynamicBranchesNever)
{
    EXPECT_EQ(CountOf("#pragma multi_compile _ A\n#pragma multi_compile A _\n"
                      "#pragma dynamic_branch X Y"),
              "2");
}

TEST(VariantCount, LeavesOutSkippedVariants)
{
    EXPECT_EQ(CountOf("#pragma multi_compile _ A B\n#pragma multi_compile _ C\n"
                      "#pragma skip_variants A C"),
              "2");
    EXPECT_EQ(CountOf("#pragma multi_compile A B\n#pragma skip_variants A B"), "0");
}

TEST(VariantCount, HasNoUpperBound)
{
    std::string pragmas;
    for (int i = 0; i < 100; ++i)
    {
        pragmas += "#pragma multi_compile _ K" + std::to_string(i) + "\n";
    }
    // 2^100
    EXPECT_EQ(CountOf(pragmas), "1267650600228229401496703205376");
    VariantCount sum(4294967295u);
    sum += VariantCount(1);
    EXPECT_EQ(sum.ToString(), "4294967296");
    sum *= 0;
    EXPECT_EQ(sum, VariantCount());
    EXPECT_EQ(sum.ToString(), "0");
    VariantCount padded(1'000'000'000);
    padded += VariantCount(7);
    EXPECT_EQ(padded.ToString(), "1000000007");
}

TEST(InitialKeywords, FollowFromTheDefaultsOfToggles)
{
    const ShaderLabDocument document = test::ParseGood(R"(Shader "x" { Properties {
        [Toggle] _Fancy("a", Float) = 1
        [Toggle(_LOUD)] _B("b", Float) = 1
        [Toggle(_QUIET)] _C("c", Float) = 0
        [MaterialToggle] PixelSnap("d", Float) = 1
        [ToggleOff(_HIGHLIGHTS_OFF)] _E("e", Float) = 0
        [ToggleOff] _F("f", Float) = 1
        [ToggleUI] _G("g", Float) = 1
        [HideInInspector] [Toggle ( _SPACED )] _H("h", Int) = 2
        } SubShader { Pass { } } })");
    EXPECT_THAT(InitialKeywords(document),
                ElementsAre("PIXELSNAP_ON", "_FANCY_ON", "_HIGHLIGHTS_OFF", "_LOUD", "_SPACED"));
}

TEST(InitialKeywords, FollowFromTheDefaultsOfKeywordEnums)
{
    const ShaderLabDocument document = test::ParseGood(R"(Shader "x" { Properties {
        [KeywordEnum(None, Add, Six Frames)] _Mode("a", Float) = 2
        [KeywordEnum(One, Two)] _Kind("b", Float) = 0
        [KeywordEnum(One, Two)] _Wild("c", Float) = 7
        } SubShader { Pass { } } })");
    EXPECT_THAT(InitialKeywords(document), ElementsAre("_KIND_ONE", "_MODE_SIX_FRAMES"));
}

TEST(SelectVariant, TakesTheEnabledKeywordOfEachSetElseItsDefault)
{
    const PassProgram program =
        ProgramWith("#pragma multi_compile A B C\n#pragma shader_feature _D\n"
                    "#pragma multi_compile _ E F\n#pragma multi_compile _ E");
    EXPECT_THAT(SelectVariant(program, {}), ElementsAre("A"));
    const std::vector<std::string> enabled = {"C", "_D", "E", "UNKNOWN"};
    EXPECT_THAT(SelectVariant(program, enabled), ElementsAre("C", "E", "_D"));
    EXPECT_THAT(SelectVariant(ProgramWith(""), enabled), IsEmpty());
}

TEST(SelectVariant, HeedsGlobalKeywordsInSetsThatAreNotLocal)
{
    const PassProgram program = ProgramWith("#pragma multi_compile A B C\n"
                                            "#pragma multi_compile_local _ D\n"
                                            "#pragma shader_feature_local_fragment _ E\n"
                                            "#pragma multi_compile_fragment _ F");
    const std::vector<std::string> material = {"C", "E"};
    const std::vector<std::string> global = {"B", "D", "F"};
    EXPECT_THAT(SelectVariant(program, {}, global), ElementsAre("B", "F"));
    EXPECT_THAT(SelectVariant(program, material, global), ElementsAre("B", "E", "F"));
}

} // namespace
} // namespace limn
