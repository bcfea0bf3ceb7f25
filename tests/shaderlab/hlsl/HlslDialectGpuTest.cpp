#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <utility>
#include <vulkan/GpuTestDevice.h>

// Values of what limn spells anew for glslang, and of conversions that the language does by itself.

namespace limn::test
{

namespace
{

using HlslDialectValues = GpuTest;

const std::vector<GridInput> k_Inputs = {
    {{1, 2, 3, 4}, {-5, 6, 7, 8}, {9, 10, -11, 12}},
    {{0.25, -2, 1e3, 0}, {1, 1, 0.5, 3}, {-1, 0, 2, -4}},
};

/// The matrix of the rows a, b, c and (1, 2, 3, 4), as HLSL's float4x4(a, b, c, float4(1, 2, 3,
/// 4)).
double Element(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c, int row, int column)
{
    const glm::dvec4 rows[] = {a, b, c, glm::dvec4(1, 2, 3, 4)};
    return rows[row][column];
}

constexpr const char* k_Matrix = "float4x4(a, b, c, float4(1, 2, 3, 4))";

} // namespace

TEST_F(HlslDialectValues, FixedAndHalfScalarsVectorsAndMatricesHold)
{
    FunctionGrid grid(R"(
        half4 Fill(half3x3 m, fixed4x4 k) { return mul(k, half4(m[0], 1)); }
        fixed Corner(half2 h) { fixed2x2 m = fixed2x2(1, 0, 0, h.y); return m[1][1]; })",
                      ProgramLanguage::Cg);
    grid.Add("Fill((half3x3)1, (fixed4x4)2) * a", k_Inputs,
             [](const glm::dvec4& a, auto&, auto&) { return 8.0 * a; });
    grid.Add("Corner(a.xy)", k_Inputs, [](const glm::dvec4& a, auto&, auto&) { return a.y; });
    grid.Run();
}

TEST_F(HlslDialectValues, LoopVariablesAfterTheirLoop)
{
    FunctionGrid grid(R"(
        float Both() { for (int n = 0, k = 5; n < k; n++, k--) {} return n * 10 + k; }
        float Second() { float s = 0; for (int n = 0, k = 7; n < 3; n++) { s += k; } return s * 10 + k; }
        float Again()
        {
            for (int n = 0, k = 1; n < 3; n++) { k *= 2; }
            float first = n * 100 + k * 10;
            for (int n = 5, k = 2; n < 6; n++) k++;
            return first + n + k;
        }
        float Hidden(float n) { for (int n = 0; n < 4; n++) {} return n; }
        float Local() { float n = 7, s = n; [loop] for (int n = 0; n < 3; ++n) { s += n; } return s * 10 + n; }
        struct Point { float x; };
        float Struct(Point n) { float s = 0; for (int n = 1; n < 3; n++) { s += n; } return s + n.x; })");
    const auto constant = [](double value)
    {
        return [value](auto&, auto&, auto&)
        {
            return value;
        };
    };
    grid.Add("Both()", Combine({0.0}), constant(32));    // 0,5 1,4 2,3 3,2
    grid.Add("Second()", Combine({0.0}), constant(217)); // 3 * 7 * 10 + 7
    grid.Add("Again()", Combine({0.0}), constant(389));  // 300 + 80 + 6 + 3
    grid.Add("Hidden(100)", Combine({0.0}), constant(4));
    grid.Add("Local()", Combine({0.0}), constant(103)); // (7 + 0 + 1 + 2) * 10 + 3
    grid.Add("Struct((Point)9.0)", Combine({0.0}), constant(12));
    grid.Run();
}

