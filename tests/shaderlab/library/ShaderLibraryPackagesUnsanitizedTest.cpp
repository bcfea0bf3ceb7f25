#include "Paths.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <algorithm>
#include <gmock/gmock.h>

// The packages that shaders of the Universal Render Pipeline include.

namespace limn
{
namespace
{

using test::CompileHlsl;

constexpr const char* k_Universal = "Packages/com.unity.render-pipelines.universal/";

/// Every file of the library below a folder, as it is included.
std::vector<std::string> Headers(const std::string& folder)
{
    const std::filesystem::path root = test::SourcePath("shaderlab/library");
    std::vector<std::string> headers;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
    {
        if (entry.is_regular_file())
        {
            headers.push_back(entry.path().lexically_relative(root).generic_string());
        }
    }
    std::sort(headers.begin(), headers.end());
    return headers;
}

/// A program whose functions have nothing to do with what is included.
std::string Idle(const std::string& includes)
{
    return includes + "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                      "float4 frag() : SV_Target { return 1; }\n";
}

struct PassFiles
{
    const char* input; ///< file with the properties
    const char* pass;
    const char* vertex;
    const char* fragment;
};

constexpr PassFiles k_Passes[] = {
    {"LitInput", "LitForwardPass", "LitPassVertex", "LitPassFragment"},
    {"LitInput", "ShadowCasterPass", "ShadowPassVertex", "ShadowPassFragment"},
    {"LitInput", "DepthOnlyPass", "DepthOnlyVertex", "DepthOnlyFragment"},
    {"LitInput", "LitDepthNormalsPass", "DepthNormalsVertex", "DepthNormalsFragment"},
    {"LitInput", "LitGBufferPass", "LitGBufferPassVertex", "LitGBufferPassFragment"},
    {"LitInput", "LitMetaPass", "UniversalVertexMeta", "UniversalFragmentMetaLit"},
    {"SimpleLitInput", "SimpleLitForwardPass", "LitPassVertexSimple", "LitPassFragmentSimple"},
    {"SimpleLitInput", "SimpleLitDepthNormalsPass", "DepthNormalsVertex", "DepthNormalsFragment"},
    {"SimpleLitInput", "SimpleLitGBufferPass", "LitPassVertexSimple", "LitPassFragmentSimple"},
    {"SimpleLitInput", "SimpleLitMetaPass", "UniversalVertexMeta", "UniversalFragmentMetaSimple"},
    {"UnlitInput", "UnlitForwardPass", "UnlitPassVertex", "UnlitPassFragment"},
    {"UnlitInput", "DepthNormalsPass", "DepthNormalsVertex", "DepthNormalsFragment"},
    {"UnlitInput", "UnlitDepthNormalsPass", "DepthNormalsVertex", "DepthNormalsFragment"},
    {"UnlitInput", "UnlitMetaPass", "UniversalVertexMeta", "UniversalFragmentMetaUnlit"},
    {"UnlitInput", "Utils/Universal2D", "vert", "frag"},
    {"BakedLitInput", "BakedLitForwardPass", "BakedLitForwardPassVertex",
     "BakedLitForwardPassFragment"},
    {"BakedLitInput", "BakedLitDepthNormalsPass", "DepthNormalsVertex", "DepthNormalsFragment"},
    {"BakedLitInput", "BakedLitMetaPass", "UniversalVertexMeta", "UniversalFragmentMetaBakedLit"},
};

/// Compiles all passes of URP's own shaders and expects valid SPIR-V.
void ExpectPassesCompile(const std::vector<std::string>& keywords)
{
    ShaderCompiler compiler;
    for (const PassFiles& files : k_Passes)
    {
        SCOPED_TRACE(files.pass);
        const std::string folder = std::string(k_Universal) + "Shaders/";
        PassProgram program = test::Program(test::IncludeOf(folder + files.input + ".hlsl") +
                                            test::IncludeOf(folder + files.pass + ".hlsl"));
        program.vertex.name = files.vertex;
        program.fragment.name = files.fragment;
        const auto pass = compiler.Compile(program, keywords);
        EXPECT_EQ(test::ValidationMessages(pass->vertexSpirv), "");
        EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    }
}

TEST(ShaderLibraryPackages, CanBeIncludedFileByFile)
{
    for (const char* folder :
         {"Packages/com.unity.render-pipelines.core", "Packages/com.unity.postprocessing",
          "Packages/com.unity.render-pipelines.universal/ShaderLibrary",
          "Packages/com.unity.render-pipelines.universal/Shaders/PostProcessing",
          "Packages/com.unity.shadergraph/ShaderGraphLibrary"})
    {
        for (const std::string& header : Headers(folder))
        {
            SCOPED_TRACE(header);
            EXPECT_NO_THROW(CompileHlsl(Idle(test::IncludeOf(header))));
        }
    }
}

TEST(ShaderLibraryPackages, CanBeIncludedTogether)
{
    std::string all;
    for (const char* folder : {"Packages/com.unity.render-pipelines.core/ShaderLibrary",
                               "Packages/com.unity.render-pipelines.universal/ShaderLibrary"})
    {
        for (const std::string& header : Headers(folder))
        {
            all += header.find("UniversalMetaPass") == std::string::npos ? test::IncludeOf(header)
                                                                         : "";
        }
    }
    EXPECT_NO_THROW(CompileHlsl(Idle(all)));
    EXPECT_NO_THROW(CompileHlsl(Idle(all + all)));
}

TEST(ShaderLibraryPackages, CompileThePassesOfUnitysShadersByDefault)
{
    ExpectPassesCompile({});
}

TEST(ShaderLibraryPackages, CompileThePassesOfUnitysShadersWithAllMapsAndLights)
{
    ExpectPassesCompile({"_NORMALMAP", "_EMISSION", "_METALLICSPECGLOSSMAP", "_OCCLUSIONMAP",
                         "_PARALLAXMAP", "_DETAIL_MULX2", "_CLEARCOATMAP", "_ALPHATEST_ON",
                         "_ADDITIONAL_LIGHTS", "_MAIN_LIGHT_SHADOWS_CASCADE", "_SHADOWS_SOFT",
                         "_SCREEN_SPACE_OCCLUSION", "_LIGHT_LAYERS", "FOG_EXP2", "_FOG_FRAGMENT",
                         "_SPECGLOSSMAP", "LOD_FADE_CROSSFADE"});
}

TEST(ShaderLibraryPackages, CompileThePassesOfUnitysShadersWithTheOtherWorkflow)
{
    ExpectPassesCompile({"_SPECULAR_SETUP", "_ADDITIONAL_LIGHTS_VERTEX", "_MAIN_LIGHT_SHADOWS",
                         "FOG_LINEAR", "_SPECULAR_COLOR", "_CLEARCOAT", "_DETAIL_SCALED",
                         "EVALUATE_SH_MIXED", "_ALPHAMODULATE_ON", "_CASTING_PUNCTUAL_LIGHT_SHADOW",
                         "_SPECULARHIGHLIGHTS_OFF", "_SURFACE_TYPE_TRANSPARENT",
                         "_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A", "_GLOSSINESS_FROM_BASE_ALPHA"});
}

TEST(ShaderLibraryPackages, CompileAToonShaderWithAllLights)
{
    PassProgram program = test::Program(R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
        TEXTURE2D(_RampMap); SAMPLER(sampler_RampMap);
        CBUFFER_START(UnityPerMaterial)
        half4 _Tint; half _RimPower; half _Steps;
        CBUFFER_END
        struct Attributes
        {
            float4 positionOS : POSITION; float3 normalOS : NORMAL; float2 lightmapUV : TEXCOORD1;
            UNITY_VERTEX_INPUT_INSTANCE_ID
        };
        struct Varyings
        {
            float4 positionCS : SV_POSITION; float3 positionWS : TEXCOORD0;
            half3 normalWS : TEXCOORD1; DECLARE_LIGHTMAP_OR_SH(lightmapUV, vertexSH, 2);
            UNITY_VERTEX_INPUT_INSTANCE_ID UNITY_VERTEX_OUTPUT_STEREO
        };
        Varyings vert(Attributes input)
        {
            Varyings output;
            ZERO_INITIALIZE(Varyings, output);
            UNITY_SETUP_INSTANCE_ID(input);
            UNITY_TRANSFER_INSTANCE_ID(input, output);
            output.positionWS = TransformObjectToWorld(input.positionOS.xyz);
            output.positionCS = TransformWorldToHClip(output.positionWS);
            output.normalWS = TransformObjectToWorldNormal(input.normalOS);
            OUTPUT_LIGHTMAP_UV(input.lightmapUV, unity_LightmapST, output.lightmapUV);
            OUTPUT_SH(output.normalWS, output.vertexSH);
            return output;
        }
        half Band(half x) { return floor(x * _Steps) / max(_Steps, HALF_MIN); }
        half4 frag(Varyings input) : SV_Target
        {
            UNITY_SETUP_INSTANCE_ID(input);
            float4 shadowCoord = TransformWorldToShadowCoord(input.positionWS);
            Light mainLight = GetMainLight(shadowCoord, input.positionWS, half4(1, 1, 1, 1));
            half3 gi = SAMPLE_GI(input.lightmapUV, input.vertexSH, input.normalWS);
            MixRealtimeAndBakedGI(mainLight, input.normalWS, gi, half4(0, 0, 0, 0));
            half ndl = saturate(dot(input.normalWS, mainLight.direction));
            half3 ramp = SAMPLE_TEXTURE2D_LOD(_RampMap, sampler_RampMap, half2(ndl, 0.5), 0).rgb;
            half3 light = mainLight.color * ramp * mainLight.shadowAttenuation + gi;
            #ifdef _ADDITIONAL_LIGHTS
            uint count = GetAdditionalLightsCount();
            LIGHT_LOOP_BEGIN(count)
                Light extra = GetAdditionalLight(lightIndex, input.positionWS);
                if (IsMatchingLightLayer(extra.layerMask, GetMeshRenderingLayer()))
                {
                    light += extra.color * Band(extra.distanceAttenuation);
                }
            LIGHT_LOOP_END
            #endif
            half3 viewDir = SafeNormalize(GetCameraPositionWS() - input.positionWS);
            half rim = pow(1.0 - saturate(dot(viewDir, input.normalWS)), _RimPower);
            return half4(light * _Tint.rgb + rim, 1);
        })");
    ShaderCompiler compiler;
    const std::vector<std::string> keywords = {"_ADDITIONAL_LIGHTS", "_MAIN_LIGHT_SHADOWS"};
    const auto pass = compiler.Compile(program, keywords);
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    EXPECT_EQ(pass->layout.textures.size(), 2u); // the ramp and the shadow map
}

TEST(ShaderLibraryPackages, TakeInstancedPropertiesWithAndWithoutASemicolon)
{
    const auto pass =
        CompileHlsl(test::IncludeOf(std::string(k_Universal) + "ShaderLibrary/Core.hlsl") + R"(
        UNITY_INSTANCING_BUFFER_START(Props)
            UNITY_DEFINE_INSTANCED_PROP(float4, _Tint)
            UNITY_DEFINE_INSTANCED_PROP(float, _Width);
        UNITY_INSTANCING_BUFFER_END(Props)
        struct v2f { float4 p : SV_POSITION; UNITY_VERTEX_INPUT_INSTANCE_ID };
        v2f vert(float4 p : POSITION)
        {
            v2f o;
            o.p = p * UNITY_ACCESS_INSTANCED_PROP(Props, _Width);
            return o;
        }
        float4 frag(v2f i) : SV_Target
        {
            UNITY_SETUP_INSTANCE_ID(i);
            return UNITY_ACCESS_INSTANCED_PROP(Props, _Tint);
        })");
    ASSERT_EQ(pass->layout.buffers.size(), 1u);
    EXPECT_EQ(pass->layout.buffers[0].members.size(), 2u);
}

TEST(ShaderLibraryPackages, CompileAnEffectOfThePostProcessingStack)
{
    PassProgram program = test::Program(R"(
        #include "Packages/com.unity.postprocessing/PostProcessing/Shaders/Colors.hlsl"
        TEXTURE2D_SAMPLER2D(_MainTex, sampler_MainTex);
        TEXTURE2D_SAMPLER2D(_CameraDepthTexture, sampler_CameraDepthTexture);
        float _Blend;
        float4 Frag(VaryingsDefault i) : SV_Target
        {
            float4 color = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, i.texcoord);
            float depth = Linear01Depth(
                SAMPLE_DEPTH_TEXTURE(_CameraDepthTexture, sampler_CameraDepthTexture, i.texcoordStereo));
            float3 hsv = RgbToHsv(SafeHDR(color.rgb));
            color.rgb = lerp(LinearToSRGB(HsvToRgb(hsv)), Luminance(color).xxx, _Blend * depth);
            return color;
        })");
    program.vertex.name = "VertDefault";
    program.fragment.name = "Frag";
    ShaderCompiler compiler;
    const auto pass = compiler.Compile(program);
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    ASSERT_EQ(pass->layout.vertexInputs.size(), 1u);
    EXPECT_EQ(pass->layout.vertexInputs[0].semantic, "POSITION");
}

TEST(ShaderLibraryPackages, AddTheMipBiasOnlyInTheUniversalPipeline)
{
    const auto sample = [](const std::string& header)
    {
        return CompileHlsl(test::IncludeOf(header) + R"(
            TEXTURE2D(_Map); SAMPLER(sampler_Map);
            float4 vert(float4 p : POSITION) : SV_Position { return p; }
            float4 frag(float4 p : SV_Position) : SV_Target
            { return SAMPLE_TEXTURE2D(_Map, sampler_Map, p.xy); })");
    };
    const auto core = sample("Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl");
    EXPECT_TRUE(core->layout.buffers.empty());
    const auto universal = sample(std::string(k_Universal) + "ShaderLibrary/Core.hlsl");
    ASSERT_EQ(universal->layout.buffers.size(), 1u);
    EXPECT_EQ(universal->layout.buffers[0].name, "limn_PerCamera");
}

TEST(ShaderLibraryPackages, WriteFourTargetsInADeferredPass)
{
    ShaderCompiler compiler;
    const std::string folder = std::string(k_Universal) + "Shaders/";
    PassProgram program = test::Program(test::IncludeOf(folder + "SimpleLitInput.hlsl") +
                                        test::IncludeOf(folder + "SimpleLitGBufferPass.hlsl"));
    program.vertex.name = "LitPassVertexSimple";
    program.fragment.name = "LitPassFragmentSimple";
    EXPECT_EQ(compiler.Compile(program)->layout.colorOutputs, 4);
}

TEST(ShaderLibraryPackages, BringColorsProbesAndOldNamesWithTheLighting)
{
    const auto pass =
        CompileHlsl(test::IncludeOf(std::string(k_Universal) + "ShaderLibrary/Lighting.hlsl") +
                    R"(
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            half3 mirrored = BoxProjectedCubemapDirection(
                p.xyz, p.xyz, unity_SpecCube0_ProbePosition, unity_SpecCube0_BoxMin,
                unity_SpecCube0_BoxMax);
            half shadow = ApplyShadowFade(0.5, p.xyz);
            mirrored += TransformTangentToWorld(p.xyz, UNITY_MATRIX_M);
            return float4(HsvToRgb(RgbToHsv(mirrored)), Luminance(p.rgb) * shadow)
                * kDieletricSpec;
        })");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
}

