#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

std::shared_ptr<const ShaderProgram> CompileCore(const std::string& fragment)
{
    const std::string entry = "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                              "TEXTURE2D(_Height); SAMPLER(sampler_Height);\n";
    ShaderCompiler compiler;
    const auto pass = compiler.Compile(test::Program(
        "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n" +
        entry + fragment));
    EXPECT_EQ(test::ValidationMessages(pass->vertexSpirv), "");
    EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
    return pass;
}

TEST(CoreLibrary, CompilesHashesForShadersOfTheirOwn)
{
    CompileCore(R"(
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Hashes.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            uint one; uint2 two; uint3 three; half h; half2 h2;
            Hash_Tchou_2_1_uint((uint2)p.xy, one);
            Hash_Tchou_2_2_uint((uint2)p.xy, two);
            Hash_Tchou_3_3_uint((uint3)p.xyz, three);
            Hash_LegacySine_2_1_half(p.xy, h);
            Hash_LegacySine_2_2_half(p.xy, h2);
            return float4(one + two.x + three.z, h, h2);
        })");
}

TEST(CoreLibrary, CompilesParallaxOcclusionUnderSeveralNames)
{
    const auto pass = CompileCore(R"(
        struct PerPixelHeightDisplacementParam { float2 uv; };
        float ComputePerPixelHeightDisplacement(float2 offset, float lod, PerPixelHeightDisplacementParam p)
        {
            return SAMPLE_TEXTURE2D_LOD(_Height, sampler_Height, p.uv + offset, lod).r;
        }
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/PerPixelDisplacement.hlsl"
        #define POM_NAME_ID Detail
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/PerPixelDisplacement.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            PerPixelHeightDisplacementParam d;
            d.uv = p.xy;
            float height, height2;
            float2 uv = ParallaxOcclusionMapping(0, 5, 16, float3(0.1, 0.1, 1), d, height);
            uv += ParallaxOcclusionMappingDetail(0, 5, 16, float3(0.1, 0.1, 1), d, height2);
            return float4(uv, height, height2);
        })");
    EXPECT_EQ(pass->layout.textures.size(), 1u);
}

TEST(CoreLibrary, CompilesWhatRayTracersAndDebuggersCall)
{
    CompileCore(R"(
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/ImageBasedLighting.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/AreaLighting.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Debug.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            float4 c = IntegrateGGXAndDisneyDiffuseFGD(p.x, p.y, 8);
            c.rgb += GetIndexColor((int)p.x) + kDebugColorGradient[3].rgb + kDebugColorTeal.rgb;
            float3 n; float roughness;
            GetGGXAnisotropicModifiedNormalAndRoughness(p.xyz, p.yzx, p.zxy, p.xyz, 0.5, 0.3, n, roughness);
            c.rgb += n * roughness + GetIorN(c.rgb, p.xyz) + getIorK2(c.rgb, n) + CoatRefract(n, n, 0.7);
            c.rgb += DiffuseGGX(c.rgb, p.x, p.y, p.z, p.w, 0.5) + V_Charlie(p.x, p.y, 0.4);
            c.a += PerceptualRoughnessToMipmapLevel(p.x, 6) + PerceptualRoughnessToMipmapLevel(p.x, p.y);
            c.a += DiffuseSphereLightIrradiance(p.x, p.y) + GetIBLRuntimeFilterSampleCount(3);
            float4x3 corners = {p.xyz, p.yzx, p.zxy, p.xzy};
            CBSDF all = (CBSDF)0;
            all.specR = PolygonIrradiance(corners);
            return c + float4(all.specR, 0);
        })");
}

TEST(CoreLibrary, PlacesScreenCoordinatesOfAPart)
{
    const std::string text = R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/ScreenCoordOverride.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            float2 uv = SCREEN_COORD_REMOVE_SCALEBIAS(SCREEN_COORD_APPLY_SCALEBIAS(p.xy));
            return float4(uv, SCREEN_SIZE_OVERRIDE.xy);
        })";
    EXPECT_THAT(test::Disassemble(CompileCore(text)->fragmentSpirv),
                testing::HasSubstr("\"_ScreenSize\""));
    EXPECT_THAT(
        test::Disassemble(CompileCore("#define SCREEN_COORD_OVERRIDE\n" + text)->fragmentSpirv),
        testing::AllOf(testing::HasSubstr("\"_ScreenCoordScaleBias\""),
                       testing::HasSubstr("\"_ScreenSizeOverride\"")));
}

} // namespace
} // namespace limn
