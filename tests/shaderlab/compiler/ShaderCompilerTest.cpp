#include "Mentions.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"
#include "core/ThrownMessage.h"

#include <gmock/gmock.h>

#include <thread>

namespace limn
{
namespace
{

using test::CompileHlsl;
using test::Mentions;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

constexpr const char* k_FragmentOnly = "float4 frag() : SV_Target { return 1; }\n";

void ExpectValid(const ShaderProgram& pass)
{
    EXPECT_EQ(test::ValidationMessages(pass.vertexSpirv), "");
    EXPECT_EQ(test::ValidationMessages(pass.fragmentSpirv), "");
}

TEST(ShaderCompiler, MakesSpirv13WithTheEntryPointMain)
{
    const auto pass = CompileHlsl("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n" +
                                  std::string(k_FragmentOnly));
    ExpectValid(*pass);
    EXPECT_EQ(pass->vertexSpirv.at(1), 0x00010300u);
    EXPECT_THAT(test::Disassemble(pass->vertexSpirv),
                HasSubstr("OpEntryPoint Vertex %main \"main\""));
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv),
                HasSubstr("OpEntryPoint Fragment %main \"main\""));
}

TEST(ShaderCompiler, LeavesOutFunctionsThatOnlyTheOtherStageCanHave)
{
    const auto pass = CompileHlsl(R"(
        sampler2D _MainTex;
        struct v2f { float4 pos : SV_POSITION; float2 uv : TEXCOORD0; };
        v2f vert(float4 p : POSITION) { v2f o; o.pos = p; o.uv = p.xy; return o; }
        float edge(float2 uv) { clip(uv.x); return fwidth(uv.x); }
        float4 frag(v2f i) : SV_Target { return tex2D(_MainTex, i.uv) * edge(i.uv); })");
    ExpectValid(*pass);
    EXPECT_EQ(pass->layout.textures.at(0).stages, ShaderStage::Fragment);
}

TEST(ShaderCompiler, TakesTheOldPositionAndColorSemanticsOfStructs)
{
    const auto pass = CompileHlsl(R"(
        struct v2f { float4 pos : POSITION; float4 color : COLOR; };
        struct target { float4 color : COLOR0; float4 extra : COLOR1; float depth : DEPTH; };
        v2f vert(float4 p : POSITION, float4 c : COLOR) { v2f o; o.pos = p; o.color = c; return o; }
        target frag(v2f i) { target o; o.color = i.color; o.extra = 1; o.depth = .5; return o; })");
    ExpectValid(*pass);
    EXPECT_THAT(test::Disassemble(pass->vertexSpirv), HasSubstr("BuiltIn Position"));
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("BuiltIn FragDepth"));
    EXPECT_EQ(pass->layout.colorOutputs, 2);
}

TEST(ShaderCompiler, TakesTheOldSemanticsOfOutParametersAndResults)
{
    const auto pass = CompileHlsl(R"(
        void vert(float4 p : POSITION, out float4 pos : POSITION, out float2 uv : TEXCOORD0)
        { pos = p; uv = p.xy; }
        void frag(float2 uv : TEXCOORD0, out half4 color : COLOR) { color = uv.xyxy; })");
    ExpectValid(*pass);
    EXPECT_THAT(test::Disassemble(pass->vertexSpirv), HasSubstr("BuiltIn Position"));
    EXPECT_EQ(pass->layout.colorOutputs, 1);
    const auto result = CompileHlsl("float4 vert(float4 p : POSITION) : POSITION { return p; }\n"
                                    "float4 frag() : COLOR { return 1; }");
    ExpectValid(*result);
    EXPECT_THAT(test::Disassemble(result->vertexSpirv), HasSubstr("BuiltIn Position"));
}