TEST_F(HlslDialectValues, LargerArgumentsAreCut)
{
    FunctionGrid grid(R"(
        float3 Corner(float3x3 m) { return mul(m, float3(1, 10, 100)); }
        float Both(float3x3 m, float k) { return m[2][1] * k; }
        float Plain(float x, float y) { return x - y; }
        float3 Three(float3 v) { return v; })");
    const std::string matrix = k_Matrix;
    grid.Add("Corner(" + matrix + ")", k_Inputs,
             [](auto& a, auto& b, auto& c)
             {
                 glm::dvec3 result;
                 for (int row = 0; row < 3; ++row)
                 {
                     result[row] = Element(a, b, c, row, 0) + 10 * Element(a, b, c, row, 1) +
                                   100 * Element(a, b, c, row, 2);
                 }
                 return result;
             });
    grid.Add("Both(" + matrix + ", b)", k_Inputs,
             [](auto&, auto& b, auto& c) { return c.y * b.x; });
    grid.Add("Both((float3x3)" + matrix + ", 2)", k_Inputs,
             [](auto&, auto&, auto& c) { return c.y * 2; });
    grid.Add("Plain(a, b.y)", k_Inputs, [](auto& a, auto& b, auto&) { return a.x - b.y; });
    grid.Add("Plain(a.x, b)", k_Inputs, [](auto& a, auto& b, auto&) { return a.x - b.x; });
    grid.Add("Plain(a.yzw, b)", k_Inputs, [](auto& a, auto& b, auto&) { return a.y - b.x; });
    grid.Add("Three(a)", k_Inputs, [](auto& a, auto&, auto&) { return glm::dvec3(a); });
    grid.Run();
}

TEST_F(HlslDialectValues, LargerValuesAreCut)
{
    FunctionGrid grid(R"(
        float3x3 Initial(float4x4 m) { float3x3 r = m; return r; }
        float3x3 Assigned(float4x4 m) { float3x3 r; r = m; return r; }
        float3x3 Returned(float4x4 m) { return m; }
        float Scalar(float4 v) { float s = v; s += v.yzw; return s; }
        float2 Pair(float4 v) { float2 r = 0; r += v; r.xy *= v.zwx; return r; }
        float3 Times(float4x4 m, float3 v) { float3 r = mul((float3x3)m, v); return r; })");
    const std::string matrix = k_Matrix;
    for (const std::string function : {"Initial", "Assigned", "Returned"})
    {
        grid.Add(function + "(" + matrix + ")[1]", k_Inputs,
                 [](auto&, auto& b, auto&) { return glm::dvec3(b); });
        grid.Add(function + "(" + matrix + ")[2]", k_Inputs,
                 [](auto&, auto&, auto& c) { return glm::dvec3(c); });
    }
    grid.Add("Scalar(a)", k_Inputs, [](auto& a, auto&, auto&) { return a.x + a.y; });
    grid.Add("Pair(a)", k_Inputs,
             [](auto& a, auto&, auto&) { return glm::dvec2(a.x * a.z, a.y * a.w); });
    grid.Add("a * b.xyz", k_Inputs, [](auto& a, auto& b, auto&) { return glm::dvec3(a * b); });
    grid.Add("a.xy - b", k_Inputs, [](auto& a, auto& b, auto&) { return glm::dvec2(a - b); });
    grid.Add("dot(a, b.xy)", k_Inputs,
             [](auto& a, auto& b, auto&) { return a.x * b.x + a.y * b.y; });
    grid.Add("max(a, b.xyz)", k_Inputs,
             [](auto& a, auto& b, auto&) { return glm::dvec3(glm::max(a, b)); });
    grid.Add("Times(" + matrix + ", a.xyz)", k_Inputs,
             [](auto& a, auto& b, auto& c)
             {
                 const glm::dvec3 v(a);
                 return glm::dvec3(glm::dot(glm::dvec3(a), v), glm::dot(glm::dvec3(b), v),
                                   glm::dot(glm::dvec3(c), v));
             });
    grid.Run();
}

