#include "hlsl/DialectGpuSupport.h"

#include <algorithm>
#include <cmath>

// Values of what function bodies are lowered to by their types (shaderlab/src/lowering), each
// against what the language says of it.

namespace limn::test
{

namespace
{

/// A formula that looks at a only.
Oracle OfA(std::function<Values(const glm::dvec4&)> formula)
{
    return [formula = std::move(formula)](const glm::dvec4& a, auto&, auto&)
    {
        return formula(a);
    };
}

} // namespace

TEST_F(HlslDialectValues, ConditionsAreNumbersCutToIntegers)
{
    FunctionGrid grid(R"(
        float Pick(float x)
        {
            switch (x * 2) { case 0: return 10; case 1: { x = 20; break; } default: x = 30; }
            return x;
        })");
    // Whatever is cut off is cut towards 0.
    grid.Add("Pick(a.x)", Combine({-0.4, 0.0, 0.3, 0.5, 0.9, 1.5}),
             OfA(
                 [](const glm::dvec4& a)
                 {
                     const int cut = static_cast<int>(a.x * 2);
                     return cut == 0 ? 10.0 : cut == 1 ? 20.0 : 30.0;
                 }));
    grid.Add("any(step(0.5, a.xy)) ? 1 : 0", k_Inputs,
             OfA([](const glm::dvec4& a) { return a.x >= 0.5 || a.y >= 0.5 ? 1.0 : 0.0; }));
    grid.Add("all(a.xy * a.xy) ? 1 : 0", k_Inputs,
             OfA([](const glm::dvec4& a) { return a.x != 0.0 && a.y != 0.0 ? 1.0 : 0.0; }));
    grid.Add("any(a.x) + 2 * all(a.y > 0.5)", k_Inputs,
             OfA([](const glm::dvec4& a)
                 { return (a.x != 0.0 ? 1.0 : 0.0) + (a.y > 0.5 ? 2.0 : 0.0); }));
    grid.Add("-(a.x > 0.5)", k_Inputs,
             OfA([](const glm::dvec4& a) { return a.x > 0.5 ? -1.0 : 0.0; }));
    grid.Run();
}

TEST_F(HlslDialectValues, AVariableMayBeItsOwnValueWhereItIsNotReached)
{
    FunctionGrid grid(R"(
        float Alpha(float x)
        {
            float Threshold = Threshold;
            half3 Color = Color;
            if (x > 100.0) clip(x - Threshold - Color.r);
            Threshold = 2.0 * x;
            return Threshold;
        })");
    grid.Add("Alpha(a.x)", k_Inputs, OfA([](const auto& a) { return 2.0 * a.x; }));
    grid.Run();
}

TEST_F(HlslDialectValues, FunctionsOfVectorsTakeASingleValue)
{
    FunctionGrid grid(R"(
        int Three() { return 3; }
        static const float k_Sign = normalize(-4.0);
        // Unity's library has no such function: many shaders have one of their own.
        float Remap(float value, float from1, float to1, float from2, float to2)
        {
            return(value - from1) / (to1 - from1) * (to2 - from2) + from2;
        })");
    const auto inputs = Combine({-4.0, -0.25, 0.5, 3.0});
    grid.Add("normalize(a.x)", inputs, OfA([](const auto& a) { return a.x < 0.0 ? -1.0 : 1.0; }));
    grid.Add("normalize((half)a.x + a.x)", inputs,
             OfA([](const auto& a) { return a.x < 0.0 ? -1.0 : 1.0; }));
    grid.Add("normalize(Three()) + k_Sign + normalize(2)", inputs,
             OfA([](const auto&) { return 1.0; }));
    grid.Add("normalize(a.xy).x * length(a.xy)", inputs, OfA([](const auto& a) { return a.x; }),
             {1e-5, 1e-6});
    grid.Add("reflect(a.x, 0.5)", inputs, OfA([](const auto& a) { return a.x / 2.0; }));
    grid.Add("refract(a.x, -1.0, 0)", inputs, OfA([](const auto&) { return 1.0; }));
    grid.Add("faceforward(2.0, a.x, 1.0)", inputs,
             OfA([](const auto& a) { return a.x < 0.0 ? 2.0 : -2.0; }));
    grid.Add("Remap(a.x, 0, 2, 1, 5)", inputs, OfA([](const auto& a) { return 2.0 * a.x + 1.0; }));
    grid.Run();
}

TEST_F(HlslDialectValues, PartsOfANumberMayBeIntegers)
{
    FunctionGrid grid(R"(
        float2 Parts(float x) { int e; float m = frexp(x, e); return float2(m, e); }
        float2 Whole(float x) { int2 n; float2 r = modf(float2(x, 1), n); return float2(r.x, n.x); })");
    grid.Add("Parts(a.x)", Combine({1.0, 0.75, 10.0, -3.0}),
             OfA(
                 [](const glm::dvec4& a)
                 {
                     int exponent = 0;
                     const double mantissa = std::frexp(a.x, &exponent);
                     return glm::dvec2(mantissa, exponent);
                 }));
    grid.Add("Whole(a.x)", Combine({1.25, 0.75, 10.0, -3.5}),
             OfA([](const glm::dvec4& a)
                 { return glm::dvec2(a.x - std::trunc(a.x), std::trunc(a.x)); }));
    grid.Run();
}

TEST_F(HlslDialectValues, NamesStandForWhatIsDeclaredBeforeThem)
{
    FunctionGrid grid(R"(
        float _Scale;
        float Own(float x) { float _Scale = _Scale * 2; _Scale += x; return _Scale; }
        float Inner(float x) { float y = x; { float y = y + 1; x = y; } return x * 10 + y; }
        float4 Doubled() { return _Scale * 2; }
        static float4 s_Doubled = Doubled();
        static const float s_Sum = s_Doubled.x + _Scale;
        void Add(inout float2 sum, float x) { sum += x; }
        float4 _Sum;
        float2 Written(float x) { Add(_Sum.zw, x); return _Sum.zw; }
        float Shadowed(float _Sum) { _Sum += 1; return _Sum; })");
    grid.SetGlobal("_Scale", {3});
    grid.SetGlobal("_Sum", {1, 2, 3, 4});
    grid.Add("Own(a.x)", k_Inputs, OfA([](const glm::dvec4& a) { return 6.0 + a.x; }));
    grid.Add("Inner(a.x)", k_Inputs, OfA([](const glm::dvec4& a) { return 11 * a.x + 10; }));
    grid.Add("s_Doubled.x + 100 * s_Sum", k_Once, OfA([](auto&) { return 906.0; }));
    grid.Add("Written(a.x)", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec2(3 + a.x, 4 + a.x); }));
    grid.Add("Shadowed(a.x)", k_Inputs, OfA([](const glm::dvec4& a) { return a.x + 1; }));
    grid.Run();
}