TEST(ShaderCompiler, MatchesVaryingsBySemanticAndNotByOrder)
{
    const auto pass = CompileHlsl(R"(
        struct v2f { float4 pos : SV_Position; float2 a : TEXCOORD0; float3x3 m : TEXCOORD4;
                     float4 b[2] : TEXCOORD1; nointerpolation uint id : ID; };
        v2f vert(float4 p : POSITION)
        { v2f o; o.pos = p; o.a = p.xy; o.b[0] = p; o.b[1] = p * 2; o.m = 1; o.id = 3; return o; }
        float4 frag(uint id : ID, float4 b1 : TEXCOORD2, float3 row : TEXCOORD6, float4 at : VPOS)
            : SV_Target
        { return b1 * row.x + id + at; })");
    ExpectValid(*pass);
    // In the order of the vertex function's struct: a 0, rows of m 1...3, b 4 and 5, id 6.
    const std::string text = test::Disassemble(pass->fragmentSpirv);
    EXPECT_THAT(text, HasSubstr("Location 6"));
    EXPECT_THAT(text, HasSubstr("Location 5"));
    EXPECT_THAT(text, HasSubstr("Location 3"));
    EXPECT_THAT(text, HasSubstr("Flat"));
    EXPECT_THAT(text, HasSubstr("BuiltIn FragCoord"));
    EXPECT_THAT(text, Not(HasSubstr("Location 4")));
}

TEST(ShaderCompiler, TakesOneStructForInputAndOutputTypedefsAndAFunctionCalledMain)
{
    const auto pass = CompileHlsl(R"(
        typedef float4 vec4; typedef vec4 color;
        struct io { vec4 p : POSITION; float2 uv : TEXCOORD0; };
        io vert(io i) { io o = i; return o; }
        color main(io i, bool front : SV_IsFrontFace) : SV_Target { return front ? i.uv.xyxy : i.p; }
        color frag(io i, bool front : SV_IsFrontFace) : SV_Target { return main(i, front); })");
    ExpectValid(*pass);
    EXPECT_EQ(pass->layout.vertexInputs.size(), 2u);
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("BuiltIn FragCoord"));
}

TEST(ShaderCompiler, TakesStructsInStructsAndParametersThatGoInAndOut)
{
    const auto pass = CompileHlsl(R"(
        struct Inner { float4 a : TEXCOORD1; float3 b : TEXCOORD2; };
        struct v2f { float4 pos : SV_Position; Inner inner; };
        struct Out { half3 a : SV_Target0; half4 b : SV_Target2; };
        v2f vert(float4 p : POSITION, inout float2 uv : TEXCOORD0)
        { v2f o; o.pos = p; o.inner.a = p; o.inner.b = p.xyz; uv *= 2; return o; }
        void frag(v2f i, float2 uv : TEXCOORD0, out Out o, out float depth : SV_Depth)
        { o.a = i.inner.b; o.b = i.inner.a * uv.x; depth = 0.5; })");
    ExpectValid(*pass);
    EXPECT_EQ(pass->layout.colorOutputs, 3); // targets 0 and 2: 1 has to be there
}

TEST(ShaderCompiler, WidensAVaryingThatTheFragmentFunctionReadsWider)
{
    const auto pass = CompileHlsl(R"(
        void vert(float4 p : POSITION, out float4 pos : SV_Position, out float2 uv : TEXCOORD0)
        { pos = p; uv = p.xy; }
        float4 frag(float4 uv : TEXCOORD0) : SV_Target { return uv; })");
    ExpectValid(*pass);
    EXPECT_THAT(test::Disassemble(pass->vertexSpirv),
                ContainsRegex("CompositeConstruct %v4float .* %float_0 %float_0"));
}

TEST(ShaderCompiler, LetsTheCodeAssignToUniforms)
{
    const auto pass = CompileHlsl(R"(
        cbuffer UnityPerMaterial { float4 _Color; float _Width; };
        float _Loose[2];
        float Scale() { return _Width; }
        float4 vert(float4 p : POSITION) : SV_Position
        {
            _Width = _Width * 2;
            _Color.xy += 1;
            _Loose[1]++;
            return p * Scale() * _Loose[1] + _Color;
        }
        float4 frag() : SV_Target { return _Color; })");
    ExpectValid(*pass);
    ASSERT_EQ(pass->layout.buffers.size(), 2u);
    EXPECT_EQ(pass->layout.buffers.at(0).members.at(1).name, "_Width");
    EXPECT_EQ(pass->layout.buffers.at(0).stages, ShaderStage::Both);
    EXPECT_EQ(pass->layout.buffers.at(1).name, "$Global");
}