TEST_F(HlslDialectValues, NumbersFillArraysOfVectorsInOrder)
{
    FunctionGrid grid(R"(
        static const float2 k_Pairs[] = { 1, -2, 3 * 2, 4, 5.5, 6 };
        static const float3 k_Three[2] = { 1, 2, 3, 4, (5 + 1), 7 };
        static const float2x2 k_Matrices[2] = { 1, 2, 3, 4, 5, 6, 7, 8, };
        static const float2 k_Grouped[2] = { { 1, 2 }, float2(3, 4) };
        static const float2 k_Mixed[] = { 1, 2, float2(3, 4), -5, 6, { 7, 8 } };
        static const float4 k_Parts[2] = { float3(1, 2, 3), 4, 5, float2(6, 7), 8 };
        float2 Local(int i) { const float2 k[3] = { 9, 8, 7, 6, 5, 4 }; return k[i]; })");
    const auto inputs = Combine({0.0, 1.0});
    grid.Add("k_Pairs[a.x + 1]", inputs,
             [](auto& a, auto&, auto&)
             { return a.x < 0.5 ? glm::dvec2(6, 4) : glm::dvec2(5.5, 6); });
    grid.Add("k_Three[a.x]", inputs,
             [](auto& a, auto&, auto&)
             { return a.x < 0.5 ? glm::dvec3(1, 2, 3) : glm::dvec3(4, 6, 7); });
    grid.Add("k_Matrices[a.x][1]", inputs,
             [](auto& a, auto&, auto&) { return a.x < 0.5 ? glm::dvec2(3, 4) : glm::dvec2(7, 8); });
    grid.Add("k_Grouped[a.x]", inputs,
             [](auto& a, auto&, auto&) { return a.x < 0.5 ? glm::dvec2(1, 2) : glm::dvec2(3, 4); });
    grid.Add("k_Mixed[a.x * 2 + 1]", inputs,
             [](auto& a, auto&, auto&) { return a.x < 0.5 ? glm::dvec2(3, 4) : glm::dvec2(7, 8); });
    grid.Add("k_Mixed[a.x * 2]", inputs,
             [](auto& a, auto&, auto&)
             { return a.x < 0.5 ? glm::dvec2(1, 2) : glm::dvec2(-5, 6); });
    grid.Add("k_Parts[a.x]", inputs,
             [](auto& a, auto&, auto&)
             { return a.x < 0.5 ? glm::dvec4(1, 2, 3, 4) : glm::dvec4(5, 6, 7, 8); });
    grid.Add("Local(a.x + 1)", inputs,
             [](auto& a, auto&, auto&) { return a.x < 0.5 ? glm::dvec2(7, 6) : glm::dvec2(5, 4); });
    grid.Run();
}

TEST_F(HlslDialectValues, BaseMembersComeFirst)
{
    FunctionGrid grid(R"(
        struct Base { float x; float2 y; };
        struct Derived : Base { float z; float Sum() { return x + y.x * 10 + y.y * 100 + z * 1000; } };
        float Sum(float4 v) { Derived d = { v.x, v.yz, v.w }; return d.Sum(); })");
    grid.Add("Sum(a)", k_Inputs,
             [](auto& a, auto&, auto&) { return a.x + a.y * 10 + a.z * 100 + a.w * 1000; });
    grid.Run();
}

