#include "Mentions.h"
#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using testing::HasSubstr;

std::string Urp(const std::string& file)
{
    return "#include \"Packages/com.unity.render-pipelines.universal/" + file + ".hlsl\"\n";
}

std::shared_ptr<const ShaderProgram> CompileUrp(const std::string& text,
                                                const char* vertex = "vert",
                                                const char* fragment = "frag",
                                                const std::vector<std::string>& keywords = {})
{
    return test::CompileEntries(text, vertex, fragment, keywords, ProgramLanguage::Hlsl);
}

const char* const k_Sprite = R"(
    #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
    #include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/Core2D.hlsl"
    #include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/LightingUtility.hlsl"
    struct Attributes
    {
        float3 positionOS : POSITION; float4 color : COLOR; float2 uv : TEXCOORD0;
        UNITY_SKINNED_VERTEX_INPUTS
        UNITY_VERTEX_INPUT_INSTANCE_ID
    };
    struct Varyings
    {
        float4 positionCS : SV_POSITION; half4 color : COLOR; float2 uv : TEXCOORD0;
        half2 lightingUV : TEXCOORD1;
        UNITY_VERTEX_OUTPUT_STEREO
    };
    TEXTURE2D(_MainTex); SAMPLER(sampler_MainTex);
    TEXTURE2D(_MaskTex); SAMPLER(sampler_MaskTex);
    CBUFFER_START(UnityPerMaterial) half4 _Color; CBUFFER_END
    #if USE_SHAPE_LIGHT_TYPE_0
    SHAPE_LIGHT(0)
    #endif
    Varyings vert(Attributes v)
    {
        Varyings o = (Varyings)0;
        UNITY_SETUP_INSTANCE_ID(v);
        UNITY_SKINNED_VERTEX_COMPUTE(v);
        SetUpSpriteInstanceProperties();
        v.positionOS = UnityFlipSprite(v.positionOS, unity_SpriteProps.xy);
        o.positionCS = TransformObjectToHClip(v.positionOS);
        o.uv = v.uv;
        o.lightingUV = half2(ComputeScreenPos(o.positionCS / o.positionCS.w).xy);
        o.color = v.color * _Color * unity_SpriteColor;
        return o;
    }
    #include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/CombinedShapeLightShared.hlsl"
    half4 frag(Varyings i) : SV_Target
    {
        half4 main = i.color * SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, i.uv);
        half4 mask = SAMPLE_TEXTURE2D(_MaskTex, sampler_MaskTex, i.uv);
        SurfaceData2D surfaceData;
        InputData2D inputData;
        InitializeSurfaceData(main.rgb, main.a, mask, surfaceData);
        InitializeInputData(i.uv, i.lightingUV, inputData);
        return CombinedShapeLightShared(surfaceData, inputData);
    })";

TEST(UniversalFiles, DrawASpriteUnlitAndSayThatThereAreNoLights)
{
    const auto unlit = CompileUrp(k_Sprite);
    EXPECT_THAT(unlit->diagnostics, testing::IsEmpty());
    const auto lit = CompileUrp(k_Sprite, "vert", "frag", {"USE_SHAPE_LIGHT_TYPE_0"});
    ASSERT_EQ(lit->diagnostics.size(), 1u);
    EXPECT_THAT(ToString(lit->diagnostics[0]),
                test::Mentions("t.shader: note: it uses", "2D lights", "unlit"));
    CompileUrp(Urp("ShaderLibrary/Core") + Urp("Shaders/2D/Include/NormalsRenderingShared") + R"(
        struct v2f { float4 p : SV_Position; half3 n : NORMAL; half3 t : TANGENT; half3 b : TEXCOORD0; };
        v2f vert(float4 p : POSITION, float3 n : NORMAL)
        {
            v2f o;
            o.p = TransformObjectToHClip(p.xyz);
            o.n = n; o.t = n.yzx; o.b = n.zxy;
            return o;
        }
        half4 frag(v2f i) : SV_Target { return NormalsRenderingShared(1, half3(0, 0, 1), i.t, i.b, i.n); })");
}

TEST(UniversalFiles, DrawParticlesInEachOfTheirPasses)
{
    struct Pass
    {
        const char* input;
        const char* pass;
        const char* vertex;
        const char* fragment;
    };
    const Pass passes[] = {
        {"ParticlesUnlitInput", "ParticlesUnlitForwardPass", "vertParticleUnlit",
         "fragParticleUnlit"},
        {"ParticlesLitInput", "ParticlesLitForwardPass", "ParticlesLitVertex",
         "ParticlesLitFragment"},
        {"ParticlesSimpleLitInput", "ParticlesSimpleLitForwardPass", "ParticlesLitVertex",
         "ParticlesLitFragment"},
        {"ParticlesUnlitInput", "ParticlesDepthOnlyPass", "DepthOnlyVertex", "DepthOnlyFragment"},
        {"ParticlesLitInput", "ParticlesDepthNormalsPass", "DepthNormalsVertex",
         "DepthNormalsFragment"},
        {"ParticlesSimpleLitInput", "ParticlesEditorPass", "vertParticleEditor",
         "fragParticleSceneHighlight"},
        {"ParticlesLitInput", "ParticlesEditorPass", "vertParticleEditor",
         "fragParticleScenePicking"},
        {"ParticlesLitInput", "ParticlesLitGbufferPass", "ParticlesGBufferVertex",
         "ParticlesGBufferFragment"},
        {"ParticlesSimpleLitInput", "ParticlesSimpleLitGBufferPass", "ParticlesLitGBufferVertex",
         "ParticlesLitGBufferFragment"},
    };
    const std::vector<std::string> variants[] = {
        {},
        {"_NORMALMAP", "_EMISSION", "_SOFTPARTICLES_ON", "_FADING_ON", "_DISTORTION_ON",
         "_FLIPBOOKBLENDING_ON", "_ALPHATEST_ON", "_METALLICSPECGLOSSMAP", "_SPECGLOSSMAP",
         "FOG_LINEAR", "_ADDITIONAL_LIGHTS", "_MAIN_LIGHT_SHADOWS"},
        {"_ALPHAPREMULTIPLY_ON", "_COLORADDSUBDIFF_ON", "_SOFTPARTICLES_ON", "_SPECULAR_COLOR"},
        {"_ALPHAMODULATE_ON", "_COLOROVERLAY_ON", "_FADING_ON", "_SURFACE_TYPE_TRANSPARENT"},
    };
    for (const Pass& pass : passes)
    {
        for (const auto& keywords : variants)
        {
            SCOPED_TRACE(std::string(pass.input) + " " + pass.pass + " " +
                         (keywords.empty() ? "" : keywords.front()));
            const std::string folder = "Shaders/Particles/";
            CompileUrp(Urp(folder + pass.input) + Urp(folder + pass.pass), pass.vertex,
                       pass.fragment, keywords);
        }
    }
}