TEST(ShaderCompiler, FillsTheCopyOfAnAssignedUniformAgainForEveryInvocation)
{
    // _Width is multiplied once: the value written is 2 * uniform, with one load of the uniform.
    const auto pass = CompileHlsl(R"(
        cbuffer C { float _Width; };
        float4 vert(float4 p : POSITION) : SV_Position { _Width *= 2; return p * _Width; }
        float4 frag() : SV_Target { return 1; })");
    const std::string text = test::Disassemble(pass->vertexSpirv);
    EXPECT_THAT(text, ContainsRegex("FMul %float %[0-9]+ %float_2"));
    EXPECT_THAT(text, Not(HasSubstr("Private")));
}

TEST(ShaderCompiler, LetsTheCodeAssignToUniformsOfTemplateTypes)
{
    const auto pass = CompileHlsl(R"(
        vector<float, 3> _Offset;
        matrix<float, 3, 2> _Table[2];
        float4 vert(float4 p : POSITION) : SV_Position
        {
            _Offset.x += 1;
            _Table[1][2][1] = p.x;
            return float4(_Offset, _Table[1][2][1]);
        }
        float4 frag() : SV_Target { return 1; })");
    ExpectValid(*pass);
    ASSERT_EQ(pass->layout.buffers.size(), 1u);
    EXPECT_EQ(pass->layout.buffers.at(0).members.at(0).name, "_Offset");
}

TEST(ShaderCompiler, LetsFunctionsUseWhatTheAuthorDeclaresBeforeTheLibraryDoes)
{
    for (const char* declaration : {"float4 unity_OrthoParams;",
                                    "cbuffer Author { float4 _Other; float4 unity_OrthoParams; };"})
    {
        const auto pass = CompileHlsl(std::string(declaration) + R"(
            bool isFlat() { return unity_OrthoParams.w == 1.0; }
            #include "UnityCG.cginc"
            float4 vert(float4 p : POSITION) : SV_Position { return UnityObjectToClipPos(p); }
            float4 frag() : SV_Target { return isFlat() ? _Time : unity_OrthoParams; })");
        ExpectValid(*pass);
        std::vector<std::string> owners;
        for (const auto& buffer : pass->layout.buffers)
        {
            for (const auto& member : buffer.members)
            {
                if (member.name == "unity_OrthoParams")
                {
                    owners.push_back(buffer.name);
                }
            }
        }
        EXPECT_EQ(owners.size(), 1u) << declaration << ": limn feeds the library's alone";
        EXPECT_THAT(owners, testing::Each(testing::StartsWith("limn_"))) << declaration;
    }
}

