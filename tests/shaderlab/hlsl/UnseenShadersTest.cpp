#include "hlsl/DialectTestSupport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// What shaders of public projects failed on, a case for each cause, in words of our own. The values
// are HlslLoweringGpuTest's.

namespace limn::test
{

namespace
{

struct Case
{
    const char* cause;
    const char* hlsl; ///< behind k_Vertex
};

constexpr Case k_HlslCases[] = {
    {"a switch on a float", R"(
        float _Mode;
        float4 frag(v2f i) : SV_Target
        {
            switch (_Mode) { case 0: return 1; case 1: return 0.5; default: break; }
            switch (floor(i.uv.x * 4)) { case 2: return 0; }
            return 0.25;
        })"},
    {"struct before the name of a type", R"(
        struct Tint { float4 color; };
        struct Tint Make(struct v2f i) { struct Tint t; t.color = i.uv.xyxy; return t; }
        float4 frag(struct v2f i) : SV_Target { return Make(i).color; })"},
    {"structs with a name from a typedef", R"(
        typedef struct { float4 pos : SV_POSITION; float2 uv : TEXCOORD0; } Given;
        typedef struct Light_ { float3 color; float k; } Light;
        typedef struct Light_ SameLight;
        float Sum(Light l) { return l.color.x + l.k; }
        float4 frag(Given i) : SV_Target
        {
            SameLight l; l.color = i.uv.xyx; l.k = 1; struct Light_ m = l;
            return Sum(l) + m.k;
        })"},
    {"any and all of numbers", R"(
        float4 frag(v2f i) : SV_Target
        {
            return any(step(i.uv, 0.5) + step(0.2, i.uv)) && all(i.uv) && any(i.uv.x) ? 1 : 0;
        })"},
    {"a uniform written through inout", R"(
        float4 _Tint;
        void Twice(inout float4 c) { c *= 2; }
        void More(inout float2 c) { c += 1; }
        float4 frag(v2f i) : SV_Target { Twice(_Tint); More(_Tint.zw); return _Tint; })"},
    {"a variable that begins as the uniform of its name", R"(
        float _Width;
        float4 frag(v2f i) : SV_Target { float _Width = _Width; _Width *= 2; return _Width; })"},
    {"a static that begins as what a function gives", R"(
        float4 _Tint;
        float4 Twice() { return _Tint * 2; }
        static float4 s_Twice = Twice();
        static float s_More = s_Twice.x + 1;
        float4 frag(v2f i) : SV_Target { return s_Twice * s_More; })"},
    {"a longer vector in a list of vectors", R"(
        float4 frag(v2f i) : SV_Target
        {
            float4 both = i.uv.xyyx;
            float2 uvs[] = {both, i.uv + 1, i.uv.x, 2};
            return uvs[0].xyxy + uvs[3].xyxy;
        })"},
    {"overloads for half and float", R"(
        half Luma(half3 c) { return c.x; }
        float Luma(float3 c) { return c.y; }
        float4 frag(v2f i) : SV_Target { half3 h = (half3)i.uv.xyx; return Luma(h) + Luma(i.uv.xyx); })"},
    {"lerp of matrices", R"(
        float3x3 _A, _B;
        float4 frag(v2f i) : SV_Target { return float4(mul(lerp(_A, _B, i.uv.x), i.uv.xyx), 1); })"},
    {"a loop's variable used behind its loop", R"(
        float4 frag(v2f i) : SV_Target
        {
            float s = 0;
            for (int k = 0; k < 3; k++) s += k;
            for (k = 0; k < 2; k++) s += k;
            return s + k;
        })"},
    {"several textures of one declaration in a cbuffer", R"(
        cbuffer Values { sampler2D _A, _B; float4 _C; };
        float4 frag(v2f i) : SV_Target { return tex2D(_A, i.uv) + tex2D(_B, i.uv) + _C; })"},
    {"matrices of two sizes in one product", R"(
        float4x4 _A, _B;
        float4 frag(v2f i) : SV_Target { float3x3 m = (float3x3)_A * _B; return m[0].xyzx; })"},
    {"the sign of a comparison", R"(
        float4 frag(v2f i) : SV_Target { clip(-(i.uv.x > i.uv.y)); return 1; })"},
    {"GLSL's extensions asked for", R"(
        #if defined(GL_ARB_gpu_shader5)
        #error this is not GLSL
        #endif
        float4 frag(v2f i) : SV_Target { return 1; })"},
    {"members of the library's buffers declared in others", R"(
        cbuffer UnityPerDraw { half4 unity_SHAr; float4 _Own; half4 unity_SHAg; };
        cbuffer UnityPerFrame { float4 _Time; };
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        float4 frag(v2f i) : SV_Target { return unity_SHAr + _Own + _Time; })"},
    {"a const sampler", R"(
        uniform const sampler2D _Map;
        float4 frag(v2f i) : SV_Target { return tex2D(_Map, i.uv); })"},
    {"textures by their precision", R"(
        Texture2D_half _Map; SamplerState sampler_Map; TextureCube_float _Sky;
        float4 frag(v2f i) : SV_Target
        {
            return _Map.Sample(sampler_Map, i.uv) + _Sky.Sample(sampler_Map, i.uv.xyx);
        })"},
};

constexpr Case k_CgCases[] = {
    {"a name of URP's that is the author's own here", R"(
        float3 _ScreenSize; float _TimeParameters;
        float4 frag(v2f i) : SV_Target { return _ScreenSize.xyzz * _TimeParameters; })"},
    {"a value of Unity's that shaders write to", R"(
        #include "UnityCG.cginc"
        float4 frag(v2f i) : SV_Target
        {
            unity_OcclusionMaskSelector = float4(0, 1, 0, 0);
            return unity_OcclusionMaskSelector;
        })"},
    {"old names of the built-in pipeline", R"(
        #include "UnityCG.cginc"
        sampler2D _Mask;
        float4 frag(v2f i) : SV_Target
        {
            return UNITY_SAMPLE_1CHANNEL(_Mask, i.uv) + unity_LightmapFade;
        })"},
};

} // namespace

TEST(UnseenShaders, CompileWhereUnitysCompilersTakeThem)
{
    for (const Case& item : k_HlslCases)
    {
        SCOPED_TRACE(item.cause);
        EXPECT_NO_THROW(CompileValid(k_Vertex + item.hlsl));
    }
    for (const Case& item : k_CgCases)
    {
        SCOPED_TRACE(item.cause);
        EXPECT_NO_THROW(CompileValid(k_Vertex + item.hlsl, ProgramLanguage::Cg));
    }
}

} // namespace limn::test
