#include "Mentions.h"
#include "hlsl/DialectTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using namespace test;

TEST(HlslDialect, TakesVectorsByTheirLongNameAcrossTheBordersOfStages)
{
    const auto pass = CompileValid(R"(
        struct Input { vector<float, 4> p : POSITION; vector<float, 3> n : NORMAL; };
        struct Between { vector<float, 4> p : SV_POSITION; vector<float, 3> n : NORMAL;
                         vector<half, 2> t : TEXCOORD1; };
        Between vert(Input i) { Between b; b.p = i.p; b.n = i.n; b.t = i.n.xy; return b; }
        vector<float, 4> frag(Between b) : SV_Target { return float4(b.n, b.t.x); })");
    ASSERT_EQ(pass->layout.vertexInputs.size(), 2u);
    EXPECT_EQ(pass->layout.vertexInputs[1].components, 3);
}

TEST(HlslDialect, SamplesOldSamplersInEveryWay)
{
    const auto pass = CompileFragment(R"(
        sampler2D _A; sampler3D _B; samplerCUBE _C; sampler2D_float _D; sampler2D_half _E;
        fixed4 frag(v2f i) : SV_Target
        {
            float4 u = float4(i.uv, 0, 1);
            return tex2D(_A, i.uv) + tex2D(_A, i.uv, ddx(i.uv), ddy(i.uv)) + tex2Dlod(_A, u)
                + tex2Dbias(_A, u) + tex2Dgrad(_A, i.uv, ddx(i.uv), ddy(i.uv)) + tex2Dproj(_A, u)
                + tex3D(_B, u.xyz) + tex3Dlod(_B, u) + texCUBE(_C, u.xyz) + texCUBElod(_C, u)
                + texCUBEbias(_C, u) + tex2D(_D, i.uv) + tex2D(_E, i.uv);
        })");
    EXPECT_EQ(pass->layout.textures.size(), 5u);
    EXPECT_TRUE(pass->layout.samplers.empty());
    const std::string spirv = test::Disassemble(pass->fragmentSpirv);
    EXPECT_THAT(spirv, HasSubstr("OpImageSampleExplicitLod"));
}

TEST(HlslDialect, TakesTheFaceInEveryType)
{
    for (const std::string parameter :
         {"fixed f : VFACE", "float f : VFACE", "half f : vface", "float f : FACE",
          "bool f : SV_IsFrontFace", "uint f : SV_IsFrontFace"})
    {
        SCOPED_TRACE(parameter);
        const auto pass = CompileFragment("fixed4 frag(v2f i, " + parameter +
                                          ") : SV_Target { return f > 0 ? 1 : 0; }");
        EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("BuiltIn FrontFacing"));
    }
}

TEST(HlslDialect, TakesThePixelsPosition)
{
    for (const std::string parameter :
         {"float4 s : VPOS", "float2 s : VPOS", "float4 s : SV_Position", "float4 s : sv_position"})
    {
        SCOPED_TRACE(parameter);
        const auto pass = CompileValid("float4 vert(float4 p : POSITION) : SV_POSITION { return p; "
                                       "}\nfloat4 frag(" +
                                       parameter + ") : SV_Target { return s.xyxy; }");
        EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("BuiltIn FragCoord"));
    }
}

TEST(HlslDialect, WritesUpToEightTargetsAndADepth)
{
    const auto one = CompileFragment(R"(
        struct target { float4 a : SV_Target0; half4 b : SV_TARGET1; float4 c : COLOR2;
                        float d : SV_Depth; };
        target frag(v2f i)
        {
            target r; r.a = 1; r.b = 2; r.c = i.uv.xyxy; r.d = 0.5; return r;
        })");
    EXPECT_EQ(one->layout.colorOutputs, 3);
    std::string parameters;
    std::string body;
    for (const char digit : std::string("01234567"))
    {
        parameters += std::string(", out float4 t") + digit + " : SV_Target" + digit;
        body += std::string("t") + digit + " = " + digit + "; ";
    }
    const auto eight = CompileFragment("void frag(v2f i" + parameters + ") { " + body + "}");
    EXPECT_EQ(eight->layout.colorOutputs, 8);
    EXPECT_EQ(CompileFragment("half3 frag(v2f i) : SV_Target { return 1; }")->layout.colorOutputs,
              1);
    EXPECT_EQ(CompileFragment("void frag(v2f i) {}")->layout.colorOutputs, 0);
}

