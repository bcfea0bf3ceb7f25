#include "Mentions.h"
#include "hlsl/DialectTestSupport.h"

#include <limn/shaderlab/UnsupportedProgramError.h>

#include <gmock/gmock.h>

// What Unity's compilers take and glslang by itself does not, beyond what HlslDialectTest has.

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using namespace test;

/// What `frag`, called with the interpolated uv, samples: constants are folded, so that the
/// coordinates stand in the text.
std::string Disassembled(const std::string& declarations, const std::string& expression)
{
    const auto pass = CompileFragment(declarations + " float4 frag(v2f i) : SV_Target { return " +
                                      expression + "; }");
    return Disassemble(pass->fragmentSpirv);
}

TEST(HlslOldForms, ProjectsByTheLastCoordinate)
{
    // (3, 4) / 8
    const std::string coordinates = "OpConstantComposite %v2float %float_0_375 %float_0_5";
    EXPECT_THAT(Disassembled("sampler2D _A;", "tex2Dproj(_A, float3(3, 4, 8))"),
                HasSubstr(coordinates));
    EXPECT_THAT(Disassembled("sampler2D _A;", "tex2Dproj(_A, float4(3, 4, 2, 8))"),
                HasSubstr(coordinates));
    EXPECT_THAT(Disassembled("samplerCUBE _A;", "texCUBEproj(_A, float4(3, 4, 2, 8))"),
                HasSubstr("OpConstantComposite %v3float %float_0_375 %float_0_5 %float_0_25"));
}

TEST(HlslOldForms, TakesVectorAndMatrixInAnyCase)
{
    const auto pass = CompileFragment(R"(
        Vector _Point;
        Matrix _Turn;
        float4 frag(v2f i) : SV_Target { return mul(_Turn, _Point); })");
    std::map<std::string, UniformType> types;
    for (const UniformBuffer& buffer : pass->layout.buffers)
    {
        for (const UniformMember& member : buffer.members)
        {
            types[member.name] = member.type;
        }
    }
    EXPECT_EQ(types.at("_Point"), UniformType::Float);
    EXPECT_EQ(types.at("_Turn"), UniformType::Matrix4x4);
    const auto own = CompileFragment(R"(
        struct Vector { float2 place; };
        float4 frag(v2f i) : SV_Target { Vector a; a.place = i.uv; return a.place.xyxy; })");
    EXPECT_TRUE(own) << "no type of the language";
}

TEST(HlslOldForms, TakesTexturesOfOneDimensionForRowsOfTwo)
{
    const auto pass = CompileFragment(R"(
        sampler1D _R;
        float4 frag(v2f i) : SV_Target { return tex1D(_R, i.uv.x) * tex1D(_R, i.uv); })");
    ASSERT_EQ(pass->layout.textures.size(), 1u);
    EXPECT_EQ(pass->layout.textures[0].dimension, TextureDimension::Tex2D);
    EXPECT_TRUE(pass->layout.textures[0].combinedSampler);
    const std::string row = "OpConstantComposite %v[23]float %float_0_375 %float_0_5";
    for (const std::string call :
         {"tex1D(_R, 0.375)", "tex1D(_R, 0.375, i.uv.x, 0)", "tex1Dgrad(_R, 0.375, 0, i.uv.x)",
          "tex1Dlod(_R, float4(0.375, 7, 7, 2))", "tex1Dbias(_R, float4(0.375, 7, 7, 2))",
          "tex1Dproj(_R, float2(3, 8))", "tex1Dproj(_R, float4(3, 7, 7, 8))"})
    {
        SCOPED_TRACE(call);
        EXPECT_THAT(Disassembled("sampler1D _R;", call), testing::ContainsRegex(row));
    }
    EXPECT_THAT(Disassembled("sampler1D _R;", "tex1Dlod(_R, float4(0.375, 7, 7, 2))"),
                HasSubstr("Lod %float_2"));
    EXPECT_THAT(Disassembled("sampler1D _R;", "tex1Dbias(_R, float4(0.375, 7, 7, 2))"),
                HasSubstr("Bias %float_2"));
}

TEST(HlslOldForms, TakesSamplersAsParameters)
{
    const auto pass = CompileFragment(R"(
        float4 Read(sampler2D t, float2 uv) { return tex2Dproj(t, uv.xyxy) + tex2Dlod(t, 0); }
        float4 Uniform(uniform sampler2D t, uniform float2 uv) { return tex2D(t, uv); }
        float4 Cube(in samplerCUBE t, float3 n) { return texCUBE(t, n); }
        sampler2D _A; samplerCUBE _C;
        float4 frag(v2f i) : SV_Target
        {
            return Read(_A, i.uv) + Uniform(_A, i.uv) + Cube(_C, i.uv.xyx);
        })");
    EXPECT_EQ(pass->layout.textures.size(), 2u);
}