TEST(ShaderLibraryPackages, KnowHairWrappedLightWhiteBalanceAndNamesOfOlderVersions)
{
    const auto pass = CompileHlsl(
        test::IncludeOf(std::string(k_Universal) + "ShaderLibrary/Lighting.hlsl") +
        test::IncludeOf("Packages/com.unity.render-pipelines.core/ShaderLibrary/BSDF.hlsl") +
        R"(
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            BRDFData brdf = (BRDFData)0;
            float3 n = GetPrimaryCameraPosition() + ComputeWorldSpacePosition(p, UNITY_MATRIX_I_VP);
            float3 c = DirectBRDF(brdf, n, n, n) + DirectBDRF(brdf, n, n, n);
            c += D_KajiyaKay(ShiftTangent(n, c, 0.1), n, 20.0) * RangeRemap(1.0, 2.0, p.x);
            c *= ComputeWrappedDiffuseLighting(n.x, 0.5) + unity_LightIndices[1].y;
            c *= SAMPLE_TEXTURE2D_SHADOW(_MainLightShadowmapTexture,
                                         sampler_MainLightShadowmapTexture, p.xyz);
            return float4(NeutralTonemap(WhiteBalance(c, n)), 1);
        })");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
}

TEST(ShaderLibraryPackages, HaveTheTexturesOfShaderGraphs)
{
    const auto pass = CompileHlsl(
        test::IncludeOf("Packages/com.unity.render-pipelines.core/ShaderLibrary/Texture.hlsl") + R"(
        TEXTURECUBE(_Sky); SAMPLER(sampler_Sky);
        TEXTURE3D(_Fog); SAMPLER(sampler_Fog);
        TEXTURE2D_ARRAY(_Maps); SAMPLER(sampler_Maps);
        SAMPLER(sampler_Linear_Repeat);
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            UnityTextureCube sky = UnityBuildTextureCubeStruct(_Sky);
            UnityTexture3D fog = UnityBuildTexture3DStruct(_Fog);
            UnityTexture2DArray maps = UnityBuildTexture2DArrayStruct(_Maps);
            UnitySamplerState state = UnityBuildSamplerStateStruct(sampler_Linear_Repeat);
            float4 sum = SAMPLE_TEXTURECUBE_LOD(sky.tex, sky.samplerstate, p.xyz, 0);
            sum += fog.Sample(fog.samplerstate, p.xyz) + maps.Sample(maps.samplerstate, p.xyz);
            sum += sky.SampleLevel(state, p.xyz, 1) + fog.SampleBias(state, p.xyz, 1);
            return sum + maps.SampleGrad(state, p.xyz, p.xy, p.yz);
        })");
    EXPECT_EQ(pass->layout.textures.size(), 3u);
    EXPECT_EQ(pass->layout.samplers.size(), 4u);
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
}

