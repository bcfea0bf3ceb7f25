#include "hlsl/DialectGpuSupport.h"

#include <cmath>

// Values of the forms of HLSL that shaders of public projects failed on.

namespace limn::test
{

namespace
{

using UnseenFormValues = GpuTest;

Oracle Constant(double value)
{
    return [value](auto&, auto&, auto&)
    {
        return value;
    };
}

} // namespace

TEST_F(UnseenFormValues, NumbersOfOtherKinds)
{
    FunctionGrid grid(R"(
        const static uint k_Two = 2;
        const static float k_Weights[k_Two] = {0.25, 0.75};
        static const uint k_Name[4] = {'A', 'b', '0', '~'};
        float Half(uint k, int n) { half h = 0.5h; return k * 1.5h + n * (1.0h / 4.0H) + k * h; })");
    grid.Add("Half((uint)a.x, (int)b.x)", Combine({0, 1, 7}, {-3, 0, 5}),
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return a.x * 1.5 + b.x * 0.25 + a.x * 0.5; });
    grid.Add("k_Weights[(uint)a.x]", Combine({0, 1}),
             [](const glm::dvec4& a, auto&, auto&) { return a.x > 0.0 ? 0.75 : 0.25; });
    grid.Add("k_Name[(uint)a.x]", Combine({0, 1, 2, 3}),
             [](const glm::dvec4& a, auto&, auto&)
             { return double("Ab0~"[static_cast<int>(a.x)]); });
    grid.Add("'z'", k_Once, Constant('z'));
    grid.Run();
}

TEST_F(UnseenFormValues, LabelsOfFloats)
{
    FunctionGrid grid(R"(
        float Chosen(float mode)
        {
            switch (mode) { case 0.0: return 10; case 1.0f: return 20; case 2.5: return 30; default: break; }
            return 40;
        })");
    grid.Add("Chosen(a.x)", Combine({0, 1, 2, 3, -1}),
             [](const glm::dvec4& a, auto&, auto&) {
                 return a.x == 0.0 ? 10.0 : a.x == 1.0 ? 20.0 : a.x == 2.0 ? 30.0 : 40.0;
             });
    grid.Run();
}

TEST_F(UnseenFormValues, MacrosThatAreWrittenTightly)
{
    FunctionGrid grid("#define WEIGHTS\\\n"
                      "    static const float k_First = 3;\\\n"
                      "    static const float k_Second = 4;\n"
                      "WEIGHTS\n"
                      "#define SUM\\\n"
                      "(k_First * 10 + k_Second)\n"
                      "#define GET(name) v. ## name\n"
                      "#define RED(v) v ## .r\n"
                      "float Second(float4 v) { return GET(y); }\n"
                      "float First(float4 v) { return RED(v); }\n");
    grid.Add("SUM", k_Once, Constant(34));
    grid.Add("Second(a)", k_Inputs, [](const glm::dvec4& a, auto&, auto&) { return a.y; });
    grid.Add("First(a)", k_Inputs, [](const glm::dvec4& a, auto&, auto&) { return a.x; });
    grid.Run();
}

TEST_F(UnseenFormValues, AnAuthorsOverloadsBesideTheLanguagesFunctions)
{
    FunctionGrid grid(R"(
        struct Wrap { float4 v; };
        float4 tex2D(Wrap w, float2 uv) { return w.v * uv.x; }
        float4 lerp(Wrap a, Wrap b, float t) { return a.v * 100 + b.v * t; }
        float dot(Wrap a, float b) { return a.v.x + b; }
        sampler2D _Map;
        float4 Own(float4 v, float t) { Wrap w; w.v = v; return tex2D(w, t.xx); }
        float4 OwnLerp(float4 v, float t) { Wrap w; w.v = v; return lerp(w, w, t); }
        float OwnDot(float4 v) { Wrap w; w.v = v; return dot(w, 1.0); })");
    grid.SetTexture("_Map", MakeTexture(1, 1, [](int, int) { return glm::vec4(1, 2, 3, 4); }));
    grid.Add("tex2D(_Map, a.xy)", k_Inputs,
             [](auto&, auto&, auto&) { return glm::dvec4(1, 2, 3, 4); });
    grid.Add("tex2D(_Map, tex2D(_Map, a.xy).rg) * 2", k_Inputs,
             [](auto&, auto&, auto&) { return glm::dvec4(2, 4, 6, 8); });
    grid.Add("Own(a, b.x)", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&) { return a * b.x; });
    grid.Add("OwnLerp(a, b.x)", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&) { return a * 100.0 + a * b.x; });
    grid.Add("lerp(a, b, 0.25)", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&) { return a * 0.75 + b * 0.25; });
    grid.Add("dot(a.xyz, b.xyz) + OwnDot(a)", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return a.x * b.x + a.y * b.y + a.z * b.z + a.x + 1.0; });
    grid.Run();
}

TEST_F(UnseenFormValues, SamplersThatStandForTextures)
{
    FunctionGrid grid("SamplerState _Map;\n");
    grid.SetTexture("_Map", MakeTexture(1, 1, [](int, int) { return glm::vec4(5, 6, 7, 8); }));
    grid.Add("tex2D(_Map, a.xy)", k_Inputs,
             [](auto&, auto&, auto&) { return glm::dvec4(5, 6, 7, 8); });
    grid.Run();
}