TEST(HlslOldForms, TakesTypeNamesForNames)
{
    CompileFragment(R"(
        struct s { float sampler : float4; float2 texture : TEXCOORD1; float matrix : texture; };
        struct Lamp { float3 Lamp; };
        float f(float vector, Lamp Lamp) { return vector + Lamp.Lamp.x; }
        float4 frag(v2f i) : SV_Target
        {
            Lamp l; l.Lamp = (vector)3;
            s a; a.sampler = 1; a.texture = i.uv; a.matrix = 2;
            float texture = 1, layout = 2, string = 3; matrix m = 1; vector v = f(texture, l);
            return a.sampler + a.texture.x + a.matrix + texture * layout * string + m[0] + v
                + f(1, l);
        })");
}

TEST(HlslOldForms, CarriesSemanticsThatAreTypeNames)
{
    const auto pass = CompileValid(R"(
        struct v2f { float4 pos : SV_POSITION; float4 c : float4; float2 t : texture; };
        v2f vert(float4 p : POSITION) { v2f o; o.pos = p; o.c = 1; o.t = 2; return o; }
        float4 frag(v2f i) : SV_Target { return i.c * i.t.x; })");
    EXPECT_THAT(Disassemble(pass->vertexSpirv), HasSubstr("Location 1"));
}

TEST(HlslOldForms, SetsRowMajorUniformsAsOthers)
{
    const auto pass = CompileFragment(R"(
        row_major float4x4 _M; column_major float4x4 _N;
        cbuffer B { row_major float4x4 _O; }
        float4 Row(row_major float4x4 m) { row_major float4x4 k = m; return k[0]; }
        float4 frag(v2f i) : SV_Target { return Row(_M) + Row(_N) + Row(_O); })");
    EXPECT_EQ(Member(*pass, "_M").type, UniformType::Matrix4x4);
    EXPECT_EQ(Member(*pass, "_O").type, UniformType::Matrix4x4);
}

TEST(HlslOldForms, MakesUniformParametersOfEntryFunctionsUniforms)
{
    const auto pass = CompileValid(R"(
        float4 vert(uniform float4 shift, float4 p : POSITION) : SV_POSITION { return p + shift; }
        float Twice(uniform float x) { return x + x; }
        float4 frag(uniform float4 shift, uniform sampler2D tex : TEXUNIT0, float4 p : VPOS,
                    uniform float2 scale[2]) : SV_Target
        {
            return tex2D(tex, p.xy * scale[1]) * (Twice(shift.x) + Twice(2)); // of an integer too
        })");
    EXPECT_EQ(Member(*pass, "shift").components, 4);
    EXPECT_EQ(Member(*pass, "scale").arraySize, 2);
    ASSERT_EQ(pass->layout.textures.size(), 1u);
    EXPECT_EQ(pass->layout.textures[0].name, "tex");
    CompileValid("float4 vert(float4 p : POSITION, uniform float k) : SV_POSITION { return p * k; "
                 "} float4 frag(uniform float4 c) : SV_Target { return c; }");
}

TEST(HlslOldForms, ReadsOverSamplerStatesWithAWarning)
{
    const auto pass = CompileHlsl(k_Vertex + R"(texture _T; Texture _U; texture2D _V;
        sampler2D _A = sampler_state { Texture = <_T>; MinFilter = Linear; };
        sampler _B : register(s1) = sampler_state { Texture = (_T); };
        SamplerState _S : register(s2) { Filter = MIN_MAG_MIP_LINEAR; AddressU = Wrap; };
        float4 frag(v2f i) : SV_Target
        {
            return tex2D(_A, i.uv) + tex2D(_B, i.uv) + _V.Sample(_S, i.uv);
        })");
    EXPECT_THAT(Messages(pass->diagnostics),
                ElementsAre(test::Mentions("8:19: warning: '_A'", "no effect", "SamplerState"),
                            test::Mentions("9:17: warning: '_B'", "no effect", "SamplerState"),
                            test::Mentions("10:22: warning: '_S'", "no effect", "SamplerState")));
    EXPECT_EQ(pass->layout.textures.size(), 3u);
    ASSERT_EQ(pass->layout.samplers.size(), 1u);
    EXPECT_EQ(pass->layout.samplers[0].name, "_S");
}

TEST(HlslOldForms, GivesStructsTheMembersOfTheirBase)
{
    const auto pass = CompileValid(R"(
        struct base { float4 pos : SV_POSITION; };
        struct middle : base { float2 uv : TEXCOORD0; float Sum() { return uv.x + uv.y; } };
        struct v2f : middle { float3 n : NORMAL; };
        v2f vert(float4 p : POSITION, float2 uv : TEXCOORD0)
        {
            v2f o; o.pos = p; o.uv = uv; o.n = 1; return o;
        }
        float4 frag(v2f i) : SV_Target { return i.n.xyzz * i.Sum() * i.uv.x; })");
    EXPECT_THAT(Disassemble(pass->vertexSpirv), HasSubstr("BuiltIn Position"));
}

