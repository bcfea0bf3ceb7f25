#include <gtest/gtest.h>
#include <hlsl/rewrites/Rewrites.h>

namespace limn
{

TEST(HoistLoopVariables, LeavesALoopAloneWhoseVariableIsDeclaredAgainBehindIt)
{
    // Where a statement without braces ends is where its ';' does, behind an else if there is one.
    for (const std::string body :
         {"s += i;", "if (i > 1) s += i; else s -= i;", "[branch] if (s > 1) s += 1; else s += i;",
          "for (int j = 0; j < i; j++) s += j;", "while (s < 9) s += i;", "{ s += i; }", ";"})
    {
        const std::string text = "float f(float s)\n{\n    for (int i = 0; i < 3; i++) " + body +
                                 "\n    int i = 5;\n    return s + i;\n}\n";
        EXPECT_EQ(text, HoistLoopVariables(text));
    }
}

TEST(HoistLoopVariables, SeesAUseRightBehindTheLoop)
{
    EXPECT_EQ("float f(float s) {\nint i; for ( i = 0; i < 3; i++) s += 1;\ni += 4; return s; }",
              HoistLoopVariables(
                  "float f(float s) {\nfor (int i = 0; i < 3; i++) s += 1;\ni += 4; return s; }"));
}

TEST(GroupInitializers, PutsTheNumbersOfAnArrayOfVectorsInConstructors)
{
    EXPECT_EQ("static const float2 a[] =\n{ float2(1, 2), float2(3, -4) };",
              GroupInitializers("static const float2 a[] =\n{ 1, 2, float2(3, -4) };"));
    EXPECT_EQ("int2x2 m[1] = {int2x2(1, 2, 3, 4)};",
              GroupInitializers("int2x2 m[1] = {1, 2, 3, 4};"));
}

TEST(GroupInitializers, LeavesOtherTextAsItIs)
{
    for (const std::string text :
         {"float a[] = {1, 2};", "float2 v = {1, 2};", "float2 a[2] = {b, c};",
          "float2 a[2] = {{1, 2}, {3, 4}};", "float2 a[] = {1, 2, 3};", "float2 a[2];  // {1, 2}"})
    {
        EXPECT_EQ(text, GroupInitializers(text));
    }
}

} // namespace limn