TEST_F(UnseenFormValues, OffsetsByALoopsIndex)
{
    FunctionGrid grid(R"(
        Texture2D _Map; SamplerState sampler_Map;
        static const int2 k_Offsets[3] = {int2(0, 0), int2(1, 0), int2(0, 1)};
        float Sum(float2 uv)
        {
            float sum = 0, place = 1;
            [unroll] for (int k = 0; k < 3; k++)
            {
                sum += _Map.SampleLevel(sampler_Map, uv, 0, k_Offsets[k]).r * place;
                place *= 10;
            }
            return sum;
        })");
    grid.SetTexture(
        "_Map",
        MakeTexture(4, 4, [](int x, int y) { return glm::vec4(float(x + 4 * y), 0, 0, 0); }));
    // The middle of texel (1, 2), counted in the rows that a texture has in limn, the first of them
    // at v = 0.
    grid.Add("Sum(float2(0.375, 0.625))", k_Once, Constant(9 + 10 * 10 + 100 * 13));
    grid.Run();
}

TEST_F(UnseenFormValues, MatricesOfMin16)
{
    FunctionGrid grid(R"(
        float3 Turn(float3 v) { min16float3x3 m = min16float3x3(0, 1, 0, 0, 0, 1, 1, 0, 0); return mul(m, v); }
        float Corner() { min16int2x2 n = min16int2x2(1, 2, 3, 4); return n[1][0]; })");
    grid.Add("Turn(a.xyz)", k_Inputs,
             [](const glm::dvec4& a, auto&, auto&) { return glm::dvec3(a.y, a.z, a.x); });
    grid.Add("Corner()", k_Once, Constant(3));
    grid.Run();
}

// Names that mean different things in different places of one file, and a comment that looks like
// pragmas.
TEST_F(UnseenFormValues, NamesOfSeveralThings)
{
    FunctionGrid grid(R"(
        /*
        #pragma fragment Other
        #pragma target 5.0 */
        float Before() { return 1; } /* another */
        struct Kept { static const float k = 3; float x; };
        struct Plain { float k; float y; };
        struct One { float v; float Get() { return Add(v); } float Add(float a) { return a + 1; } };
        struct Two { float v; float Get() { return Add(v) * 2; } float Add(float a) { return a + 5; } };
        float Times(float a) { return a * 10; }
        struct Three { float v; float Get() { return Times(v); } };
        struct BufferSize { float4 c; };
        struct RWState { float q; };
        float Fields(float a)
        {
            Kept v; v.x = a;
            float sum = v.x;
            { Plain v; v.k = 5; v.y = a; sum += v.k * 100 + v.y; }
            return sum + v.k * 1000;
        }
        float Methods(float a)
        {
            One one; one.v = a; Two two; two.v = a; Three three; three.v = a;
            return one.Get() + two.Get() * 100 + three.Get() * 10000;
        }
        float Objects(float a)
        {
            BufferSize size; size.c = a; RWState state; state.q = 2;
            return size.c.w + state.q;
        }
        float Once(float a)
        {
            float2x2 m[3]; m[0] = m[1] = m[2] = float2x2(a, 1, 2, 3);
            int i = 0;
            m[i++] *= 2;
            m[i++]._m00 += 7;
            return m[0]._m00 + m[1]._m00 * 100 + m[2]._m00 * 10000 + i * 1000000;
        })");
    grid.Add("Before()", k_Once, Constant(1));
    grid.Add("Fields(a.x)", Combine({1, 2}),
             [](const glm::dvec4& a, auto&, auto&) { return a.x + 500 + a.x + 3000; });
    grid.Add("Methods(a.x)", Combine({1, 2}),
             [](const glm::dvec4& a, auto&, auto&)
             { return a.x + 1 + (a.x + 5) * 200 + a.x * 100000; });
    grid.Add("Objects(a.x)", Combine({1, 2}),
             [](const glm::dvec4& a, auto&, auto&) { return a.x + 2; });
    grid.Add("Once(a.x)", Combine({1, 2}),
             [](const glm::dvec4& a, auto&, auto&)
             { return a.x * 2 + (a.x + 7) * 100 + a.x * 10000 + 2000000; });
    grid.Run();
}

TEST_F(UnseenFormValues, IntegersThatFunctionsOfFloatsTake)
{
    FunctionGrid grid(R"(
        float Square(float v) { return v * v; }
        float Length(int2 n) { return sqrt(dot(n, n)); })");
    grid.Add("round(min((int)a.x, (int)b.x))", Combine({-3, 7}, {2, 5}),
             [](const glm::dvec4& a, const glm::dvec4& b, auto&) { return std::min(a.x, b.x); });
    grid.Add("sqrt(max((uint)a.x, (uint)b.x))", Combine({4, 9}, {1, 16}),
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return std::sqrt(std::max(a.x, b.x)); });
    grid.Add("saturate(clamp((int)a.x, -1, 1))", Combine({-5, 0, 5}),
             [](const glm::dvec4& a, auto&, auto&) { return a.x > 0.0 ? 1.0 : 0.0; });
    grid.Add("Length((int2)a.xy)", k_Inputs,
             [](const glm::dvec4& a, auto&, auto&)
             { return std::hypot(std::trunc(a.x), std::trunc(a.y)); });
    grid.Add("length(min((int2)a.xy, (int2)b.xy))", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             {
                 return std::hypot(std::min(std::trunc(a.x), std::trunc(b.x)),
                                   std::min(std::trunc(a.y), std::trunc(b.y)));
             });
    grid.Add("Square(min((int)a.x, (int)b.x)) + pow(max((int)a.x, 2), 2)", Combine({3}, {2, 5}),
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return std::pow(std::min(a.x, b.x), 2.0) + 9.0; });
    grid.Add("asfloat(max((int)a.x, 1065353216)) + f16tof32(max((uint)a.y, 15360u))", Combine({0}),
             [](auto&, auto&, auto&) { return 2.0; });
    grid.Run();
}

} // namespace limn::test
