#include "Mentions.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"
#include "core/ThrownMessage.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::CompileHlsl;
using test::Mentions;
using testing::HasSubstr;
using testing::Not;

constexpr const char* k_Core =
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n";

void ExpectValid(const ShaderProgram& pass)
{
    EXPECT_EQ(test::ValidationMessages(pass.vertexSpirv), "");
    EXPECT_EQ(test::ValidationMessages(pass.fragmentSpirv), "");
}

TEST(ShaderLibrary, FindsPerDrawDataByInstanceInTheVertexStage)
{
    const auto pass = CompileHlsl(k_Core + std::string(R"(
        float4 vert(float4 p : POSITION) : SV_Position { return mul(unity_ObjectToWorld, p); }
        float4 frag() : SV_Target { return 1; })"));
    ExpectValid(*pass);
    const std::string text = test::Disassemble(pass->vertexSpirv);
    EXPECT_THAT(text, HasSubstr("BuiltIn InstanceIndex"));
    EXPECT_THAT(text, Not(HasSubstr("PushConstant")));
    EXPECT_THAT(text, HasSubstr("ArrayStride 160"));
    EXPECT_THAT(text, HasSubstr("OpMemberDecorate %limn_PerDrawData 0 RowMajor"));
    std::vector<StorageBufferBinding> buffers = pass->layout.storageBuffers;
    std::ranges::sort(buffers, {}, &StorageBufferBinding::name);
    ASSERT_EQ(buffers.size(), 2u);
    EXPECT_EQ(buffers[0].name, "limn_Instances");
    EXPECT_EQ(buffers[0].stride, sizeof(std::uint32_t));
    EXPECT_EQ(buffers[1].name, "limn_PerDraw");
    EXPECT_EQ(buffers[1].stride, sizeof(PerDrawData));
    EXPECT_EQ(buffers[0].stages, ShaderStage::Vertex);
    EXPECT_EQ(buffers[1].stages, ShaderStage::Vertex);
    EXPECT_TRUE(pass->layout.buffers.empty());
}

TEST(ShaderLibrary, FindsPerDrawDataByPushConstantInTheFragmentStage)
{
    const auto pass = CompileHlsl(k_Core + std::string(R"(
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag() : SV_Target { return EncodeMeshRenderingLayer(GetMeshRenderingLayer()); })"));
    ExpectValid(*pass);
    const std::string text = test::Disassemble(pass->fragmentSpirv);
    EXPECT_THAT(text, HasSubstr("PushConstant"));
    EXPECT_THAT(text, HasSubstr("OpMemberDecorate %limn_PushConstants 0 Offset 0"));
    EXPECT_EQ(pass->layout.storageBuffers.at(0).stages, ShaderStage::Fragment);
    EXPECT_THAT(test::Disassemble(pass->vertexSpirv), Not(HasSubstr("InstanceIndex")));
}

TEST(ShaderLibrary, SharesTheInstanceWithAnAuthorWhoReadsItToo)
{
    const auto pass = CompileHlsl(k_Core + std::string(R"(
        struct a { float4 p : POSITION; uint id : SV_InstanceID; };
        float4 vert(a v, uint again : SV_InstanceID) : SV_Position
        { return TransformObjectToHClip(v.p.xyz) * v.id * again; }
        float4 frag() : SV_Target { return 1; })"));
    ExpectValid(*pass);
    const std::string text = test::Disassemble(pass->vertexSpirv);
    const std::size_t first = text.find("BuiltIn InstanceIndex");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(text.find("BuiltIn InstanceIndex", first + 1), std::string::npos);
}

TEST(ShaderLibrary, LaysThePerDrawDataOutAsTheProgramDoes)
{
    const auto pass = CompileHlsl(k_Core + std::string(R"(
        float4 vert(float4 p : POSITION) : SV_Position
        {
            return mul(unity_ObjectToWorld, p) + mul(unity_WorldToObject, p)
                + unity_WorldTransformParams + GetMeshRenderingLayer();
        }
        float4 frag() : SV_Target { return 1; })"));
    const std::string text = test::Disassemble(pass->vertexSpirv);
    const std::size_t offsets[] = {
        offsetof(PerDrawData, objectToWorld), offsetof(PerDrawData, worldToObject),
        offsetof(PerDrawData, worldTransformParams), offsetof(PerDrawData, renderingLayer)};
    for (std::size_t i = 0; i < 4; ++i)
    {
        EXPECT_THAT(text, HasSubstr("OpMemberDecorate %limn_PerDrawData " + std::to_string(i) +
                                    " Offset " + std::to_string(offsets[i])));
    }
}

TEST(ShaderLibrary, CompilesALitShader)
{
    const auto pass = CompileHlsl(R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
        CBUFFER_START(UnityPerMaterial)
        half4 _BaseColor; float4 _BaseMap_ST;
        CBUFFER_END
        TEXTURE2D(_BaseMap); SAMPLER(sampler_BaseMap);
        struct Attributes
        {
            float4 positionOS : POSITION; float3 normalOS : NORMAL; float4 tangentOS : TANGENT;
            float2 uv : TEXCOORD0; UNITY_VERTEX_INPUT_INSTANCE_ID
        };
        struct Varyings
        {
            float4 positionCS : SV_POSITION; float2 uv : TEXCOORD0; float3 normalWS : TEXCOORD1;
            float3 positionWS : TEXCOORD2; float fog : TEXCOORD3; UNITY_VERTEX_OUTPUT_STEREO
        };
        Varyings vert(Attributes input)
        {
            Varyings output = (Varyings)0;
            UNITY_SETUP_INSTANCE_ID(input);
            UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output);
            VertexPositionInputs position = GetVertexPositionInputs(input.positionOS.xyz);
            VertexNormalInputs normal = GetVertexNormalInputs(input.normalOS, input.tangentOS);
            output.positionCS = position.positionCS;
            output.positionWS = position.positionWS;
            output.normalWS = normal.normalWS;
            output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
            output.fog = ComputeFogFactor(position.positionCS.z);
            return output;
        }
        half4 frag(Varyings input) : SV_Target
        {
            half4 albedo = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv) * _BaseColor;
            AlphaDiscard(albedo.a, 0.5);
            albedo.a = AlphaDiscard(albedo.a, 0.5);
            Light light = GetMainLight();
            half3 diffuse = LightingLambert(light.color, light.direction, input.normalWS);
            half3 viewDir = GetWorldSpaceNormalizeViewDir(input.positionWS);
            half3 shine = LightingSpecular(light.color, light.direction, input.normalWS, viewDir, 1, 8);
            half3 color = albedo.rgb * (diffuse + SampleSH(input.normalWS)) + shine;
            return half4(MixFog(color, input.fog), albedo.a);
        })");
    ExpectValid(*pass);
    std::vector<std::string> buffers;
    for (const UniformBuffer& buffer : pass->layout.buffers)
    {
        buffers.push_back(buffer.name);
    }
    EXPECT_THAT(buffers, testing::UnorderedElementsAre("limn_PerCamera", "UnityPerMaterial",
                                                       "limn_PerFrameLighting"));
}

TEST(ShaderLibrary, CompilesAFullScreenPassThatNeedsNoCamera)
{
    const auto pass = CompileHlsl(k_Core + std::string(R"(
        #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
        Varyings vert(Attributes input) { return Vert(input); }
        half4 frag(Varyings input) : SV_Target
        {
            UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);
            return Luminance(
                SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, input.texcoord, 0));
        })"));
    ExpectValid(*pass);
    EXPECT_TRUE(pass->layout.vertexInputs.empty());
    EXPECT_TRUE(pass->layout.storageBuffers.empty());
    ASSERT_EQ(pass->layout.buffers.size(), 1u);
    EXPECT_EQ(pass->layout.buffers[0].name, "$Global");
    EXPECT_EQ(pass->layout.samplers.at(0).name, "sampler_LinearClamp");
}

TEST(ShaderLibrary, CompilesTheSceneTexturesAndPositionsFromDepth)
{
    ExpectValid(*CompileHlsl(R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareNormalsTexture.hlsl"
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareOpaqueTexture.hlsl"
        #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
        Varyings vert(Attributes input) { return Vert(input); }
        float4 frag(Varyings input) : SV_Target
        {
            float2 uv = GetNormalizedScreenSpaceUV(input.positionCS);
            float depth = SampleSceneDepth(uv);
            float3 world = ComputeWorldSpacePosition(uv, depth, UNITY_MATRIX_I_VP);
            return float4(SampleSceneColor(uv) + SampleSceneNormals(uv) + world,
                          LinearEyeDepth(depth, _ZBufferParams) + Linear01Depth(depth, _ZBufferParams));
        })"));
}

TEST(ShaderLibrary, CompilesProgramsOfTheBuiltInPipeline)
{
    const auto pass = CompileHlsl(R"(
        #include "UnityCG.cginc"
        #include "Lighting.cginc"
        sampler2D _MainTex; float4 _MainTex_ST; fixed4 _Color;
        struct v2f { float4 pos : SV_POSITION; half2 uv : TEXCOORD0; fixed3 n : NORMAL; UNITY_FOG_COORDS(2) };
        v2f vert(appdata_full v)
        {
            v2f o;
            UNITY_INITIALIZE_OUTPUT(v2f, o);
            o.pos = UnityObjectToClipPos(v.vertex);
            o.pos.xy += TransformViewToProjection(normalize(mul((float3x3)UNITY_MATRIX_IT_MV, v.normal)).xy);
            o.uv = TRANSFORM_TEX(v.texcoord, _MainTex);
            o.n = UnityObjectToWorldNormal(v.normal);
            UNITY_TRANSFER_FOG(o, o.pos);
            return o;
        }
        fixed4 frag(v2f i, fixed face : VFACE) : COLOR
        {
            fixed4 c = tex2D(_MainTex, i.uv) * _Color;
            c.rgb *= saturate(dot(i.n, _WorldSpaceLightPos0.xyz)) * _LightColor0.rgb * face;
            UNITY_APPLY_FOG(i.fogCoord, c);
            return c + UNITY_LIGHTMODEL_AMBIENT;
        })",
                                  ProgramLanguage::Cg);
    ExpectValid(*pass);
    EXPECT_TRUE(pass->layout.textures.at(0).combinedSampler);
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("BuiltIn FrontFacing"));
}