TEST(HlslDialect, CarriesArraysMatricesIntegersAndModifiersBetweenTheStages)
{
    const auto pass = CompileValid(R"(
        #define N 3
        static const int COUNT = 2;
        struct v2f
        {
            float4 pos : SV_POSITION;
            float4 a[N - 1] : TEXCOORD0;
            float2 b[COUNT] : TEXCOORD4;
            float3x3 tbn : TEXCOORD6;
            nointerpolation uint id : TEXCOORD9;
            centroid float2 c : TEXCOORD10;
            noperspective float z : TEXCOORD11;
        };
        v2f vert(float4 p : POSITION, uint id : SV_VertexID, uint instance : SV_InstanceID)
        {
            v2f o;
            o.pos = p; o.a[0] = p; o.a[1] = p; o.b[0] = o.b[1] = p.xy; o.tbn = (float3x3)1;
            o.id = id + instance; o.c = p.xy; o.z = p.z;
            return o;
        }
        float4 frag(v2f i) : SV_Target
        {
            return i.a[1] + i.b[1].xyxy + i.tbn[2].xyzz + i.id + i.c.xyxy + i.z;
        })");
    const std::string spirv = test::Disassemble(pass->fragmentSpirv);
    EXPECT_THAT(spirv, HasSubstr(" Flat"));
    EXPECT_THAT(spirv, HasSubstr(" Centroid"));
    EXPECT_THAT(spirv, HasSubstr(" NoPerspective"));
}

TEST(HlslDialect, GivesZeroAndAWarningForWhatTheVertexFunctionDoesNotWrite)
{
    const auto pass = test::CompileHlsl(
        "float4 vert(float4 p : POSITION) : SV_POSITION { return p; }\n"
        "float4 frag(float2 uv : TEXCOORD1) : SV_Target { return uv.xyxy + 0.25; }");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    EXPECT_THAT(test::Messages(pass->diagnostics),
                ElementsAre(test::Mentions("1:1: warning: frag", "'TEXCOORD1'", "vertex function",
                                           "not write")));
    const std::string spirv = test::Disassemble(pass->fragmentSpirv);
    EXPECT_THAT(spirv, testing::Not(HasSubstr("OpLoad")));
    EXPECT_THAT(spirv, HasSubstr("%float_0_25"));
}

TEST(HlslDialect, ReflectsUniformsOfEveryType)
{
    const auto pass = CompileFragment(R"(
        float4 _Arr[8]; float _Weights[4]; float4x4 _M[2]; half3x3 _R;
        int _Count; bool _On; uint _U; int4 _I4; float2 _V2; float3 _V3; float _Scale = 2;
        float4 frag(v2f i) : SV_Target
        {
            float4 s = 0;
            for (int k = 0; k < _Count; k++) s += _Arr[k] * _Weights[k];
            if (_On) s += mul(_M[1], s);
            s.xy += _V2;
            s.xyz += mul(_R, _V3);
            return s * _Scale + _I4 + _U;
        })");
    EXPECT_EQ(Member(*pass, "_Arr").arraySize, 8);
    EXPECT_EQ(Member(*pass, "_Arr").arrayStride, 16u);
    EXPECT_EQ(Member(*pass, "_Weights").arraySize, 4);
    EXPECT_EQ(Member(*pass, "_Weights").arrayStride, 16u);
    EXPECT_EQ(Member(*pass, "_M").type, UniformType::Matrix4x4);
    EXPECT_EQ(Member(*pass, "_M").arraySize, 2);
    EXPECT_EQ(Member(*pass, "_Count").type, UniformType::Int);
    EXPECT_EQ(Member(*pass, "_On").type, UniformType::UInt);
    EXPECT_EQ(Member(*pass, "_U").type, UniformType::UInt);
    EXPECT_EQ(Member(*pass, "_I4").components, 4);
    EXPECT_EQ(Member(*pass, "_V2").components, 2);
    EXPECT_EQ(Member(*pass, "_V3").components, 3);
    EXPECT_EQ(Member(*pass, "_Scale").type, UniformType::Float);
}

