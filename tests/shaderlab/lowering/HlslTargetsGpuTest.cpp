#include "hlsl/DialectGpuSupport.h"

// Values of what is written to, and of lists: what generated snippets (see values/) found glslang
// to make something else of.

namespace limn::test
{

namespace
{

using HlslTargetValues = GpuTest;

struct Value
{
    const char* hlsl;
    double wanted;
};

/// Runs expressions that read a = (1, 2, 3, 4) and b = (-5, 6, 7, 8).
void ExpectValues(const std::string& declarations, const std::vector<Value>& values)
{
    FunctionGrid grid(declarations);
    for (const Value& value : values)
    {
        grid.Add(value.hlsl, {k_Inputs.front()},
                 [wanted = value.wanted](auto&, auto&, auto&) { return wanted; });
    }
    grid.Run();
}

/// `Next()` counts its calls, which `Once(x)` asks for: 1000 for each but one.
const std::string k_Next = R"(
    static int s_Calls;
    int Next() { return s_Calls++; }
    float Once(float x) { float calls = s_Calls; s_Calls = 0; return x + 1000 * (calls - 1); })";

} // namespace

// spirv-opt crashed on them.
TEST_F(HlslTargetValues, ArraysArePutTogetherInPartsOfAnyDepth)
{
    ExpectValues(k_Next + R"(
        float Whole(float4 a, float4 b)
        {
            min16float3 v[2] = {min16float3(1, 2, 3), min16float3(4, 5, 6)};
            v[1].x = a.x + 100;
            v[0] = b.yzw;
            return v[0].x + 10 * v[0].z + v[1].x + 1000 * v[1].y;
        }
        float Folded(float4 a, float4 b)
        {
            float4 v[3] = {float4(1, 2, 3, 4), float4(4, 5, 6, 7), (float4)0};
            v[Next() % 3].x = a.y; // spirv-opt finds out which
            v[1] = b;
            return v[0].x + 10 * v[1].y + 100 * v[0].w;
        })",
                 {{"Whole(a, b)", 6 + 80 + 101 + 5000}, {"Folded(a, b)", 2 + 60 + 400}});
}

TEST_F(HlslTargetValues, ElementsOfMatricesAreStepped)
{
    ExpectValues(R"(
        float3 After(float4 v) { float2x2 m = float2x2(v); float2 old = m._m00_m11++; return float3(old, m[1][1]); }
        float3 Before(float4 v) { float2x2 m[2] = {float2x2(v), float2x2(v)}; float2 now = --m[1]._21_12; return float3(now, m[1][0][1]); }
        float Spread(float4 v) { float2x2 m = float2x2(v); float f = v.z; m._m00_m10 = f; return m[0][0] * 10 + m[0][1]; }
        float Converted(float4 v) { float2x2 m = float2x2(v); int4 n = v.wzyx; m._m00_m10 = n; return m[0][0] * 10 + m[1][0]; }
        float Alone(float4 v) { half3x2 m = (half3x2)v.x; m._m20_m01--; ++m._m20_m11; return m[2][0] * 10 + m[1][1]; })",
                 {{"After(a).y", 4},
                  {"Spread(a)", 32},
                  {"Converted(a)", 43},
                  {"After(a).z", 5},
                  {"Before(a).x", 2},
                  {"Before(a).z", 1},
                  {"Alone(a)", 12}});
}

TEST_F(HlslTargetValues, WhatIsChangedIsWorkedOutOnce)
{
    ExpectValues(k_Next + R"(
        float Truth(float4 v) { bool2 k[2] = {bool2(true, true), bool2(true, true)}; k[Next()].y &= v.x > 5; return Once(k[0].y * 2 + k[0].x); }
        float Set(float4 v) { float2x2 k[2] = {float2x2(v), float2x2(v)}; k[Next()]._m00_m11 = v.zw; return Once(k[0][0][0] * 10 + k[0][1][1]); }
        float Changed(float4 v) { float2x2 k[2] = {float2x2(v), float2x2(v)}; k[Next()]._m00_m11 -= v.zz; return Once(k[0][0][0] * 10 + k[0][1][1]); }
        float Product(float4 v) { float2x2 k[2] = {float2x2(v), float2x2(v)}; k[Next()] *= float2x2(v); return Once(k[0][1][1]); }
        float Moved(float4 v) { float2x2 k[2] = {(float2x2)0, (float2x2)0}; k[(uint)k[0]._m00]._m00_m11 = v.xx; return k[0][0][0] * 10 + k[0][1][1]; }
        float Step(float4 v) { float2x2 k[2] = {float2x2(v), float2x2(v)}; k[Next()]._m00_m11++; return Once(k[0][1][1]); }
        float Whole(float4 v) { int2 k[2] = {int2(1, 2), int2(3, 4)}; k[Next()] *= 1.5; return Once(k[0].y); })",
                 {{"Truth(a)", 1},
                  {"Set(a)", 34},
                  {"Changed(a)", -19},
                  {"Product(a)", 16},
                  {"Step(a)", 5},
                  {"Moved(a)", 11},
                  {"Whole(a)", 3}});
}

TEST_F(HlslTargetValues, IntegersAreChangedByWiderNumbers)
{
    ExpectValues(R"(
        float Sum(float x) { int n = 1; n += x + 0.5; return n; }
        float Rest(float x) { uint n = 1; n -= x * 0.5; return n; }
        float Product(float x) { int2 n = int2(3, -3); n.yx *= x * 0.5; return n.x * 10 + n.y; }
        float Quotient() { int n = -4; n /= 2u; return n == 2147483646; }
        float Small(float4 v) { min16int2 n = 3; n -= v.xy * 0.25; return n.x * 10 + n.y; })",
                 {{"Sum(a.x)", 2},
                  {"Rest(a.x)", 0},
                  {"Product(a.z)", 36},
                  {"Quotient()", 1},
                  {"Small(a)", 22}});
}

