#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/VariantCount.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A pass's program with these pragmas on line 2, and this text of the fragment function on line 4.
PassProgram ProgramOf(const std::string& pragmas, const std::string& body)
{
    return *test::ParsePass("HLSLPROGRAM\n" + pragmas +
                            "\nfloat4 V() : SV_POSITION { return 0; } float4 F() : SV_Target {\n" +
                            body + "\n}\n#pragma vertex V\n#pragma fragment F\nENDHLSL")
                .program;
}

TEST(DynamicKeywords, AreUniformIntsInABufferOfTheirOwn)
{
    const PassProgram program =
        ProgramOf("#pragma dynamic_branch_local_fragment _ WET MOSS",
                  "float4 c = WET ? 0.5 : 0.25; if (MOSS && !WET) { c.r = 1; } return c;");
    ShaderCompiler compiler;
    const auto pass = compiler.Compile(program);
    EXPECT_THAT(pass->diagnostics, IsEmpty());
    ASSERT_EQ(pass->layout.buffers.size(), 1u);
    const UniformBuffer& buffer = pass->layout.buffers[0];
    EXPECT_EQ(buffer.name, "limn_DynamicKeywords");
    EXPECT_TRUE(buffer.stages == ShaderStage::Fragment);
    EXPECT_EQ(buffer.size, 16u);
    EXPECT_THAT(buffer.members, ElementsAre(UniformMember{"MOSS", UniformType::Int, 1, 0, 4},
                                            UniformMember{"WET", UniformType::Int, 1, 4, 4}));
}

TEST(DynamicKeywords, MakeOneVariantWhicheverAreOn)
{
    const PassProgram program = ProgramOf("#pragma dynamic_branch WET\n#pragma multi_compile _ RED",
                                          "if (WET) { return 1; } return 0;");
    const std::vector<std::string> on = {"RED", "WET"};
    EXPECT_THAT(SelectVariant(program, on), ElementsAre("RED"));
    EXPECT_EQ(CountVariants(program).ToString(), "2");
    // Asked for by name they are uniforms as well.
    ShaderCompiler compiler;
    EXPECT_EQ(*compiler.Compile(program, on), *compiler.Compile(program));
}

TEST(DynamicKeywords, StayDynamicWhereAnotherSetHasThemToo)
{
    const PassProgram program =
        ProgramOf("#pragma multi_compile _ WET DRY\n#pragma dynamic_branch WET\n", "return WET;");
    const std::vector<std::string> on = {"WET"};
    EXPECT_THAT(SelectVariant(program, on), IsEmpty());
    EXPECT_EQ(CountVariants(program).ToString(), "2"); // DRY on and off
    ShaderCompiler compiler;
    EXPECT_EQ(compiler.Compile(program, on)->layout.buffers.at(0).name, "limn_DynamicKeywords");
}

TEST(DynamicKeywords, AreDeclaredForThePreprocessorAsInUnity)
{
    const auto compiles = [](const std::string& condition)
    {
        ShaderCompiler compiler;
        compiler.Compile(ProgramOf("#pragma dynamic_branch _ WET",
                                   condition + "\nreturn 0;\n#else\n#error no\n#endif"));
    };
    EXPECT_NO_THROW(compiles("#if defined(WET_KEYWORD_DECLARED)"));
    EXPECT_THROW(compiles("#if defined(MOSS_KEYWORD_DECLARED)"), AssetError);
}

TEST(DynamicKeywords, GiveAWarningWhereThePreprocessorIsAskedForThem)
{
    const auto warnings = [](const std::string& condition)
    {
        ShaderCompiler compiler;
        return test::Messages(compiler
                                  .Compile(ProgramOf("#pragma dynamic_branch _ WET MOSS",
                                                     condition + "\nreturn 1;\n#endif\nreturn 0;"))
                                  ->diagnostics);
    };
    EXPECT_THAT(
        warnings("  #ifdef WET"),
        ElementsAre(test::Mentions("4:3: warning: #ifdef: 'WET'", "dynamic_branch", "'if (WET)'")));
    EXPECT_THAT(warnings("#if 0\n#elif defined(WET) || MOSS"),
                ElementsAre(HasSubstr("5:1: warning: #elif: 'WET' is"),
                            HasSubstr("5:1: warning: #elif: 'MOSS' is")));
    EXPECT_THAT(warnings("#if defined(WETTER) // WET"), IsEmpty());
    EXPECT_THAT(warnings("#if 1\nif (WET) return 2;"), IsEmpty());
}

} // namespace
} // namespace limn