TEST(ShaderLibraryPackages, KnowLightLayersWithoutURP)
{
    CompileHlsl(test::IncludeOf(
                    "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonLighting.hlsl") +
                R"(
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target { return IsMatchingLightLayer(1u, 3u); })");
}

TEST(ShaderLibraryPackages, HaveSamplersAndTexelSizesOfBlitsByName)
{
    const auto samplers =
        CompileHlsl(test::IncludeOf(std::string(k_Universal) + "ShaderLibrary/Core.hlsl") + R"(
        TEXTURE2D(_Map);
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            return _Map.SampleLevel(sampler_PointClamp, p.xy, 0) +
                   _Map.SampleLevel(sampler_TrilinearRepeat, p.xy, 0);
        })");
    EXPECT_EQ(samplers->layout.samplers.size(), 2u);
    const auto blit = CompileHlsl(
        test::IncludeOf("Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl") +
        R"(
        Varyings vert(Attributes input) { return Vert(input); }
        float4 frag(Varyings input) : SV_Target { return _BlitTexture_TexelSize; })");
    ASSERT_EQ(blit->layout.buffers.size(), 1u);
    const auto& members = blit->layout.buffers[0].members;
    EXPECT_TRUE(std::any_of(members.begin(), members.end(),
                            [](const auto& m) { return m.name == "_BlitTexture_TexelSize"; }));
}