TEST(HlslDialect, KeepsConstantBuffersApart)
{
    const auto pass = CompileFragment(R"(
        CBUFFER_START(UnityPerMaterial) float4 _C; half _S; CBUFFER_END
        cbuffer Third : register(b3) { float3 _E : packoffset(c0); float _G; float2 _Pairs[2]; }
        float4 frag(v2f i) : SV_Target
        {
            return _C * _S + _E.xyzz * _G + _Pairs[1].xyxy;
        })");
    ASSERT_EQ(pass->layout.buffers.size(), 2u);
    EXPECT_EQ(Member(*pass, "_S").offset, 16u);
    EXPECT_EQ(Member(*pass, "_G").offset, 12u);
    EXPECT_EQ(Member(*pass, "_Pairs").offset, 16u);
}

TEST(HlslDialect, NamesSamplerStatesAsWritten)
{
    const auto pass = CompileFragment(R"(
        Texture2D _A; Texture2D<half4> _B; sampler sampler_A;
        SamplerState sampler_LinearClamp, my_trilinear_mirror_sampler;
        SamplerState sampler_linear_clampU_mirrorV;
        SamplerComparisonState sampler_LinearClampCompare;
        float4 frag(v2f i) : SV_Target
        {
            uint w, h, n;
            _A.GetDimensions(w, h);
            _A.GetDimensions(0, w, h, n);
            return _A.Sample(sampler_A, i.uv, int2(1, 0)) + _B.Sample(sampler_LinearClamp, i.uv)
                + _A.SampleLevel(my_trilinear_mirror_sampler, i.uv, 0)
                + _A.SampleGrad(sampler_linear_clampU_mirrorV, i.uv, i.uv, i.uv)
                + _A.SampleCmpLevelZero(sampler_LinearClampCompare, i.uv, 0.5)
                + _A.Load(int3(1, 2, 0)) + _A[uint2(1, 1)] + _A.GatherRed(sampler_A, i.uv) + w;
        })");
    std::vector<std::string> names;
    for (const SamplerBinding& sampler : pass->layout.samplers)
    {
        names.push_back(sampler.name);
        EXPECT_EQ(sampler.comparison, sampler.name == "sampler_LinearClampCompare");
    }
    EXPECT_THAT(names, testing::UnorderedElementsAre(
                           "sampler_A", "sampler_LinearClamp", "my_trilinear_mirror_sampler",
                           "sampler_linear_clampU_mirrorV", "sampler_LinearClampCompare"));
}

TEST(HlslDialect, ReadsStructuredAndRawBuffers)
{
    const auto pass = CompileValid(R"(
        struct Item { float3 p; float w; float4x4 m; uint id; };
        StructuredBuffer<Item> _Items; StructuredBuffer<uint> _Ids; ByteAddressBuffer _Raw;
        float4 vert(float4 p : POSITION, uint id : SV_InstanceID) : SV_POSITION
        {
            return mul(_Items[_Ids[id]].m, p) + asfloat(_Raw.Load(4)) + asfloat(_Raw.Load2(8)).xyxy;
        }
        float4 frag() : SV_Target { return _Items[1].w; })");
    std::map<std::string, std::uint32_t> strides;
    for (const StorageBufferBinding& buffer : pass->layout.storageBuffers)
    {
        strides[buffer.name] = buffer.stride;
    }
    EXPECT_EQ(strides.size(), 3u);
    EXPECT_EQ(strides["_Ids"], 4u);
    EXPECT_EQ(strides["_Raw"], 0u);
}