TEST(ShaderCompiler, TakesElementsOfStaticTextureArraysForTheTexturesThatTheyName)
{
    const auto texturesOf = [](const std::string& expression)
    {
        const auto pass = CompileHlsl(R"(
            Texture2D _A; Texture2D _B; Texture2D _C; SamplerState sampler_A;
            static const int k_Third = 2;
            static Texture2D All[3] = { _A, _B, _C, };
            static Texture2D One = _B, Other = _C;
            float4 Read(Texture2D map, float2 uv) { return map.Sample(sampler_A, uv); }
            float4 vert(float4 p : POSITION) : SV_Position { return p; }
            float4 frag(float4 p : SV_Position) : SV_Target { return )" +
                                      expression + "; }");
        ExpectValid(*pass);
        std::vector<std::string> names;
        for (const TextureBinding& texture : pass->layout.textures)
        {
            names.push_back(texture.name);
        }
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(Names{"_A"}, texturesOf("All[0].Sample(sampler_A, p.xy)"));
    EXPECT_EQ(Names{"_B"}, texturesOf("All[(2 - 1)].Load(int3(0, 0, 0))"));
    EXPECT_EQ(Names{"_C"}, texturesOf("Read(All[k_Third], p.xy)"));
    EXPECT_EQ(Names{"_B"}, texturesOf("One.Sample(sampler_A, p.xy)"));
    EXPECT_EQ(Names{"_C"}, texturesOf("Read(Other, p.xy)"));
}

TEST(ShaderCompiler, DoesNotTakeALocalOfTheSameNameForTheUniform)
{
    const auto pass = CompileHlsl(R"(
        float _Width;
        float4 vert(float4 p : POSITION) : SV_Position { float _Width = 3; _Width += 1; return _Width; }
        float4 frag() : SV_Target { return 1; })");
    ExpectValid(*pass);
    EXPECT_TRUE(pass->layout.buffers.empty());
}

TEST(ShaderCompiler, LetsTheStructOfBothFunctionsHaveAPointSize)
{
    const auto pass = test::CompileHlsl(R"(
        struct v2f { float4 pos : SV_POSITION; float size : PSIZE; };
        v2f vert(float4 p : POSITION) { v2f o; o.pos = p; o.size = 4; return o; }
        float4 frag(v2f i) : SV_Target { return 1; })");
    ExpectValid(*pass);
    EXPECT_TRUE(pass->diagnostics.empty());
    EXPECT_THAT(test::Disassemble(pass->vertexSpirv), HasSubstr("BuiltIn PointSize"));
}

TEST(ShaderCompiler, DefinesKeywordsAndStagesAsMacros)
{
    PassProgram program = test::Program(R"(
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        #if defined(SHADER_STAGE_FRAGMENT) && SHADER_TARGET == 35 && UNITY_VERSION >= 202230
        #if FANCY == 1
        float4 frag() : SV_Target0 { return 1; }
        #else
        void frag(out float4 a : SV_Target0, out float4 b : SV_Target1) { a = 1; b = 2; }
        #endif
        #endif
        #if defined(SHADER_STAGE_VERTEX) && defined(SHADER_API_VULKAN)
        float4 frag() { return 1; }
        #endif)");
    program.target = 35;
    // The vertex stage declares another function of the name; its signature does not matter.
    ShaderCompiler compiler;
    const std::vector<std::string> keywords = {"FANCY"};
    program.chunks[0].text.replace(program.chunks[0].text.find("float4 frag() { return 1; }"), 27,
                                   "float4 frag() : SV_Target { return 1; }");
    EXPECT_EQ(compiler.Compile(program, keywords)->layout.colorOutputs, 1);
    EXPECT_EQ(compiler.Compile(program)->layout.colorOutputs, 2);
}

TEST(ShaderCompiler, ComputesWithFullPrecisionInHalf)
{
    const auto pass = CompileHlsl(R"(
        half4 _A;
        half4 vert(half4 p : POSITION) : SV_Position { return p * _A; }
        half4 frag() : SV_Target { return _A; })");
    ExpectValid(*pass);
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), Not(HasSubstr("RelaxedPrecision")));
}

TEST(ShaderCompiler, MakesRealHalvesWhereTheDeviceHasThem)
{
    ShaderCompilerOptions options;
    options.halfIs16Bit = true;
    const auto pass = ShaderCompiler(options).Compile(test::Program(R"(
        half4 _A;
        struct V { float4 p : SV_Position; half2 uv : TEXCOORD0; };
        V vert(half4 p : POSITION) { V v; v.p = p * _A; v.uv = p.xy * _A.y; return v; }
        half4 frag(V v) : SV_Target { return _A * _A + v.uv.x; })"));
    ExpectValid(*pass);
    const std::string text = test::Disassemble(pass->fragmentSpirv);
    EXPECT_THAT(text, HasSubstr("OpCapability Float16"));
    EXPECT_THAT(text, Not(HasSubstr("StorageInputOutput16")));
    EXPECT_EQ(pass->layout.buffers.at(0).members.at(0).size, 16u) << "a float4 as ever";
    options.missingFeatures = {"native16bit"};
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { ShaderCompiler{options}; }),
                Mentions("ShaderCompilerOptions", "halfIs16Bit is true", "native16bit",
                         "shaderFloat16", "shaderInt16"));
}

TEST(ShaderCompiler, CompilesForSeveralThreadsAtOnce)
{
    ShaderCompiler compiler;
    const PassProgram program =
        test::Program("float4 vert(float4 p : POSITION) : SV_Position { return p; }\n" +
                      std::string(k_FragmentOnly));
    const auto expected = compiler.Compile(program);
    std::vector<std::shared_ptr<const ShaderProgram>> results(4);
    std::vector<std::thread> threads;
    for (auto& result : results)
    {
        threads.emplace_back([&] { result = compiler.Compile(program); });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    for (const auto& result : results)
    {
        EXPECT_EQ(*result, *expected);
    }
    EXPECT_EQ(compiler.statistics().compiled, 5);
}

} // namespace
} // namespace limn