TEST_F(HlslDialectValues, NumbersOfMoreThan32BitsAreCut)
{
    FunctionGrid grid("uint Cut() { return 0x1F00000012u; } uint Whole() { return 0x00000000FF; }");
    grid.Add("Cut() + 1000 * Whole()", k_Once, OfA([](auto&) { return 255018.0; }));
    grid.Run();
}

TEST_F(HlslDialectValues, ListsAreTakenNumberByNumber)
{
    FunctionGrid grid(R"(
        static const float2x2 s_Turn = {float2(1, 2), float2(3, 4)};
        float3x3 Matrix(float4 v) { float3x3 m = {v.xyz, v.yzw, 7, v.x, 8}; return m; }
        struct Inner { float a; float3 b; };
        struct Outer { Inner inner[2]; float2 c; };
        float4 Struct(float4 v)
        {
            Inner flat = {1, v.x, 3, 4};
            Outer outer = {{{v.x, v.yzw}, {5, 6, 7, 8}}, {9, v.w}};
            Outer all = {1, 2, 3, 4, v, v.xy};
            return float4(flat.b.x, outer.inner[1].b.y * outer.c.y, all.inner[1].b.z, all.c.x);
        }
        float4 Vector(float4 v) { float4 w = {1, v.yz, 2}; return w; }
        float4 Lists(float4 v)
        {
            float2 parts[] = {v, v.x, 7, v.yz};
            return float4(parts[0].y, parts[1].x, parts[2].x * parts[2].y, parts[3].y);
        })");
    grid.Add("Matrix(a)[1]", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec3(a.y, a.z, a.w); }));
    grid.Add("Matrix(a)[2]", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec3(7, a.x, 8); }));
    grid.Add("s_Turn[1]", k_Once, OfA([](auto&) { return glm::dvec2(3, 4); }));
    grid.Add("Struct(a)", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec4(a.x, 7 * a.w, a.w, a.x); }));
    grid.Add("Vector(a)", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec4(1, a.y, a.z, 2); }));
    grid.Add("Lists(a)", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec4(a.y, a.z, a.x * 7, a.z); }));
    grid.Run();
}