TEST(HlslDialect, HasConstantsOverloadsDefaultsAndMacrosThatDeclare)
{
    CompileFragment(R"(
        static const float2 K[3] = { float2(0, 1), float2(1, 0), { 1, 1 } };
        const float G = 0.5;
        static float counter = 0;
        #define DECLARE(x) float4 _##x##_ST; Texture2D _##x; SamplerState sampler_##x;
        DECLARE(Main)
        #ifdef UNDEFINED
        Broken here;
        #endif
        float f(float a, float b = 2, float3 c = float3(1, 2, 3)) { return a * b + c.x; }
        float f(float2 a) { return a.x; }
        float4 later(float x);
        float4 frag(v2f i) : SV_Target
        {
            counter += 1;
            return f(i.uv.x) + f(i.uv.x, 3) + f(i.uv) + K[(int)i.uv.x].xyxy * G * counter
                + _Main.Sample(sampler_Main, i.uv * _Main_ST.xy) + later(i.uv.y);
        }
        float4 later(float x) { return x; })");
}

TEST(HlslDialect, LetsTheCodeAssignToMaterialConstantsThroughMembersAndInout)
{
    const auto pass = CompileFragment(R"(
        float4 _C; float _F;
        cbuffer UnityPerMaterial { float4 _M; };
        float4 frag(v2f i) : SV_Target
        {
            _C.xyz *= 2; _F++; _M = _C;
            return _C * _F + _M;
        })");
    EXPECT_EQ(Member(*pass, "_F").components, 1);
}

TEST(HlslDialect, LetsVariablesBeCalledAsGeometryModifiersAre)
{
    CompileFragment(R"(
        struct shape { float line : A; float triangle : B; };
        float4 frag(v2f i) : SV_Target
        {
            float point = 1, line = 2; float4 sample = 3; float triangle = 4; float linear = 5;
            shape s; s.line = line; s.triangle = triangle;
            for (int shared = 0; shared < 2; shared++) point += linear;
            return point + s.line * s.triangle + sample;
        })");
}

TEST(HlslDialect, LeavesTheNameNoiseToTheAuthor)
{
    CompileFragment(R"(
        float noise(float2 p) { return frac(sin(dot(p, float2(12.9, 78.2))) * 43758.5); }
        fixed4 frag(v2f i) : SV_Target { float noise2 = noise(i.uv); return noise2; })");
}

TEST(HlslDialect, RefusesFunctionsThatNoDeviceHas)
{
    for (const std::string call : {"noise(i.uv)", "msad4(1, uint2(1, 2), uint4(1, 2, 3, 4))"})
    {
        SCOPED_TRACE(call);
        try
        {
            test::CompileHlsl(k_Vertex + "float4 frag(v2f i) : SV_Target { return " + call + "; }");
            ADD_FAILURE() << "nothing was thrown";
        }
        catch (const AssetError& error)
        {
            EXPECT_THAT(error.what(), HasSubstr("'" + call.substr(0, call.find('(')) +
                                                "_': no matching overloaded function found"));
        }
    }
}

TEST(HlslDialect, SwizzlesMatrices)
{
    const auto pass = CompileFragment(R"(
        float4x4 _M;
        float4 frag(v2f i) : SV_Target
        {
            float3 position = _M._m03_m13_m23;
            float4x4 m = _M;
            m._m00 = 2;
            m[0][1] = 3;
            return _M._m03_m13_m23.xzyy + _M._14_24_34.x + m._m00_m11_m22_m33 + position.xyzz
                + mul((float3x3)m, i.uv.xyx).xyzz;
        })");
    EXPECT_EQ(Member(*pass, "_M").type, UniformType::Matrix4x4);
}