TEST(ShaderLibraryPackages, WriteRenderingLayersInAVariantOfTheirOwn)
{
    PassProgram program =
        test::Program("#include_with_pragmas \"" + std::string(k_Universal) +
                      "ShaderLibrary/RenderingLayers.hlsl\"\n" +
                      test::IncludeOf(std::string(k_Universal) + "ShaderLibrary/Core.hlsl") + R"(
        float4 vert(float4 p : POSITION) : SV_Position { return TransformObjectToHClip(p.xyz); }
        void frag(out float4 color : SV_Target0
        #ifdef _WRITE_RENDERING_LAYERS
            , out float4 layers : SV_Target1
        #endif
        )
        {
            color = 1;
        #ifdef _WRITE_RENDERING_LAYERS
            layers = EncodeMeshRenderingLayer(GetMeshRenderingLayer());
        #endif
        })");
    ShaderCompiler compiler;
    EXPECT_EQ(compiler.Compile(program)->layout.colorOutputs, 1);
    const std::vector<std::string> keywords = {"_WRITE_RENDERING_LAYERS"};
    EXPECT_EQ(compiler.Compile(program, keywords)->layout.colorOutputs, 2);
}

TEST(ShaderLibraryPackages, CompileAGeneratedPassOfASprite)
{
    const std::string includes = std::string(k_Universal) + "Editor/ShaderGraph/Includes/";
    const auto pass =
        CompileHlsl(test::IncludeOf(std::string(k_Universal) + "ShaderLibrary/Core.hlsl") +
                    R"(
        #define SHADERPASS SHADERPASS_SPRITEUNLIT
        #define VARYINGS_NEED_COLOR
        struct Attributes { float3 positionOS : POSITION; float4 color : COLOR; };
        struct Varyings { float4 positionCS; float4 color; };
        struct PackedVaryings { float4 positionCS : SV_POSITION; float4 color : TEXCOORD0; };
        PackedVaryings PackVaryings(Varyings v)
        {
            PackedVaryings p; p.positionCS = v.positionCS; p.color = v.color; return p;
        }
        Varyings UnpackVaryings(PackedVaryings p)
        {
            Varyings v; v.positionCS = p.positionCS; v.color = p.color; return v;
        }
        struct SurfaceDescriptionInputs { float4 position; };
        struct SurfaceDescription { float3 BaseColor; float Alpha; };
        SurfaceDescriptionInputs BuildSurfaceDescriptionInputs(Varyings v)
        {
            SurfaceDescriptionInputs i; i.position = v.positionCS; return i;
        }
        SurfaceDescription SurfaceDescriptionFunction(SurfaceDescriptionInputs i)
        {
            SurfaceDescription s; s.BaseColor = i.position.xyz; s.Alpha = 0.5; return s;
        })" + "\n" + test::IncludeOf(includes + "ShaderPass.hlsl") +
                    test::IncludeOf(includes + "Varyings.hlsl") +
                    test::IncludeOf(includes + "SpriteUnlitPass.hlsl"));
    EXPECT_EQ(pass->layout.vertexInputs.size(), 2u);
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
}

TEST(ShaderLibraryPackages, KnowShadowNamesOfOlderVersions)
{
    const auto pass =
        CompileHlsl(test::IncludeOf(std::string(k_Universal) + "ShaderLibrary/Shadows.hlsl") + R"(
        TEXTURE2D_SHADOW(_Map); SAMPLER_CMP(sampler_Map);
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            return SampleShadowmap(p, TEXTURE2D_SHADOW_ARGS(_Map, sampler_Map),
                                   GetMainLightShadowSamplingData(), GetMainLightShadowStrength(),
                                   false) * _MainLightShadowData.x;
        })");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    ASSERT_EQ(pass->layout.samplers.size(), 1u);
    EXPECT_TRUE(pass->layout.samplers[0].comparison);
}

} // namespace
} // namespace limn