TEST_F(HlslDialectValues, RowMajorUniformsHoldWhatIsSet)
{
    FunctionGrid grid("row_major float4x4 _M;");
    // Column by column: the element in row r and column c is 4 c + r.
    grid.SetGlobal("_M", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
    grid.Add("_M[1]", Combine({0.0}), [](auto&, auto&, auto&) { return glm::dvec4(1, 5, 9, 13); });
    grid.Add("mul(_M, a)", k_Inputs,
             [](auto& a, auto&, auto&)
             {
                 glm::dvec4 result(0.0);
                 for (int row = 0; row < 4; ++row)
                 {
                     for (int column = 0; column < 4; ++column)
                     {
                         result[row] += (4 * column + row) * a[column];
                     }
                 }
                 return result;
             });
    grid.Run();
}

TEST_F(HlslDialectValues, ScalarsFillMatrices)
{
    FunctionGrid grid(R"(
        static const float3x3 k_Ones = (float3x3)1;
        static const int3x3 k_Table = {1, 2, 3, 4, 5, 7, 8, 9, 10};
        static const int k_Five = 5;
        static const float3x3 k_All[2] = { (float3x3)-2, (float3x3)k_Five };
        half3x3 Half(int n) { return (half3x3)n; }
        float3 Local() { static const float3x3 k = (float3x3)6; return k[2]; })");
    const std::pair<std::string, std::function<double(const glm::dvec4&)>> scalars[] = {
        {"1",
         [](auto&)
         {
             return 1.0;
         }},
        {"-2",
         [](auto&)
         {
             return -2.0;
         }},
        {"3.5",
         [](auto&)
         {
             return 3.5;
         }},
        {"0x10",
         [](auto&)
         {
             return 16.0;
         }},
        {"7u",
         [](auto&)
         {
             return 7.0;
         }},
        {"true",
         [](auto&)
         {
             return 1.0;
         }},
        {"(int)a.x",
         [](auto& a)
         {
             return std::trunc(a.x);
         }},
        {"-(int)a.x",
         [](auto& a)
         {
             return -std::trunc(a.x);
         }},
        {"uint3(a.xyz)[1]",
         [](auto& a)
         {
             return std::trunc(a.y);
         }},
        {"(a.x > 1)",
         [](auto& a)
         {
             return a.x > 1 ? 1.0 : 0.0;
         }},
        {"a.x",
         [](auto& a)
         {
             return a.x;
         }},
    };
    const auto inputs = std::vector<GridInput>{{{5.75, 2.5, 0, 0}}, {{-0.5, 1, 0, 0}}};
    for (const auto& [scalar, value] : scalars)
    {
        for (const std::string size :
             {"2x2", "2x3", "2x4", "3x2", "3x3", "3x4", "4x2", "4x3", "4x4"})
        {
            const std::string matrix = "((float" + size + ")" + scalar + ")";
            const std::string row = "[" + std::to_string(size[0] - '1') + "]";
            const std::string column = "[" + std::to_string(size[2] - '1') + "]";
            grid.Add("float4(" + matrix + "[0][0], " + matrix + "[0]" + column + ", " + matrix +
                         row + "[0], " + matrix + row + column + ")",
                     inputs,
                     [value = value](auto& a, auto&, auto&) { return glm::dvec4(value(a)); });
        }
    }
    for (const std::string type : {"int", "uint"})
    {
        grid.Add("float3(((" + type + "3x3)2.75)[1])", inputs,
                 [](auto&, auto&, auto&) { return glm::dvec3(2); });
    }
    grid.Add("k_Table[1][2] / 2", inputs, [](auto&, auto&, auto&) { return 3; });
    grid.Add("k_All[0][1] + k_All[1][1] + Local()", inputs,
             [](auto&, auto&, auto&) { return glm::dvec3(-2 + 5 + 6); });
    grid.Add("k_Ones[2]", inputs, [](auto&, auto&, auto&) { return glm::dvec3(1); });
    grid.Add("Half(a.x * 4)[1]", inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(std::trunc(a.x * 4)); });
    grid.Add("float4x4((int)a.x)[3]", inputs,
             [](auto& a, auto&, auto&) { return glm::dvec4(std::trunc(a.x)); });
    grid.Add("mul((float3x3)(int)a.x, a.xyz)", inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(std::trunc(a.x) * (a.x + a.y + a.z)); });
    grid.Add("((float2x2)a)[1]", k_Inputs,
             [](auto& a, auto&, auto&) { return glm::dvec2(a.z, a.w); });
    grid.Run();
}