TEST(HlslDialect, KeepsLoopVariablesThatAreUsedAfterTheirLoop)
{
    CompileFragment(R"(
        float4 frag(v2f i) : SV_Target
        {
            float sum = 0;
            for (int n = 0; n < 4; n++) { sum += n; }
            for (n = 0; n < 3; n++) sum += i.uv.x;
            [unroll] for (int k = 0; k < 4; k++) if (k > 1) { sum += k; } else sum -= k;
            sum += k;
            for (int k = 0; k < 2; k++) sum += k;
            return sum + k + n;
        })");
}

TEST(HlslDialect, KeepsAllVariablesOfALoopIfOneIsUsedAfterIt)
{
    CompileFragment(R"(
        float4 frag(v2f i) : SV_Target
        {
            float sum = 0;
            for (int n = 0, k = min(3, 4), unset; n < k; n++, k--) sum += n;
            sum += k;
            for (int n = 0, k = 1; n < k; n++) sum += n;
            { for (uint m = 0, q = 1; m < 2; m++) { sum += q; } sum += m; }
            { for (uint m = 0, q = 1; m < 2; m++) { sum += m; } sum += q; }
            for (int a = 0, b = 1; a < 2; a++) { sum += b; }
            float b = 2;
            return sum + k + n + b;
        })");
}

TEST(HlslDialect, LeavesLoopVariablesAloneThatAreDeclaredAgain)
{
    CompileFragment(R"(
        float Sum(int n) { float s = n; { for (int n = 0; n < 3; ++n) { s += n; } } return s + n; }
        float4 frag(v2f i) : SV_Target
        {
            float sum = 0;
            for (int n = 0; n < 4; n++) { sum += n; }
            for (uint n = 0; n < 4; n++) { sum += n; }
            float a = 1, n = 2;
            for (int j = 0, k = 1; j < 4; j++) { sum += k; }
            return sum + a + n + Sum(2);
        })");
}

TEST(HlslDialect, EndsTwoTemplateArgumentsAtOnce)
{
    const auto pass = CompileFragment(R"(
        Texture2D<vector<float, 4>> _T; SamplerState sampler_T;
        StructuredBuffer<matrix<float,4,4>> _B;
        float4 frag(v2f i) : SV_Target
        {
            int shifted = 8 >> 1;
            return mul(_B[shifted>>1], _T.Sample(sampler_T, i.uv));
        })");
    EXPECT_EQ(pass->layout.textures.at(0).name, "_T");
    EXPECT_EQ(pass->layout.storageBuffers.at(0).stride, 64u);
}

TEST(HlslDialect, TakesListsInListsOfVectors)
{
    const auto pass = CompileFragment(
        "float4 frag(v2f i) : SV_Target { float4 v = {{1, 2}, {3, 4}}; return v * i.uv.x; }");
    EXPECT_THAT(Disassemble(pass->fragmentSpirv),
                HasSubstr("OpConstantComposite %v4float %float_1 %float_2 %float_3 %float_4"));
}

TEST(HlslDialect, RefusesListsInListsWithNothingInThem)
{
    EXPECT_THAT(
        test::CompileMessages(test::Program(
            k_Vertex + "float4 frag(v2f i) : SV_Target { float4 v = {{}, {3, 4}}; return v; }")),
        ElementsAre(test::Mentions("error: '{'", "empty")));
}

TEST(HlslDialect, TakesConstantObjects)
{
    const auto pass = CompileFragment(R"(
        uniform const sampler2D _T; const uniform samplerCUBE _C;
        const Texture2D<float4> _U; const SamplerState sampler_U;
        const StructuredBuffer<float4> _B;
        float4 Read(const sampler2D t, const in float2 uv) { return tex2D(t, uv); }
        float4 frag(v2f i) : SV_Target
        {
            const float scale = 2;
            return Read(_T, i.uv) + _U.Sample(sampler_U, i.uv) * scale + _B[0]
                + texCUBE(_C, i.uv.xyx);
        })");
    EXPECT_EQ(pass->layout.textures.size(), 3u);
    EXPECT_EQ(pass->layout.samplers.size(), 1u);
    EXPECT_EQ(pass->layout.storageBuffers.size(), 1u);
}