TEST(HlslOldForms, ReadsTypedBuffersAsStructuredOnes)
{
    const auto pass = CompileValid(R"(
        Buffer<float4> _P; Buffer<uint> _I; Buffer _V;
        float4 vert(uint id : SV_VertexID) : SV_POSITION { return _P[_I[id]] + _V.Load(id); }
        float4 frag() : SV_Target { return 1; })");
    std::map<std::string, std::uint32_t> strides;
    for (const StorageBufferBinding& buffer : pass->layout.storageBuffers)
    {
        strides[buffer.name] = buffer.stride;
    }
    EXPECT_THAT(strides, ElementsAre(testing::Pair("_I", 4u), testing::Pair("_P", 16u),
                                     testing::Pair("_V", 16u)));
}

TEST(HlslOldForms, RefusesTexturesAndBuffersThatItWouldWriteTo)
{
    const std::pair<std::string, std::string> declarations[] = {
        {"RWStructuredBuffer", "RWStructuredBuffer<float4> _B; void Use() { _B[0] = 1; }"},
        {"RWTexture2D",
         "RWTexture2D<float4> _B : register(u1); void Use() { _B[uint2(0, 0)] = 1; }"},
        {"AppendStructuredBuffer",
         "AppendStructuredBuffer<float4> _B; void Use() { _B.Append(1); }"},
        {"RWByteAddressBuffer", "RWByteAddressBuffer _B; void Use() { _B.Store(0, 1); }"},
    };
    for (const auto& [type, code] : declarations)
    {
        SCOPED_TRACE(type);
        const std::string program = k_Vertex + code + "\nfloat4 frag(v2f i) : SV_Target ";
        // What no function of the stage uses does no harm.
        CompileValid(program + "{ return 1; }");
        try
        {
            CompileHlsl(program + "{ Use(); return 1; }");
            FAIL();
        }
        catch (const UnsupportedProgramError& error)
        {
            ASSERT_EQ(error.diagnostics().size(), 1u);
            EXPECT_THAT(error.diagnostics()[0].message,
                        test::Mentions("'_B'", type, "written to", "compute shaders"));
            EXPECT_EQ(error.diagnostics()[0].location.line, 7);
            EXPECT_GT(error.diagnostics()[0].location.column, 1);
        }
    }
}

TEST(HlslOldForms, LetsMacrosBeDefinedAnewWithAWarning)
{
    const auto pass = CompileHlsl(k_Vertex + R"(#define A(x) 0.125
        #define A(x, y) (x + y * 2)
        #define B 7
        #define B 7
        #define UNITY_SAMPLE_DEPTH(name) 0.375
        float4 frag(v2f i) : SV_Target { return float4(A(0.25, 0.125), UNITY_SAMPLE_DEPTH(a), B, 1); })",
                                  ProgramLanguage::Cg);
    EXPECT_THAT(Messages(pass->diagnostics),
                ElementsAre(test::Mentions("8:17: warning: 'A'", "#define", "another meaning"),
                            test::Mentions("11:17: warning: 'UNITY_SAMPLE_DEPTH'", "#define",
                                           "another meaning")));
    EXPECT_THAT(Disassemble(pass->fragmentSpirv),
                HasSubstr("%v4float %float_0_5 %float_0_375 %float_7 %float_1"));
    // A mistake elsewhere is still one.
    EXPECT_THAT(CompileMessages(Program(k_Vertex + "#define A 1\n#define A 2\n#if 1\n")),
                testing::Contains(HasSubstr(": error: ")));
}

TEST(HlslOldForms, CutsArgumentsOfSeveralFunctionsAndOfThoseDefinedLater)
{
    CompileFragment(R"(
        float Later(float3x3 m);
        float Rest(float x, inout float y) { y = x; return x; }
        float4 Read(Texture2D<float4> t, SamplerState s, float2 uv, float k, float a[2])
        {
            return t.Sample(s, uv) * k * a[1];
        }
        Texture2D _A; SamplerState sampler_A;
        float4 frag(v2f i) : SV_Target
        {
            float y; float k[2] = { 1, 2 };
            return Later(unity_ObjectToWorld) + Rest(i.uv, y) + Read(_A, sampler_A, i.uv, i.uv, k);
        }
        float Later(float3x3 m) { return m[0].x; })");
}

TEST(HlslOldForms, SaysWhatIsWrongWhereAnArgumentDoesNotFitEither)
{
    EXPECT_THAT(CompileMessages(Program(k_Vertex + R"(float f(float3x3 m) { return m[0].x; }
        float4 frag(v2f i) : SV_Target { return f(i.uv) + f((float4x4)1); })")),
                ElementsAre(test::Mentions("t.shader:8:49: error: 'f'", "no matching")));
}

} // namespace
} // namespace limn