TEST_F(HlslDialectValues, ListsOfArraysAreTakenNumberByNumber)
{
    FunctionGrid grid(R"(
        #define SIZE 3
        static const float s_Kernel[SIZE][SIZE] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
        struct Light { float3 direction; float range; };
        static const Light s_Lights[2] = {1, 2, 3, 4, 5, 6, 7, 8};
        static const Light s_Nested[] = {{1, 2, 3, 4}, {{5, 6, 7}, 8}};
        float4 Columns(float4 v)
        {
            float2 pairs[2][2] = {v, v.zw, v.xy};
            float4 rows[2] = {{v.xy, v.xy}, {v.zw, 1, 2}};
            Light lights[2] = {v, {v.yzw, 9}};
            return float4(pairs[0][1].x, pairs[1][1].y, rows[1].y * rows[1].w, lights[1].range);
        }
        float4 Filled(float4 v)
        {
            float2 a[3] = (float2[3])v.x;
            float b[SIZE];
            b = (float[SIZE])0;
            b[1] = v.y;
            return float4(a[0].x, a[2].y, b[1], b[2]);
        })");
    grid.Add("float3(s_Kernel[0][2], s_Kernel[1][0], s_Kernel[2][1])", k_Once,
             OfA([](auto&) { return glm::dvec3(3, 4, 8); }));
    grid.Add("float4(s_Lights[1].direction, s_Lights[0].range)", k_Once,
             OfA([](auto&) { return glm::dvec4(5, 6, 7, 4); }));
    grid.Add("float4(s_Nested[1].direction, s_Nested[1].range)", k_Once,
             OfA([](auto&) { return glm::dvec4(5, 6, 7, 8); }));
    grid.Add("Columns(a)", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec4(a.z, a.y, a.w * 2, 9); }));
    grid.Add("Filled(a)", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec4(a.x, a.x, a.y, 0); }));
    grid.Run();
}

TEST_F(HlslDialectValues, TruthsAreJoinedInPlace)
{
    FunctionGrid grid(R"(
        float Joined(float4 v)
        {
            bool odd = v.x > 0.5;
            odd ^= v.y > 0.5;
            bool2 both = v.xy > 0.5;
            both &= odd;
            both |= v.zw > 0.5;
            return odd + 2 * both.x + 4 * both.y;
        }
        float Turned(float x) { return ~(x > 0.5); })");
    grid.Add("Joined(a)", k_Inputs,
             OfA(
                 [](const glm::dvec4& a)
                 {
                     const bool odd = (a.x > 0.5) != (a.y > 0.5);
                     const bool first = ((a.x > 0.5) && odd) || a.z > 0.5;
                     const bool second = ((a.y > 0.5) && odd) || a.w > 0.5;
                     return (odd ? 1.0 : 0.0) + (first ? 2.0 : 0.0) + (second ? 4.0 : 0.0);
                 }));
    grid.Add("Turned(a.x)", k_Inputs,
             OfA([](const glm::dvec4& a) { return a.x > 0.5 ? -2.0 : -1.0; }));
    grid.Run();
}

TEST_F(HlslDialectValues, SignsAreIntegers)
{
    FunctionGrid grid(R"(
        float Chosen(float3 v) { switch (sign(v).z) { case -1: return 10; case 0: return 20; default: return 30; } }
        float Joined(float4 v) { int2 n = ~sign(v.xy); n ^= sign(v.zw); return n.x * 10 + n.y; }
        float Named(float3 v) { static const float k_Names[3] = {5, 6, 7}; return k_Names[sign(v.x) + 1]; }
        float Least(float x) { uint n = 3; return -min(n, sign(x)); }
        uint Returned(float x) { return sign(x); }
        float Given(uint n) { return n; }
        float4 Large(float x) { uint n = sign(x); return float4(n, (uint)sign(x), Returned(x), Given(sign(x))); })");
    const auto sign = [](double x)
    {
        return (x > 0) - (x < 0);
    };
    grid.Add("sign(a.xy) / 2 + sign(b.xy) * 0.5", k_Inputs,
             [=](const glm::dvec4&, const glm::dvec4& b, auto&)
             { return glm::dvec2(sign(b.x) * 0.5, sign(b.y) * 0.5); });
    grid.Add("Chosen(a.xyz - 2.5)", k_Inputs,
             OfA([=](const glm::dvec4& a) { return 20.0 + 10.0 * sign(a.z - 2.5); }));
    grid.Add("Joined(a)", k_Inputs,
             OfA([=](const glm::dvec4& a)
                 { return (~sign(a.x) ^ sign(a.z)) * 10.0 + (~sign(a.y) ^ sign(a.w)); }));
    grid.Add("Named(a.yzw)", k_Inputs, OfA([=](const glm::dvec4& a) { return 6.0 + sign(a.y); }));
    grid.Add("Large(-1 - abs(a.x))", k_Inputs, OfA([](auto&) { return glm::dvec4(4294967295.0); }));
    grid.Add("Least(a.x)", k_Inputs, OfA([](auto&) { return 4294967295.0; }));
    grid.Run();
}