TEST(ShaderLibrary, IsIncludedByCgProgramsWithoutASay)
{
    const auto pass = CompileHlsl("float4 vert(float4 p : POSITION) : SV_Position { return "
                                  "mul(UNITY_MATRIX_MVP, p); }\n"
                                  "fixed4 frag() : SV_Target { return _Time; }",
                                  ProgramLanguage::Cg);
    ExpectValid(*pass);
    EXPECT_EQ(pass->layout.buffers.at(0).name, "limn_PerCamera");
    EXPECT_EQ(pass->layout.buffers.at(0).stages, ShaderStage::Both);
}

TEST(ShaderLibrary, GivesWayToThePackagesOfTheUser)
{
    test::TemporaryFolder folder;
    folder.Write("pkg/ShaderLibrary/Core.hlsl", "#include \"More.hlsl\"\n");
    folder.Write("pkg/ShaderLibrary/More.hlsl", "#pragma once\nfloat4 Mine() { return 1; }\n");
    ShaderCompiler compiler(
        {{}, {{"com.unity.render-pipelines.universal", folder.path() / "pkg"}}, {}});
    const auto pass = compiler.Compile(test::Program(
        k_Core + std::string("#include_with_pragmas \"Packages\\com.unity.render-pipelines."
                             "universal\\ShaderLibrary\\More.hlsl\"\n"
                             "float4 vert(float4 p : POSITION) : SV_Position { return Mine(); }\n"
                             "float4 frag() : SV_Target { return 1; }")));
    ExpectValid(*pass);
}