TEST(UniversalFiles, DrawMasksOfSpritesAndUnlitSurfacesDeferred)
{
    CompileUrp(Urp("ShaderLibrary/Core") + Urp("ShaderLibrary/UniversalDOTSInstancing") +
                   Urp("Shaders/2D/Include/SpriteMaskShared"),
               "MaskRenderingVertex", "MaskRenderingFragment");
    const std::string unlit = Urp("Shaders/UnlitInput") + Urp("Shaders/UnlitGBufferPass");
    CompileUrp(unlit, "UnlitPassVertex", "UnlitPassFragment");
    CompileUrp(unlit, "UnlitPassVertex", "UnlitPassFragment",
               {"_ALPHATEST_ON", "_ALPHAMODULATE_ON", "_SCREEN_SPACE_OCCLUSION"});
}

TEST(UniversalFiles, CopyDepth)
{
    const auto pass =
        CompileUrp(Urp("Shaders/Utils/CopyDepthPass"), "Vert", "frag", {"_OUTPUT_DEPTH"});
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("BuiltIn FragDepth"));
}

TEST(UniversalFiles, ComeWithAmbientOcclusion)
{
    const std::string text =
        "#include \"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n" +
        Urp("ShaderLibrary/SSAO");
    const std::vector<std::string> variants[] = {
        {"_SOURCE_DEPTH_LOW", "_SAMPLE_COUNT_LOW"},
        {"_SOURCE_DEPTH_MEDIUM", "_ORTHOGRAPHIC", "_SAMPLE_COUNT_MEDIUM"},
        {"_SOURCE_DEPTH_HIGH", "_BLUE_NOISE", "_SAMPLE_COUNT_HIGH"},
        {"_SOURCE_DEPTH_NORMALS"},
    };
    for (const auto& keywords : variants)
    {
        SCOPED_TRACE(keywords.front());
        CompileUrp(text, "Vert", "SSAO", keywords);
    }
    for (const char* blur : {"HorizontalBlur", "VerticalBlur", "FinalBlur",
                             "HorizontalGaussianBlur", "VerticalGaussianBlur", "KawaseBlur"})
    {
        SCOPED_TRACE(blur);
        CompileUrp(text, "Vert", blur);
    }
}

TEST(UniversalFiles, KnowUnity6sNamesOfTheTargetsOfADeferredPass)
{
    const auto pass = CompileUrp(Urp("ShaderLibrary/GBufferOutput") + R"(
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        GBufferFragOutput frag(float4 p : SV_Position)
        {
            SurfaceData s = (SurfaceData)0;
            InputData i = (InputData)0;
            i.normalWS = UnpackGBufferNormal(PackGBufferNormal(p.xyz));
            BRDFData b = (BRDFData)0;
            GBufferFragOutput o = PackGBuffersSurfaceData(s, i, p.rgb);
            o.color += PackGBuffersBRDFData(b, i, 0.5, p.rgb).color;
            GBufferData d = (GBufferData)0;
            d.materialFlags = UnpackGBufferMaterialFlags(PackGBufferMaterialFlags(1));
            return o;
        })");
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("Location 3"));
}

TEST(UniversalFiles, KnowNamesOfOlderAndNewerVersions)
{
    const auto pass = CompileUrp(
        Urp("ShaderLibrary/ForwardPlusKeyword.deprecated") + Urp("ShaderLibrary/Lighting") +
            Urp("ShaderLibrary/Shadows.deprecated") + Urp("ShaderLibrary/UnityGBuffer.deprecated") +
            Urp("ShaderLibrary/Debug/DebuggingFullscreen") +
            Urp("ShaderLibrary/LightCookie/LightCookieInput") + R"(
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            float fade = GetShadowFade(p.xyz) + _AdditionalLightsLayerMasks[1];
            float4 weights; SampleShadow_GetTexelWeights_Tent_3x3(0.25, weights);
        #ifdef _CLUSTER_LIGHT_LOOP
            fade *= 0.5;
        #endif
            return IsMainLightCookieEnabled() ? 0.0 : weights * fade;
        })",
        "vert", "frag", {"_FORWARD_PLUS"});
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("_MainLightShadowParams"));
}

} // namespace
} // namespace limn