TEST_F(HlslDialectValues, ElementsOfMatricesAreChangedInPlace)
{
    FunctionGrid grid(R"(
        float4 Changed(float4 v)
        {
            float3x3 m[2] = {(float3x3)1, (float3x3)2};
            m[1]._m00_m12 += v.xy;
            m[1]._13_23 *= v.zw + v.yy * 2;
            m[0]._m11_m22_m00 -= 3 + v.x;
            return float4(m[1]._m00, m[1]._m12, m[1]._m02, m[0]._m22);
        })");
    grid.Add("Changed(a)", k_Inputs,
             OfA(
                 [](const glm::dvec4& a) {
                     return glm::dvec4(2 + a.x, (2 + a.y) * (a.w + 2 * a.y), 2 * (a.z + 2 * a.y),
                                       -2 - a.x);
                 }));
    grid.Run();
}

TEST_F(HlslDialectValues, ExponentsMayBeAnyNumber)
{
    FunctionGrid grid("");
    grid.Add("ldexp(a.xy, float2(3, -2))", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec2(a.x * 8, a.y / 4); }));
    grid.Add("ldexp(a.x, 0.5)", k_Inputs,
             OfA([](const glm::dvec4& a) { return a.x * std::sqrt(2.0); }));
    grid.Add("ldexp(a.x, 2)", k_Inputs, OfA([](const glm::dvec4& a) { return a.x * 4; }));
    grid.Run();
}

TEST_F(HlslDialectValues, StructsMayBeDeclaredWithTheirVariables)
{
    FunctionGrid grid(R"(
        static struct { float a; float2 b; } s_First = {1, 2, 3}, s_Second = {4, 5, 6};
        static const struct Named { float c; } s_Third = {7};
        float Sum(Named n)
        {
            struct { float d; } local;
            const struct Inner { struct { float f; } inner; } other = {8};
            local.d = other.inner.f;
            return n.c + s_First.b.y + s_Second.a + local.d;
        })");
    grid.Add("Sum(s_Third)", k_Once, OfA([](auto&) { return 22.0; }));
    grid.Run();
}

TEST_F(HlslDialectValues, StructsMayBeDeclaredInBuffersWithTheirVariables)
{
    FunctionGrid grid(R"(
        cbuffer Settings
        {
            float _Before;
            struct Pair { float a, b; } _One, _Two[2];
            struct { float c; } _Three;
            struct Late { float d; };
            Late _Four;
        };
        float Sum(Pair p) { return p.a * p.b + _Two[1].b + _Three.c + _Four.d + _Before; })");
    grid.SetGlobal("_Before", {1});
    grid.SetGlobal("_One.a", {2});
    grid.SetGlobal("_One.b", {3});
    grid.Add("Sum(_One)", k_Once, OfA([](auto&) { return 7.0; }));
    grid.Run();
}

