#include "Mentions.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <gmock/gmock.h>

#include <set>

namespace limn
{
namespace
{

using test::CompileHlsl;
using test::Mentions;

constexpr const char* k_Vertex = "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n";

const UniformMember& Member(const UniformBuffer& buffer, const std::string& name)
{
    for (const UniformMember& member : buffer.members)
    {
        if (member.name == name)
        {
            return member;
        }
    }
    throw ContractError("no member " + name);
}

TEST(PropertyLayout, PacksAConstantBufferByTheRulesOfHlsl)
{
    const auto pass = CompileHlsl(std::string(k_Vertex) + R"(
        cbuffer UnityPerMaterial
        {
            float a;      // 0
            float3 b;     // 4: fills the first 16 bytes
            float2 c;     // 16
            float3 d;     // 32: would cross a border of 16 bytes
            int e;        // 44
            float4x4 m;   // 48
            float f[3];   // 112: each element starts 16 bytes
            float g;      // 160: glslang fills nothing up behind an array or matrix
            float3x3 n;   // 176: three columns
            uint2 h;      // 224
        };
        float4 frag() : SV_Target { return a + b.x + c.x + d.x + e + m._m00 + f[1] + g + n._m00 + h.x; })");
    ASSERT_EQ(pass->layout.buffers.size(), 1u);
    const UniformBuffer& buffer = pass->layout.buffers[0];
    EXPECT_EQ(buffer.name, "UnityPerMaterial");
    EXPECT_EQ(buffer.stages, ShaderStage::Fragment);
    EXPECT_EQ(Member(buffer, "a"), (UniformMember{"a", UniformType::Float, 1, 0, 4, 0, 0}));
    EXPECT_EQ(Member(buffer, "b"), (UniformMember{"b", UniformType::Float, 3, 4, 12, 0, 0}));
    EXPECT_EQ(Member(buffer, "c"), (UniformMember{"c", UniformType::Float, 2, 16, 8, 0, 0}));
    EXPECT_EQ(Member(buffer, "d").offset, 32u);
    EXPECT_EQ(Member(buffer, "e"), (UniformMember{"e", UniformType::Int, 1, 44, 4, 0, 0}));
    EXPECT_EQ(Member(buffer, "m"), (UniformMember{"m", UniformType::Matrix4x4, 4, 48, 64, 0, 0}));
    EXPECT_EQ(Member(buffer, "f").offset, 112u);
    EXPECT_EQ(Member(buffer, "f").arraySize, 3);
    EXPECT_EQ(Member(buffer, "f").arrayStride, 16u);
    EXPECT_EQ(Member(buffer, "n").components, 3);
    EXPECT_EQ(Member(buffer, "n").arraySize, 3);
    EXPECT_EQ(Member(buffer, "n").arrayStride, 16u);
    EXPECT_EQ(Member(buffer, "h").type, UniformType::UInt);
    EXPECT_EQ(Member(buffer, "g").offset, 160u);
    EXPECT_EQ(Member(buffer, "n").offset, 176u);
    EXPECT_EQ(Member(buffer, "h").offset, 224u);
    EXPECT_EQ(buffer.size, 240u);
}

TEST(PropertyLayout, SharesEqualResourcesOfBothStages)
{
    const auto pass = CompileHlsl(R"(
        cbuffer UnityPerMaterial { float4 _Color; };
        cbuffer VertexOnly { float4 _V; };
        float _Loose;
        Texture2D _Tex; SamplerState sampler_Tex;
        float4 vert(float4 p : POSITION) : SV_Position
        { return p * _Color + _V + _Tex.SampleLevel(sampler_Tex, p.xy, 0) * _Loose; }
        float4 frag() : SV_Target { return _Color + _Tex.SampleLevel(sampler_Tex, 0, 0) * _Loose; })");
    const PropertyLayout& layout = pass->layout;
    ASSERT_EQ(layout.buffers.size(), 3u);
    std::map<std::string, ShaderStage> stages;
    std::set<std::uint32_t> bindings = {layout.textures.at(0).binding,
                                        layout.samplers.at(0).binding};
    for (const UniformBuffer& buffer : layout.buffers)
    {
        stages[buffer.name] = buffer.stages;
        bindings.insert(buffer.binding);
    }
    EXPECT_EQ(stages["UnityPerMaterial"], ShaderStage::Both);
    EXPECT_EQ(stages["VertexOnly"], ShaderStage::Vertex);
    EXPECT_EQ(stages["$Global"], ShaderStage::Both);
    EXPECT_EQ(layout.textures[0].stages, ShaderStage::Both);
    EXPECT_EQ(layout.samplers[0].stages, ShaderStage::Both);
    EXPECT_EQ(bindings, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(PropertyLayout, WritesItsBindingsIntoTheSpirv)
{
    const auto pass = CompileHlsl(R"(
        cbuffer A : register(b0) { float4 _A; };
        Texture2D _Tex : register(t0); SamplerState sampler_Tex : register(s0);
        float4 vert(float4 p : POSITION) : SV_Position { return p * _A; }
        float4 frag() : SV_Target { return _Tex.Sample(sampler_Tex, 0); })");
    const std::string text = test::Disassemble(pass->fragmentSpirv);
    EXPECT_EQ(pass->layout.buffers.at(0).binding, 0u);
    EXPECT_THAT(text, testing::HasSubstr("%_Tex Binding " +
                                         std::to_string(pass->layout.textures.at(0).binding)));
    EXPECT_THAT(text, testing::HasSubstr("%sampler_Tex Binding " +
                                         std::to_string(pass->layout.samplers.at(0).binding)));
    EXPECT_THAT(text, testing::HasSubstr("%_Tex DescriptorSet 0"));
    EXPECT_NE(pass->layout.textures[0].binding, pass->layout.samplers[0].binding);
    EXPECT_NE(pass->layout.textures[0].binding, 0u);
}

TEST(PropertyLayout, SplitsABufferThatTheStagesDeclareDifferently)
{
    const auto pass = CompileHlsl(R"(
        #ifdef SHADER_STAGE_VERTEX
        float _VertexOnly;
        #endif
        float _Both;
        float4 vert(float4 p : POSITION) : SV_Position { return p * _VertexOnly * _Both; }
        float4 frag() : SV_Target { return _Both; })");
    const auto& buffers = pass->layout.buffers;
    ASSERT_EQ(buffers.size(), 2u);
    EXPECT_EQ(buffers[0].name, "$Global");
    EXPECT_EQ(buffers[1].name, "$Global");
    EXPECT_EQ(buffers[0].members.size(), 2u);
    EXPECT_EQ(buffers[1].members.size(), 1u);
    EXPECT_NE(buffers[0].binding, buffers[1].binding);
}

TEST(PropertyLayout, HoldsOnlyWhatTheFunctionsUse)
{
    const auto pass = CompileHlsl(R"(
        cbuffer Unused { float4 _U; };
        Texture2D _UnusedTex; SamplerState sampler_UnusedTex;
        struct a { float4 p : POSITION; float3 n : NORMAL; float4 t : TANGENT; float2 uv : TEXCOORD0; };
        float4 helper() { return _U; }
        float4 vert(a v) : SV_Position { return v.p + v.uv.x; }
        float4 frag() : SV_Target { return 1; })");
    EXPECT_TRUE(pass->layout.buffers.empty());
    EXPECT_TRUE(pass->layout.textures.empty());
    EXPECT_TRUE(pass->layout.samplers.empty());
    ASSERT_EQ(pass->layout.vertexInputs.size(), 2u);
    EXPECT_EQ(pass->layout.vertexInputs[0], (VertexInput{"POSITION", 0, UniformType::Float, 4}));
    EXPECT_EQ(pass->layout.vertexInputs[1], (VertexInput{"TEXCOORD0", 4, UniformType::Float, 2}));
}

TEST(PropertyLayout, NamesVertexInputsByUpperCaseSemanticWithIndex)
{
    const auto pass = CompileHlsl(R"(
        float4 vert(float3 p : Position, float3 n : NORMAL0, float4 c : COLOR, float2 a : texcoord,
                    float2 b : TEXCOORD3, uint id : SV_VertexID, uint4 bones : BLENDINDICES)
            : SV_Position
        { return float4(p + n, 1) + c + a.x + b.x + id + bones; }
        float4 frag() : SV_Target { return 1; })");
    std::vector<std::string> semantics;
    for (const VertexInput& input : pass->layout.vertexInputs)
    {
        semantics.push_back(input.semantic);
    }
    EXPECT_THAT(semantics, testing::ElementsAre("POSITION", "NORMAL", "COLOR", "TEXCOORD0",
                                                "TEXCOORD3", "BLENDINDICES"));
    EXPECT_EQ(pass->layout.vertexInputs.at(5).type, UniformType::UInt);
    EXPECT_EQ(pass->layout.vertexInputs.at(0).components, 3);
}

TEST(PropertyLayout, TellsTheKindsOfTexturesAndSamplersApart)
{
    const auto pass = CompileHlsl(std::string(k_Vertex) + R"(
        sampler2D _Old; samplerCUBE _OldCube;
        Texture2D _A; Texture3D _B; TextureCube _C; Texture2DArray _D; TextureCubeArray _E;
        Texture2DMS<float4> _F; Texture2D _Shadow;
        SamplerState sampler_A; SamplerComparisonState sampler_Shadow;
        float4 frag() : SV_Target
        {
            return tex2D(_Old, 0) + texCUBE(_OldCube, 1) + _A.Sample(sampler_A, 0)
                + _B.Sample(sampler_A, 0) + _C.Sample(sampler_A, 1) + _D.Sample(sampler_A, 0)
                + _E.Sample(sampler_A, 1) + _F.Load(int2(0, 0), 0)
                + _Shadow.SampleCmpLevelZero(sampler_Shadow, 0, 0);
        })");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    std::map<std::string, TextureBinding> textures;
    for (const TextureBinding& texture : pass->layout.textures)
    {
        textures[texture.name] = texture;
    }
    EXPECT_EQ(textures.size(), 9u);
    EXPECT_TRUE(textures["_Old"].combinedSampler);
    EXPECT_EQ(textures["_OldCube"].dimension, TextureDimension::Cube);
    EXPECT_FALSE(textures["_A"].combinedSampler);
    EXPECT_EQ(textures["_A"].dimension, TextureDimension::Tex2D);
    EXPECT_EQ(textures["_B"].dimension, TextureDimension::Tex3D);
    EXPECT_EQ(textures["_C"].dimension, TextureDimension::Cube);
    EXPECT_EQ(textures["_D"].dimension, TextureDimension::Tex2DArray);
    EXPECT_EQ(textures["_E"].dimension, TextureDimension::CubeArray);
    EXPECT_TRUE(textures["_F"].multisampled);
    ASSERT_EQ(pass->layout.samplers.size(), 2u);
    for (const SamplerBinding& sampler : pass->layout.samplers)
    {
        EXPECT_EQ(sampler.comparison, sampler.name == "sampler_Shadow") << sampler.name;
    }
}

TEST(PropertyLayout, PassesTexturesThroughFunctionParameters)
{
    const auto pass = CompileHlsl(std::string(k_Vertex) + R"(
        Texture2D _A; SamplerState sampler_A;
        float4 Read(Texture2D t, SamplerState s, float2 uv) { return t.Sample(s, uv); }
        float4 frag() : SV_Target { return Read(_A, sampler_A, 0); })");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    EXPECT_EQ(pass->layout.textures.at(0).name, "_A");
}

TEST(PropertyLayout, StoresMatricesInColumnsAsTheyAreMultiplied)
{
    // SPIR-V sees HLSL's rows as columns: a RowMajor decoration means that memory holds the columns
    // of the HLSL matrix, which is how GLM stores them. mul(M, v) is then v * M.
    const auto pass = CompileHlsl(R"(
        cbuffer C { float4x4 _M; };
        float4 vert(float4 p : POSITION) : SV_Position { return mul(_M, p); }
        float4 frag() : SV_Target { return float4(_M._m11, _M._m03, 0, 0); })");
    const std::string vertex = test::Disassemble(pass->vertexSpirv);
    EXPECT_THAT(vertex, testing::HasSubstr("OpMemberDecorate %C 0 RowMajor"));
    EXPECT_THAT(vertex, testing::HasSubstr("OpMemberDecorate %C 0 MatrixStride 16"));
    EXPECT_THAT(vertex, testing::HasSubstr("OpVectorTimesMatrix"));
    EXPECT_THAT(vertex, testing::Not(testing::HasSubstr("OpTranspose")));
    // _m03 is row 0, column 3: SPIR-V column 0, component 3. RowMajor puts that at byte
    // 3 * 16 + 0 * 4, which is glm's M[3][0].
    const std::string fragment = test::Disassemble(pass->fragmentSpirv);
    EXPECT_THAT(fragment, testing::ContainsRegex("OpAccessChain %_ptr_Uniform_float %_ %int_0 "
                                                 "%int_0 %(u?int)_3"));
    EXPECT_THAT(fragment, testing::ContainsRegex("OpAccessChain %_ptr_Uniform_float %_ %int_0 "
                                                 "%int_1 %(u?int)_1"));
}

TEST(PropertyLayout, RefusesMatricesThatItCannotUpload)
{
    EXPECT_THAT(test::CompileMessages(test::Program(
                    std::string(k_Vertex) + "struct S { row_major float4x4 m; };\n"
                                            "cbuffer C { S _S; };\n"
                                            "float4 frag() : SV_Target { return _S.m[0]; }")),
                testing::ElementsAre(Mentions("t.shader:1:1: error: C: '_S.m'", "row_major")));
}

TEST(PropertyLayout, RefusesBuffersThatAreTooLargeBeforeTheyTakeMemory)
{
    // 64 KiB is the most; 268435457 vectors have 16 bytes if they are counted in 32 bits, and so
    // has each of the arrays of arrays.
    const auto program = [](const std::string& members, const std::string& read)
    {
        return std::string(k_Vertex) + "struct S { float x; }; struct A { float x[65536]; };\n" +
               "cbuffer C { " + members + " };\nfloat4 frag() : SV_Target { return " + read + "; }";
    };
    EXPECT_EQ(CompileHlsl(program("float4 _A[4096];", "_A[1]"))->layout.buffers.at(0).size, 65536u);
    for (const auto& [members, read] :
         {std::pair("float4 _A[4096]; float _B;", "_A[1]"),
          std::pair("float _A[60000000];", "_A[1]"), std::pair("float _A[268435457];", "_A[1]"),
          std::pair("float _A[2147483647];", "_A[1]"),
          std::pair("float _A[65536][65536];", "_A[1][1]"), std::pair("S _S[60000000];", "_S[1].x"),
          std::pair("A _S[4096];", "_S[1].x[1]")})
    {
        EXPECT_THAT(test::CompileMessages(test::Program(program(members, read))),
                    testing::ElementsAre(Mentions("t.shader:1:1: error: constant buffer 'C'",
                                                  "65536 bytes", "StructuredBuffer")))
            << members;
    }
}

} // namespace
} // namespace limn