TEST(HlslDialect, GathersCompareFourTexels)
{
    const std::string declared = "Texture2D _Map; Texture2DArray _Maps; SamplerComparisonState "
                                 "sampler_Map; float4 Of(Texture2D map, SamplerComparisonState s, "
                                 "float2 uv) { return map.GatherCmp(s, uv, 0.25); }";
    for (const std::string call :
         {"_Map.GatherCmp(sampler_Map, i.uv, 0.25)", "_Map.GatherCmpRed(sampler_Map, i.uv, 0.25)",
          "_Map.GatherCmp(sampler_Map, i.uv, 0.25, int2(1, 0))",
          "_Maps.GatherCmp(sampler_Map, i.uv.xyx, 0.25)", "Of(_Map, sampler_Map, i.uv)"})
    {
        SCOPED_TRACE(call);
        const auto pass =
            CompileFragment(declared + "float4 frag(v2f i) : SV_Target { return " + call + "; }");
        const std::string text = Disassemble(pass->fragmentSpirv);
        EXPECT_THAT(text, HasSubstr("OpImageDrefGather %v4float"));
        EXPECT_THAT(text, HasSubstr("%float_0_25 ConstOffset"));
    }
}

TEST(HlslDialect, ComparesTexturesThatAreHandedOnAsWell)
{
    const std::string declared = "Texture2D _Map; SamplerComparisonState sampler_Map;\n";
    const std::string take = "float Take(Texture2D map, SamplerComparisonState s, float2 uv) "
                             "{ return map.SampleCmpLevelZero(s, uv, 0.25); }\n";
    const std::string compare =
        "float Compare(float2 uv) { return _Map.SampleCmpLevelZero(sampler_Map, uv, 0.5); }\n";
    const std::string fragment = "float4 frag(v2f i) : SV_Target { Texture2D own = _Map; return "
                                 "Take(_Map, sampler_Map, i.uv) + Compare(i.uv) + "
                                 "own.SampleCmpLevelZero(sampler_Map, i.uv, 0.75); }";
    for (const std::string& functions : {take + compare, compare + take})
    {
        SCOPED_TRACE(functions);
        const auto pass = CompileFragment(declared + functions + fragment);
        EXPECT_EQ(pass->layout.textures.size(), 1u);
        const std::string text = Disassemble(pass->fragmentSpirv);
        EXPECT_THAT(text, HasSubstr("%float_0_25"));
        EXPECT_THAT(text, HasSubstr("%float_0_5"));
        EXPECT_THAT(text, HasSubstr("%float_0_75"));
    }
}

TEST(HlslDialect, RefusesGathersThatCannotCompare)
{
    EXPECT_THAT(
        test::CompileMessages(test::Program(
            k_Vertex + "TextureCube _Sky;\nTexture2D _Map;\nSamplerComparisonState sampler_Map;\n"
                       "float4 frag(v2f i) : SV_Target\n{\n"
                       "float4 a = _Sky.GatherCmp(sampler_Map, float3(0, 1, 0), 0.5);\n"
                       "return a + _Map.GatherCmpGreen(sampler_Map, i.uv, 0.5);\n}")),
        ElementsAre(test::Mentions("'GatherCmp'", "a cube", "'SampleCmpLevelZero'"),
                    test::Mentions("'GatherCmpGreen'", "first component", "'GatherCmpRed'")));
}

TEST(HlslDialect, RefusesTexturesOfOneDimension)
{
    EXPECT_THAT(test::CompileMessages(test::Program(
                    k_Vertex + "Texture1D _T;\nSamplerState sampler_T;\nfloat4 frag(v2f i) : "
                               "SV_Target { return _T.Sample(sampler_T, i.uv.x); }")),
                ElementsAre(test::Mentions("t.shader:1:1: error: '_T'", "2D, 3D and cube")));
}

} // namespace
} // namespace limn