TEST_F(HlslDialectValues, NamespacesHoldWhateverAFileDoes)
{
    FunctionGrid grid(R"(
        float Scale(float x) { return x * 1000; }
        namespace Inks
        {
            float4 _Tint;
            enum class Kind { Dry = 3, Wet };
            static const float k_Size = 2, k_Area = k_Size * k_Size;
            struct Drop { float size, k_Own; static const float k_Most = 7; float Area() { return size * k_Size; } };
            Drop Make(float size) { Drop d; d.size = size; d.k_Own = 0; return d; }
            float Scale(float x) { return x * k_Area; }
            namespace Thin { float Scale(float x) { return x / k_Size; } float Both(float x) { return Scale(x) + Inks::Scale(x); } }
        }
        namespace Pens { struct Drop { float2 ends; }; float Scale(Inks::Drop d) { Drop own; own.ends = d.size; return own.ends.y; } }
        Inks::Drop _Unused(Inks::Drop d) { return d; }
        float4 Call(float x)
        {
            Inks::Drop d = _Unused(Inks::Make(x));
            Pens::Drop p; p.ends = 1;
            return float4(d.Area() + Pens::Scale(d), Inks::Thin::Both(x), Scale(p.ends.x) + Inks::k_Area, Inks::Drop::k_Most + Inks::Kind::Wet + Inks::_Tint.y);
        })");
    grid.SetGlobal("_Tint", {0, 50, 0, 0});
    grid.Add("Call(a.x)", k_Inputs,
             OfA([](const glm::dvec4& a) { return glm::dvec4(3 * a.x, 4.5 * a.x, 1004, 61); }));
    grid.Run();
}

TEST_F(HlslDialectValues, FunctionsAndOperatorsOfMatricesWorkOnEachElement)
{
    FunctionGrid grid(R"(
        float2x3 M(float4 v) { return float2x3(v.xyz, v.yzw); }
        float4x4 Large(float4 v) { return float4x4(v, v.yzwx, v.zwxy, v.wxyz); }
        float First(float3x3 m) { return m[0].x + m[2].z; }
        float3x3 Scaled(float4 v, float4 w) { float3x3 m = Large(v); m *= (float3x3)Large(w); return m; })");
    grid.Add("lerp(M(a), M(b), 0.25)[1]", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return 0.75 * glm::dvec3(a.y, a.z, a.w) + 0.25 * glm::dvec3(b.y, b.z, b.w); });
    grid.Add("clamp(M(a), 0.25, M(b) + 1)[0]", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             {
                 const auto one = [](double x, double most)
                 {
                     return std::min(std::max(x, 0.25), most + 1);
                 };
                 return glm::dvec3(one(a.x, b.x), one(a.y, b.y), one(a.z, b.z));
             });
    grid.Add("((float3x3)Large(a) * Large(b))[2]", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return glm::dvec3(a.z * b.z, a.w * b.w, a.x * b.x); });
    grid.Add("Scaled(a, b)[1]", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return glm::dvec3(a.y * b.y, a.z * b.z, a.w * b.w); });
    grid.Add("(M(a) / (M(b) + 20) + M(a) - M(b))[0]", k_Inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             {
                 const auto one = [](double x, double y)
                 {
                     return x / (y + 20) + x - y;
                 };
                 return glm::dvec3(one(a.x, b.x), one(a.y, b.y), one(a.z, b.z));
             });
    grid.Add("First(Large(a))", k_Inputs, OfA([](const glm::dvec4& a) { return a.x + a.x; }));
    grid.Run();
}

TEST_F(HlslDialectValues, OverloadsOfHalfAndFloatAreTwoFunctions)
{
    FunctionGrid grid(R"(
        half Which(half x) { return 1; }
        float Which(float x) { return 2; }
        half2 Both(half2 a, half b);
        float2 Both(float2 a, float b) { return a * b; }
        half2 Both(half2 a, half b) { return Both((float2)a, (float)b) + 1; }
        half4 _Half; float4 _Float;)");
    grid.SetGlobal("_Half", {2, 3, 4, 5});
    grid.SetGlobal("_Float", {2, 3, 4, 5});
    for (const std::string argument : {"(half)a.x", "_Half.y", "_Half.x * 0.5", "1.5h"})
    {
        grid.Add("Which(" + argument + ")", k_Once, OfA([](auto&) { return 1.0; }));
    }
    for (const std::string argument : {"a.x", "_Float.y", "_Half.x * _Float.x", "1.5f", "1.5"})
    {
        grid.Add("Which(" + argument + ")", k_Once, OfA([](auto&) { return 2.0; }));
    }
    grid.Add("Both(_Half.xy, _Half.z)", k_Once, OfA([](auto&) { return glm::dvec2(9, 13); }));
    grid.Add("Both(_Float.xy, _Float.z)", k_Once, OfA([](auto&) { return glm::dvec2(8, 12); }));
    grid.Run();
    grid.options.halfIs16Bit = true;
    grid.Run();
}

} // namespace limn::test
