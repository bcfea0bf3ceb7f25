#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

// Headers of the built-in pipeline for one kind of effect each: deferred lights, textures that draw
// themselves, particles.

namespace limn
{
namespace
{

using test::CompileCg;
using test::TextureNames;
using testing::ElementsAre;

TEST(BuiltinEffects, KnowsTheNamesOfDeferredLights)
{
    const char* const text = R"(
        #include "UnityDeferredLibrary.cginc"
        unity_v2f_deferred vert(float4 p : POSITION, float3 n : NORMAL) { return vert_deferred(p, n); }
        fixed4 frag(unity_v2f_deferred i) : SV_Target
        {
            float3 place; float2 uv; half3 direction; float atten, fade;
            UnityDeferredCalculateLightParams(i, place, uv, direction, atten, fade);
            return fixed4(direction, 1) * _LightColor * atten;
        })";
    const auto names = [&](const std::vector<std::string>& keywords)
    {
        return TextureNames(*CompileCg(text, keywords));
    };
    EXPECT_THAT(names({"DIRECTIONAL"}), testing::IsEmpty());
    EXPECT_THAT(names({"DIRECTIONAL_COOKIE"}),
                testing::UnorderedElementsAre("_CameraDepthTexture", "_LightTexture0"));
    EXPECT_THAT(names({"POINT"}),
                testing::UnorderedElementsAre("_CameraDepthTexture", "_LightTextureB0"));
    for (const char* cookie : {"SPOT", "POINT_COOKIE"})
    {
        EXPECT_THAT(names({cookie}),
                    testing::UnorderedElementsAre("_CameraDepthTexture", "_LightTexture0",
                                                  "_LightTextureB0"));
    }
}

TEST(BuiltinEffects, ReadsACustomRenderTextureWithoutVertices)
{
    const auto pass = CompileCg(R"(
        #include "UnityCustomRenderTexture.cginc"
        #include "UnityCG.cginc"
        v2f_customrendertexture vert(appdata_customrendertexture v)
        {
            return CustomRenderTextureVertexShader(v);
        }
        float4 frag(v2f_customrendertexture i) : SV_Target
        {
            float2 step = float2(1 / _CustomRenderTextureWidth, 1 / _CustomRenderTextureHeight);
            return tex2D(_SelfTexture2D, i.globalTexcoord.xy + step) + i.primitiveID;
        })");
    EXPECT_TRUE(pass->layout.vertexInputs.empty());
    EXPECT_THAT(TextureNames(*pass), ElementsAre("_SelfTexture2D"));
}

TEST(BuiltinEffects, ReadsTheTexturesOfParticlesThatTheKeywordsName)
{
    const char* const text = R"(
        #include "UnityStandardParticles.cginc"
        VertexOutput vert(appdata_particles v)
        {
            VertexOutput o;
            vertParticleUnlit(v, o);
            vertInstancingColor(o.color);
            vertInstancingUVs(v.texcoords.xy, o.texcoord);
            return o;
        }
        half4 frag(VertexOutput i) : SV_Target { return fragParticleUnlit(i); })";
    EXPECT_THAT(TextureNames(*CompileCg(text)), ElementsAre("_MainTex"));
    EXPECT_THAT(
        TextureNames(*CompileCg(text, {"_FADING_ON", "SOFTPARTICLES_ON", "_ALPHABLEND_ON"})),
        testing::UnorderedElementsAre("_MainTex", "_CameraDepthTexture"));
    EXPECT_THAT(TextureNames(*CompileCg(text, {"_NORMALMAP", "EFFECT_BUMP"})),
                testing::UnorderedElementsAre("_MainTex", "_BumpMap", "_GrabTexture"));
    EXPECT_THAT(TextureNames(*CompileCg(text, {"_EMISSION", "_ALPHABLEND_ON"})),
                testing::UnorderedElementsAre("_MainTex", "_EmissionMap"));
}

} // namespace
} // namespace limn