TEST(ShaderLibrary, SaysWhichWayRoundDepthIs)
{
    for (const bool isReversed : {true, false})
    {
        ShaderCompilerOptions options;
        options.usesReversedZBuffer = isReversed;
        ShaderCompiler compiler(options);
        EXPECT_EQ(compiler.usesReversedZBuffer(), isReversed);
        const std::string other =
            isReversed ? "!defined(UNITY_REVERSED_Z)" : "defined(UNITY_REVERSED_Z)";
        const std::string near = isReversed ? "1" : "0";
        // An array of -1 elements does not compile.
        EXPECT_NO_THROW(compiler.Compile(
            test::Program(k_Core + std::string("#if ") + other +
                          "\n#error the other way round\n#endif\n"
                          "static const int n[UNITY_NEAR_CLIP_VALUE == " +
                          near +
                          " ? 1 : -1] = {0};\n"
                          "static const int f[UNITY_RAW_FAR_CLIP_VALUE == " +
                          near +
                          " ? -1 : 1] = {0};\n"
                          "float4 vert(float4 p : POSITION) : SV_Position { return n[0] + f[0]; }\n"
                          "float4 frag() : SV_Target { return 1; }")));
    }
}

TEST(ShaderLibrary, RefusesAPackageThatReversesZInAnyCase)
{
    ShaderCompilerOptions options;
    options.usesReversedZBuffer = false;
    options.packages["com.unity.render-pipelines.core"] = "pkg";
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { ShaderCompiler{options}; }),
                Mentions("ShaderCompilerOptions", "usesReversedZBuffer is false",
                         "com.unity.render-pipelines.core", " pkg,"));
}

TEST(ShaderLibrary, FindsAssetsFromTheProjectRoot)
{
    test::TemporaryFolder folder;
    folder.Write("Assets/a.hlsl", "float4 Mine() { return 1; }\n");
    ShaderCompiler compiler({{}, {}, folder.path()});
    const auto pass = compiler.Compile(
        test::Program("#include \"Assets/a.hlsl\"\n"
                      "float4 vert(float4 p : POSITION) : SV_Position { return Mine(); }\n"
                      "float4 frag() : SV_Target { return 1; }"));
    ExpectValid(*pass);
}

} // namespace
} // namespace limn
