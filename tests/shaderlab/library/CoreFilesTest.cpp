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

TEST(CoreLibrary, SamplesTexturesFromThreeSides)
{
    const std::string text = R"(
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Sampling/SampleUVMapping.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            UVMapping m = (UVMapping)0;
            m.mappingType = (int)p.x % 3;
            m.uv = p.xy;
            m.triplanarWeights = p.xyz;
            m.normalWS = p.zxy;
            float4 c = SAMPLE_UVMAPPING_TEXTURE2D(_Height, sampler_Height, m);
            c += SAMPLE_UVMAPPING_TEXTURE2D_LOD(_Height, sampler_Height, m, 1);
            c += SAMPLE_UVMAPPING_TEXTURE2D_BIAS(_Height, sampler_Height, m, 1);
            c.rgb += SAMPLE_UVMAPPING_NORMALMAP(_Height, sampler_Height, m, 1);
            c.rgb += SAMPLE_UVMAPPING_NORMALMAP_AG_LOD(_Height, sampler_Height, m, 1, 2);
            c.rgb += SAMPLE_UVMAPPING_NORMALMAP_RGB_BIAS(_Height, sampler_Height, m, 1, 2);
            float3 tangent, bitangent;
            SurfaceGradientGenBasisTB(c.rgb, ddx(c.rgb), ddy(c.rgb), 1, p.xy, tangent, bitangent);
            c.rgb += SurfaceGradientFromTangentSpaceNormalAndFromTBN(c.rgb, tangent, bitangent);
            return c;
        })";
    CompileCore(text);
    CompileCore("#define SURFACE_GRADIENT\n" + text);
}

TEST(CoreLibrary, CompilesOutputForBrightDisplays)
{
    const std::string text = R"(
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/HDROutput.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            float3 c = HDRMappingFromRec709(p.rgb, 200, 0, 1000, HDRRANGEREDUCTION_BT2390, 0.3);
            c += HDRMappingFromRec2020(p.rgb, 200, 0, 1000, HDRRANGEREDUCTION_REINHARD, 0, true);
            c += PerformRangeReduction(c, 0, 1000) + LinearToPQForLUT(c);
            return float4(SceneUIComposition(p, c, 200, 1000), 1);
        })";
    for (const char* define : {"", "#define OETF_CHOICE PRECISE_PQ\n",
                               "#define HDR_COLORSPACE_CONVERSION_AND_ENCODING\n"
                               "#define OETF_CHOICE ISS_APPROX_PQ\n"})
    {
        SCOPED_TRACE(define);
        EXPECT_THAT(CompileCore(define + text)->diagnostics, testing::IsEmpty());
    }
    EXPECT_EQ(CompileCore(R"(
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/HDROutput.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target { return float4(HDRMappingACES(p.rgb, 200, HDRRANGEREDUCTION_ACES1000NITS), 1); })")
                  ->diagnostics.size(),
              1u);
}

TEST(CoreLibrary, CompilesSmallFiles)
{
    CompileCore(R"(
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/MetaPass.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonShadow.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SpaceFillingCurves.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SDF2D.hlsl"
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            UnityMetaInput meta = (UnityMetaInput)0;
            meta.Albedo = GetShadowPosOffset(p.x, p.xyz, p.xy);
            meta.Albedo.x += CircleSDF(p.xy, 1) + RectangleSDF(p.xy, p.zw) + EllipseSDF(p.xy, p.zw);
            meta.Albedo.xy += DecodeMorton2D(EncodeMorton3D((uint3)p.xyz));
            return UnityMetaFragment(meta) + UnityMetaVertexPosition(p.xyz, p.xy, p.zw);
        })");
}

} // namespace
} // namespace limn
