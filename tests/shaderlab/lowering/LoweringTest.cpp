#include "hlsl/TreeTestSupport.h"

#include <gtest/gtest.h>

namespace limn::test
{

TEST(Lowering, LeavesALoopAloneWhoseVariableIsDeclaredAgainBehindIt)
{
    // Where a statement without braces ends is where its ';' does, behind an else if there is one.
    for (const std::string body :
         {"s += i;", "if (i > 1) s += i; else s -= i;", "[branch] if (s > 1) s += 1; else s += i;",
          "for (int j = 0; j < i; j++) s += j;", "while (s < 9) s += i;", "{ s += i; }", ";"})
    {
        const std::string text = "float f(float s)\n{\n    for (int i = 0; i < 3; i++) " + body +
                                 "\n    int i = 5;\n    return s + i;\n}\n";
        EXPECT_EQ(text, Lowered(text));
    }
}

TEST(Lowering, HoistsTheVariableOfALoopThatIsUsedRightBehindIt)
{
    EXPECT_EQ(
        "float f(float s) {\nint limn_i10; for ( limn_i10 = 0; limn_i10 < 3; limn_i10++) "
        "s += 1;\nlimn_i10 += 4; return s; }",
        Lowered("float f(float s) {\nfor (int i = 0; i < 3; i++) s += 1;\ni += 4; return s; }"));
}

TEST(Lowering, HoistsOutOfStatementsWithoutBraces)
{
    EXPECT_EQ("float f(float s) { int limn_i16; if (s > 0) for ( limn_i16 = 0; limn_i16 < 3; "
              "limn_i16++) s += 1; return limn_i16; }",
              Lowered("float f(float s) { if (s > 0) for (int i = 0; i < 3; i++) s += 1; "
                      "return i; }"));
}

TEST(Lowering, TakesTheHiddenVariableWhereALoopsNumberCannotBeMeant)
{
    const std::string text =
        "struct V { float2 uv; }; float g(V v) { return v.uv.x; } float f(V i) { float s = 0; "
        "for (int i = 0; i < 3; i++) s += i; return s + i.uv.x + g(i); }";
    EXPECT_EQ(text, Lowered(text));
}

TEST(Lowering, GivesAVariableWhoseValueNamesAnotherOfItsNameItsOwn)
{
    EXPECT_EQ("float a; float f() { float limn_a9 = a * 2; return limn_a9; }",
              Lowered("float a; float f() { float a = a * 2; return a; }"));
    // A member is another thing.
    const std::string text = "struct S { float a; }; float f(S s) { float a = s.a; return a; }";
    EXPECT_EQ(text, Lowered(text));
}

TEST(Lowering, PutsTheNumbersOfAnArrayOfVectorsInConstructors)
{
    EXPECT_EQ("void f() { float2 a[] =\n {float2(1 , 2 ), float2(3, -4) }; }",
              Lowered("void f() { float2 a[] =\n{ 1, 2, float2(3, -4) }; }"));
    EXPECT_EQ("void f() { int2x2 m[1] = {int2x2(1 , 2 , 3 , 4)}; }",
              Lowered("void f() { int2x2 m[1] = {1, 2, 3, 4}; }"));
    EXPECT_EQ("void f(float4 v) { float2 a[] =  {(v ).xy, (v ).zw, float2(v.x , 1)}; }",
              Lowered("void f(float4 v) { float2 a[] = {v, v.x, 1}; }"));
    EXPECT_EQ("void f() { float2 a[2] = {float2(1 , 2 ), float2(3 , 4)}; }",
              Lowered("void f() { float2 a[2] = {{1, 2}, {3, 4}}; }"));
    EXPECT_EQ("void f() { float4 v = float4(1 , 2 , 3 , 4); }",
              Lowered("void f() { float4 v = {{1, 2}, {3, 4}}; }"));
}

// Messages about them tell the place.
TEST(Lowering, LeavesWhatAListTakesWholeInItsPlace)
{
    const std::string function = "float2 g(inout float s) { s += 1; return s; } ";
    EXPECT_EQ(function + "void f(float s) { float4 a[1] = {float4(g(s) , g(s))}; }",
              Lowered(function + "void f(float s) { float4 a[1] = {g(s), g(s)}; }"));
}

TEST(Lowering, LeavesListsThatDoNotFitAsTheyAre)
{
    for (const std::string list :
         {"float2 a[2] = {b, c};", "float2 a[] = {1, 2, 3};", "float2 a[2];  // {1, 2}"})
    {
        const std::string text = "void f() { " + list + "\n}";
        EXPECT_EQ(text, Lowered(text));
    }
}

TEST(Lowering, CutsArgumentsThatAreLargerThanTheParameter)
{
    EXPECT_EQ("float g(float a, float3x3 m) { return a; } "
              "float f(float3 v, float4x4 m) { return g((float)(v), (float3x3)(m)); }",
              Lowered("float g(float a, float3x3 m) { return a; } "
                      "float f(float3 v, float4x4 m) { return g(v, m); }"));
    EXPECT_EQ("float g(float a, float b = 2) { return a + b; } "
              "float f(float3 v) { return g((float)(v)); }",
              Lowered("float g(float a, float b = 2) { return a + b; } "
                      "float f(float3 v) { return g(v); }"));
    // Of two overloads the one that needs no cut is meant.
    const std::string text = "float g(float a) { return a; } float g(float3 a) { return a.x; } "
                             "float f(float3 v) { return g(v); }";
    EXPECT_EQ(text, Lowered(text));
}

TEST(Lowering, CutsArgumentsOfTheMethodThatIsMeant)
{
    const std::string types = "struct A { float F(float x) { return x; } }; "
                              "struct B { float F(float3 x) { return x.x; } }; ";
    EXPECT_EQ(types + "float f(A a, B b, float3 v) { return a.F((float)(v)) + b.F(v); }",
              Lowered(types + "float f(A a, B b, float3 v) { return a.F(v) + b.F(v); }"));
}

TEST(Lowering, MakesNumbersOfConditions)
{
    EXPECT_EQ("float f(float x) { switch ((int)(x * 2)) { case 1: return 1; } return 0; }",
              Lowered("float f(float x) { switch (x * 2) { case 1: return 1; } return 0; }"));
    EXPECT_EQ("float f(float2 a) { return any((bool2)(step(a, 1))) ? 1 : -(int)((a.x > 1)); }",
              Lowered("float f(float2 a) { return any(step(a, 1)) ? 1 : -(a.x > 1); }"));
    const std::string text = "float f(float2 a, uint k) { switch (k) { case 1: return 1; } "
                             "return any(a > 1); }";
    EXPECT_EQ(text, Lowered(text));
}

TEST(Lowering, CallsFunctionsOfMatricesRowByRow)
{
    EXPECT_EQ("float2x2 limn_lerp(float2x2 v0, float2x2 v1, float v2) { return "
              "float2x2(lerp(v0[0], v1[0], v2), lerp(v0[1], v1[1], v2)); } "
              "float2x2 f(float2x2 a) { return limn_lerp(a, a, 0.5); }",
              Lowered("float2x2 f(float2x2 a) { return lerp(a, a, 0.5); }"));
}

} // namespace limn::test
