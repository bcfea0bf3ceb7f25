#include "hlsl/DialectGpuSupport.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <utility>

// Values of what limn spells anew for glslang, and of conversions that the language does by itself.

namespace limn::test
{

namespace
{

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

TEST_F(HlslDialectValues, MethodsWriteToCopiesOfUniforms)
{
    FunctionGrid grid(R"(
        float4 _Tint; float _Step, _Size, _Other;
        struct Brush
        {
            float _Size; float width;
            static void Double(float by, inout float4 color) { color *= by; }
            void Widen(out float x) { x = width + 1; _Size = 3; }
            void Mix() { _Tint.w = 7; width += _Step; _Other++; }
        };
        float4 Static() { Brush::Double(2, _Tint); return _Tint; }
        float2 Called() { Brush b; b.width = 4; b._Size = 0; b.Widen(_Step); return float2(_Step, b._Size); }
        float4 Inside() { Brush b; b._Size = 0; b.width = 1; b.Mix(); return float4(_Tint.w, b.width, _Other, _Size); })");
    grid.SetGlobal("_Tint", {1, 2, 3, 4});
    grid.SetGlobal("_Step", {10});
    grid.SetGlobal("_Size", {20});
    grid.SetGlobal("_Other", {30});
    grid.Add("Static()", k_Once, [](auto&, auto&, auto&) { return glm::dvec4(2, 4, 6, 8); });
    grid.Add("Called()", k_Once, [](auto&, auto&, auto&) { return glm::dvec2(5, 3); });
    grid.Add("Inside()", k_Once, [](auto&, auto&, auto&) { return glm::dvec4(7, 11, 31, 20); });
    grid.Run();
}

TEST_F(HlslDialectValues, StaticMembersHaveTheirValues)
{
    FunctionGrid grid(R"(
        struct Ring
        {
            float radius;
            static const float k_Two = 2, k_Four = k_Two * 2;
            static const float3 k_Steps[2] = { float3(1, 2, 3), float3(4, 5, 6) };
            static float s_Calls = 0;
            static float Twice(float x) { s_Calls += 1; return x * k_Two; }
            float Area() { return k_Four * radius * Twice(radius); }
        };
        struct Wide : Ring { float extra; float Sum() { return k_Two + extra; } };
        float4 Through(float x) { Ring r; r.radius = x; return float4(r.Area(), r.k_Two, Ring::k_Four, Ring::Twice(x)); }
        float2 Calls() { Ring r; r.radius = 1; Ring::s_Calls = 5; Ring::Twice(1); r.Twice(1); return float2(Ring::s_Calls, Ring::k_Steps[1].y); }
        float Derived() { Wide w; w.radius = 1; w.extra = 10; return w.Sum() + Wide::k_Four; }
        float Named(float k_Two) { return k_Two; })");
    grid.Add("Through(a.x)", k_Inputs,
             [](auto& a, auto&, auto&) { return glm::dvec4(8 * a.x * a.x, 2, 4, 2 * a.x); });
    grid.Add("Calls()", k_Once, [](auto&, auto&, auto&) { return glm::dvec2(7, 5); });
    grid.Add("Derived()", k_Once, [](auto&, auto&, auto&) { return 16; });
    grid.Add("Named(9)", k_Once, [](auto&, auto&, auto&) { return 9; });
    grid.Run();
}

TEST_F(HlslDialectValues, AnAuthorsNamesHideThoseOfTheLibrary)
{
    FunctionGrid grid(R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
        struct LightingData { float3 normalWS; float height; };
        half2 RotateByAngle(half2 v, half angle) { return v * 10 + angle; }
        float Own(float3 n)
        {
            LightingData data;
            data.normalWS = n;
            data.height = RotateByAngle(n.xy, n.z).y;
            return data.height + data.normalWS.x;
        }
        float RotateByAngle(float3 v) { return v.z; })");
    grid.Add("Own(a.xyz)", k_Inputs,
             [](const glm::dvec4& a, auto&, auto&) { return a.y * 10.0 + a.z + a.x; });
    grid.Add("RotateByAngle(b.xyz)", k_Inputs,
             [](auto&, const glm::dvec4& b, auto&) { return b.z; });
    // The library's own uses stay: a lit surface needs its LightingData.
    grid.Add(
        "UniversalFragmentBlinnPhong((InputData)0, a.xyz * 0, half4(0, 0, 0, 0), 0, c.xyz, 1).a",
        k_Once, [](auto&, auto&, auto&) { return 1.0; });
    grid.Run();
}

TEST_F(HlslDialectValues, BakedLightIsDimmedByOcclusionOnly)
{
    FunctionGrid grid(R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
        float3 Mixed(float3 baked, float occlusion)
        {
            Light light = (Light)0;
            AmbientOcclusionFactor factor;
            factor.indirectAmbientOcclusion = occlusion;
            factor.directAmbientOcclusion = 7;
            MixRealtimeAndBakedGI(light, float3(0, 1, 0), baked, factor);
            return baked;
        })");
    grid.Add("Mixed(a.xyz, b.w).x", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&) { return a.x * b.w; });
    grid.Run();
}

} // namespace limn::test
