#include "spirv/Arithmetic.h"

#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using testing::Not;

/// The fragment function of a program that returns the value of an expression of the uniform
/// float4s a and b, and the uniform int4s i and j.
std::vector<std::uint32_t> Fragment(const std::string& expression,
                                    const std::string& functions = "")
{
    const auto program = CompileHlsl("float4 a, b; int4 i, j; uint4 u;\n" + functions +
                                     "float4 vert() : SV_POSITION { return a; }\n"
                                     "float4 frag() : SV_Target { return " +
                                     expression + "; }\n");
    return program->fragmentSpirv;
}

std::string FragmentText(const std::string& expression, const std::string& functions = "")
{
    const std::vector<std::uint32_t> spirv = Fragment(expression, functions);
    EXPECT_EQ("", ValidationMessages(spirv)) << expression;
    return Disassemble(spirv);
}

} // namespace

// Nothing is slower that was right.
TEST(Arithmetic, LeavesWhatUsesNoneOfIt)
{
    for (const char* expression :
         {"a * b + sin(a)", "a / b", "i + j * 3", "i / 3 + (i >> 2) + (u << 31)", "u / 7 + u % 2",
          "sqrt(a) + pow(a, b) + lerp(a, b, 0.5)", "floor(a) + ceil(b)"})
    {
        std::vector<std::uint32_t> spirv = Fragment(expression);
        const std::vector<std::uint32_t> before = spirv;
        UseDirect3DArithmetic(spirv);
        EXPECT_EQ(before, spirv) << expression;
        EXPECT_THAT(Disassemble(spirv), Not(HasSubstr("OpSelect"))) << expression;
        EXPECT_THAT(Disassemble(spirv), Not(HasSubstr("OpBitwiseAnd"))) << expression;
    }
}

TEST(Arithmetic, TakesWhatHlslMeans)
{
    EXPECT_THAT(FragmentText("fmod(a, b) + a % 2"), Not(HasSubstr("OpFMod")));
    const std::string rest = FragmentText("i % 3");
    EXPECT_THAT(rest, HasSubstr("OpSDiv"));
    EXPECT_THAT(rest, Not(HasSubstr("OpSRem"))) << "undefined of negative numbers";
    EXPECT_THAT(rest, Not(HasSubstr("OpSMod"))) << "undefined of negative numbers";
    EXPECT_THAT(rest, Not(HasSubstr("OpSelect")));
    EXPECT_THAT(FragmentText("round(a)"), HasSubstr(" RoundEven "));
    EXPECT_THAT(FragmentText("min(a, b)"), HasSubstr(" NMin "));
    EXPECT_THAT(FragmentText("max(a, b)"), HasSubstr(" NMax "));
    EXPECT_THAT(FragmentText("saturate(a)"), HasSubstr(" NClamp "));
    EXPECT_THAT(FragmentText("step(a, b)"), Not(HasSubstr(" Step ")));
    EXPECT_THAT(FragmentText("i << j"), HasSubstr("OpBitwiseAnd"));
}

// NVIDIA's driver (580.159) is wrong about the remainder of two constant vectors of ints.
TEST(Arithmetic, WorksOutWhatIsConstant)
{
    for (const char* operation : {"/", "%"})
    {
        const std::string text = FragmentText("Of(int4(3, -100, 7, -100), int4(3, 7, -1, 100))",
                                              "int4 Of(int4 x, int4 y) { x " +
                                                  std::string(operation) + "= y; return x; }\n");
        EXPECT_THAT(text, Not(HasSubstr("OpSDiv"))) << operation;
    }
}

} // namespace limn::test