TEST_F(HlslDialectValues, MatrixSwizzlesEvaluateTheirOperandOnce)
{
    FunctionGrid grid(R"(
        static float s_Calls = 0;
        float4x4 Next(float x) { s_Calls += 1; return (float4x4)(x + s_Calls); }
        float3 Calls(float x) { s_Calls = 0; float2 v = Next(x)._m03_m13; return float3(v, s_Calls); }
        float3x4 m(float4 a, float4 b, float4 c) { return float3x4(a, b, c); }
        static const float2x2 k_Square = float2x2(1, 2, 3, 4);
        static const float2 k_Pair = k_Square._m10_m01;)");
    grid.Add("k_Pair", k_Inputs, [](auto&, auto&, auto&) { return glm::dvec2(3, 2); });
    grid.Add("Calls(a.x)", k_Inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(a.x + 1, a.x + 1, 1); });
    grid.Add("m(a, b, c)._m03_m12_m20.zxyy", k_Inputs,
             [](auto& a, auto& b, auto& c) { return glm::dvec4(c.x, a.w, b.z, b.z); });
    grid.Add("(float3x3(a.xyz, b.xyz, c.xyz))._11_32", k_Inputs,
             [](auto& a, auto&, auto& c) { return glm::dvec2(a.x, c.y); });
    grid.Add("m(a, b, c)._m01_m02.y", k_Inputs, [](auto& a, auto&, auto&) { return a.z; });
    grid.Run();
}

TEST_F(HlslDialectValues, NumbersThatAreNotFiniteHaveTheirBits)
{
    FunctionGrid grid(R"(
        #define FAR 1.#INF
        static const float k_Far = FAR;
        float Nearest(float a, float b) { float d = 1.#INF; d = min(d, a); return min(d, b); }
        float High(float x) { return asuint(x) >> 16; })");
    const auto constant = [](double value)
    {
        return [value](auto&, auto&, auto&)
        {
            return value;
        };
    };
    grid.Add("Nearest(a.x, b.x)", k_Inputs,
             [](auto& a, auto& b, auto&) { return std::min(a.x, b.x); });
    grid.Add("a.x < k_Far && -FAR < a.x", k_Inputs, constant(1));
    grid.Add("High(abs(a.x) * 1.#INF)", k_Inputs, constant(0x7F80));
    grid.Add("High(-1.#INFf)", k_Inputs, constant(0xFF80));
    grid.Add("High(1.#QNAN)", k_Inputs, constant(0x7FC0));
    grid.Add("High(-1.#IND)", k_Inputs, constant(0xFFC0));
    grid.Run();
}

TEST_F(HlslDialectValues, EnumeratorsAreIntegers)
{
    FunctionGrid grid(R"(
        enum Shape { Disc, Square = 1 << 2, Line, };
        enum class Side : uint { Left = 7, Right, Both = Left + Right };
        enum { Alone = 9 };
        float Size(Shape shape) { switch (shape) { case Square: return 10; default: return shape; } }
        float Mixed(float Left) { Side side = Side::Both; return side * 100 + Side::Right + Left; })");
    grid.Add("float4(Disc, Size(Shape::Square), Size(Line), Alone)", Combine({0.0}),
             [](auto&, auto&, auto&) { return glm::dvec4(0, 10, 5, 9); });
    grid.Add("Mixed(a.x)", k_Inputs, [](auto& a, auto&, auto&) { return 1508 + a.x; });
    grid.Run();
}

TEST_F(HlslDialectValues, FunctionsWriteToCopiesOfUniforms)
{
    FunctionGrid grid(R"(
        float4 _Tint; float _Steps[2];
        void Double(float by, inout float4 color) { color *= by; }
        void Set(out float x) { x = 5; }
        float4 Both() { Double(2, _Tint); Set(_Steps[1]); return _Tint * _Steps[1]; })");
    grid.SetGlobal("_Tint", {1, 2, 3, 4});
    grid.Add("Both()", Combine({0.0}),
             [](auto&, auto&, auto&) { return glm::dvec4(10, 20, 30, 40); });
    grid.Run();
}

} // namespace limn::test