TEST_F(HlslTargetValues, WhatFunctionsGiveBackIsConverted)
{
    ExpectValues(R"(
        struct Pair { int2 v; };
        float Add(inout float x) { x += 1.5; return x; }
        void Fill(Pair p, inout float2 x, out int y) { x += p.v; y = 7; }
        void Later(inout float2 x);
        void Later(inout float2 x) { x *= 2; }
        float Whole(float4 v) { int n = v.z; float given = Add(n); return given * 10 + n; }
        float Part(float4 v) { Pair p; p.v = v.xy; Add(p.v.y); return p.v.y; }
        float Element(float4 v) { float2x2 m = float2x2(v); Later(m._m00_m11); return m[0][0] * 10 + m[1][1]; }
        float Both(float4 v)
        {
            Pair p = {v.xy}; float2x2 m = float2x2(v); half k;
            Fill(p, m._m10_m01, k);
            return m[1][0] * 100 + m[0][1] * 10 + k;
        })",
                 {{"Whole(a)", 49}, {"Part(a)", 3}, {"Element(a)", 28}, {"Both(a)", 447}});
}

TEST_F(HlslTargetValues, ListsWorkTheirValuesOutOnce)
{
    ExpectValues(k_Next + R"(
        float4 Count(float x) { return x + Next(); }
        float Split(float4 v) { float2 k[3] = {Count(v.x), Next(), v.x}; return k[0].y * 100 + k[1].y * 10 + k[2].x + s_Calls; }
        float Rows(float4 v) { float2x2 k[2] = {v, {v.xyz, 9}}; return k[0][1][0] * 10 + k[1][1][1]; })",
                 {{"Split(a)", 113}, {"Rows(a)", 39}});
}

TEST_F(HlslTargetValues, StaticsBeginWithZeros)
{
    ExpectValues(R"(
        struct Inner { float x[2]; float2x2 m; };
        static float s_Number, s_Other; static half3 s_Vector; static float2x2 s_Matrix; static Inner s_Inner;
        float Raised() { s_Number++; s_Vector += 2; s_Matrix += 3; s_Inner.x[1] += 4; return s_Number + s_Other + s_Vector.y * 10 + s_Matrix[1][0] * 100 + s_Inner.x[1] * 1000; })",
                 {{"Raised()", 4321}});
}

TEST_F(HlslTargetValues, ListsOfWhatLimnDoesNotKnow)
{
    FunctionGrid grid(R"(
        struct Four { float4 v; };
        Texture2D<float4> _Map; SamplerState sampler_Map;
        float4 Gathered(float2 uv) { { Four f = {_Map.GatherGreen(sampler_Map, uv)}; return f.v; } })");
    grid.SetTexture("_Map", MakeTexture(1, 1, [](int, int) { return glm::vec4(5, 6, 7, 8); }));
    grid.Add("Gathered(a.xy)", k_Inputs, [](auto&, auto&, auto&) { return glm::dvec4(6); });
    grid.Run();
}

TEST_F(HlslTargetValues, FunctionsOfOtherKindsOfNumbers)
{
    ExpectValues(R"(
        static const int s_Dot = dot(int2(1, 2), int2(3, 4));
        static const int s_Sum = mad(2, 3, 4);
        static const int2 s_Signs = sign(uint2(0, 4000000000));
        float Signs(float x) { float2x2 m = sign(float2x2(x, -x, 0, 2)); return m[0][0] * 100 + m[0][1] * 10 + m[1][1]; })",
                 {{"dot(int3(1, 1, 1), int3(3, 4, 5))", 12},
                  {"dot((uint2)a.x, (uint2)0) >= (int)b.x", 0},
                  {"s_Dot", 11},
                  {"s_Sum", 10},
                  {"sign((uint)(int)b.x) + 2 * sign((uint)0)", 1},
                  {"s_Signs.x * 10 + s_Signs.y", 1},
                  {"Signs(a.x)", 91},
                  {"saturate(any(a.xyz)) + frac(any(a.xyz))", 1},
                  {"(-bool2(true, false)).x + frac(-bool2(true, a.x)).y", -1},
                  {"(~bool2(true, false)).x", -2},
                  {"(float2x2(1, 2, 3, 7) % 4)[1][1]", 3}});
}

TEST_F(HlslTargetValues, StaticMatricesAndWhatIsCompared)
{
    ExpectValues(R"(
        static float2x2 s_Changed = float2x2(1, 2, 3, 4.5);
        static const float2x2 s_Rest = frac(s_Changed);
        static const float2x2 s_Product = float2x2(1, 2, 3, 7) * float2x2(1, 2, 3, 7);
        static const float2x2 s_Large = max(float2x2(1, 2, 3, 7), float2x2(4, 4, 4, 4)) * (1.0 - 2.0);
        static const float2x2 s_Modulo = float2x2(1, 2, 3, 7) % 4;
        static const float4 s_List = {-float2(8, 0.25), (float2)(int2(-1, 7) < int2(1, 0))};
        static const float s_Named[2] = {s_Product[1][1], s_List.z};)",
                 {{"s_Rest[1][1]", 0.5},
                  {"s_Product[1][1]", 49},
                  {"s_Large[1][1] * 10 + s_Large[0][0]", -74},
                  {"s_Modulo[1][1]", 3},
                  {"s_List.z * 10 + s_List.w", 10},
                  {"s_Named[0] + s_Named[1]", 50}});
}

} // namespace limn::test
