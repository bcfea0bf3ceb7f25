// What the nodes of shader graphs call.
#pragma once
#ifndef UNITY_GRAPHFUNCTIONS_LW_INCLUDED
#define UNITY_GRAPHFUNCTIONS_LW_INCLUDED

#define SHADERGRAPH_SAMPLE_SCENE_DEPTH(uv) shadergraph_LWSampleSceneDepth(uv)
#define SHADERGRAPH_SAMPLE_SCENE_COLOR(uv) shadergraph_LWSampleSceneColor(uv)
#define SHADERGRAPH_SAMPLE_SCENE_NORMAL(uv) shadergraph_LWSampleSceneNormals(uv)
// Without parameters: of five arguments, and since Unity 6 of six.
#define SHADERGRAPH_BAKED_GI shadergraph_LWBakedGI
#define SHADERGRAPH_REFLECTION_PROBE(viewDir, normalOS, lod) \
    shadergraph_LWReflectionProbe(viewDir, normalOS, lod)
#define SHADERGRAPH_FOG(position, color, density) shadergraph_LWFog(position, color, density)
#define SHADERGRAPH_AMBIENT_SKY unity_AmbientSky
#define SHADERGRAPH_AMBIENT_EQUATOR unity_AmbientEquator
#define SHADERGRAPH_AMBIENT_GROUND unity_AmbientGround
#define SHADERGRAPH_MAIN_LIGHT_DIRECTION shadergraph_URPMainLightDirection
#define SHADERGRAPH_RENDERER_BOUNDS_MIN shadergraph_RendererBoundsWS_Min()
#define SHADERGRAPH_RENDERER_BOUNDS_MAX shadergraph_RendererBoundsWS_Max()

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SphericalHarmonics.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/RealtimeLights.hlsl"
#include "Packages/com.unity.shadergraph/ShaderGraphLibrary/Functions.hlsl"

#if defined(REQUIRE_DEPTH_TEXTURE)
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
#endif
#if defined(REQUIRE_OPAQUE_TEXTURE)
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareOpaqueTexture.hlsl"
#endif
#if defined(REQUIRE_NORMAL_TEXTURE)
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareNormalsTexture.hlsl"
#endif

float shadergraph_LWSampleSceneDepth(float2 uv)
{
#if defined(REQUIRE_DEPTH_TEXTURE)
    return SampleSceneDepth(uv);
#else
    return 0;
#endif
}
float3 shadergraph_LWSampleSceneColor(float2 uv)
{
#if defined(REQUIRE_OPAQUE_TEXTURE)
    return SampleSceneColor(uv);
#else
    return float3(0, 0, 0);
#endif
}
float3 shadergraph_LWSampleSceneNormals(float2 uv)
{
#if defined(REQUIRE_NORMAL_TEXTURE)
    return SampleSceneNormals(uv);
#else
    return float3(0, 0, 0);
#endif
}
float3 limn_AmbientFrom(float3 normalWS)
{
    float3 light = SHEvalLinearL0L1(normalWS, unity_SHAr, unity_SHAg, unity_SHAb) +
                   SHEvalLinearL2(normalWS, unity_SHBr, unity_SHBg, unity_SHBb, unity_SHC);
    return max(float3(0, 0, 0), limn_InActiveSpace(light));
}
float3 shadergraph_LWBakedGI(float3 positionWS, float3 normalWS, float2 uvStaticLightmap,
                             float2 uvDynamicLightmap, bool applyScaling)
{
    return limn_AmbientFrom(normalWS);
}
float3 shadergraph_LWBakedGI(float3 positionWS, float3 normalWS, uint2 positionSS,
                             float2 uvStaticLightmap, float2 uvDynamicLightmap, bool applyScaling)
{
    return limn_AmbientFrom(normalWS);
}
float3 shadergraph_LWReflectionProbe(float3 viewDir, float3 normalOS, float lod)
{
    return limn_AmbientFrom(reflect(-viewDir, normalOS));
}
// density: how much of the fog's colour is seen
void shadergraph_LWFog(float3 positionOS, out float4 color, out float density)
{
    color = unity_FogColor;
    float viewZ = -TransformWorldToView(TransformObjectToWorld(positionOS)).z;
    density = 1.0 - ComputeFogIntensity(
        ComputeFogFactorZ0ToFar(max(viewZ - _ProjectionParams.y, 0.0)));
}

// Of a length of 1 where the mesh's normal is, with the handedness in tangentWS.w.
float3x3 BuildTangentToWorld(float4 tangentWS, float3 normalWS)
{
    return CreateTangentToWorld(normalWS, tangentWS.xyz, tangentWS.w > 0.0 ? 1.0 : -1.0) /
           length(normalWS);
}

float3 shadergraph_URPMainLightDirection() { return -GetMainLight().direction; }
float3 shadergraph_RendererBoundsWS_Min()
{
    return GetCameraRelativePositionWS(unity_RendererBounds_Min.xyz);
}
float3 shadergraph_RendererBoundsWS_Max()
{
    return GetCameraRelativePositionWS(unity_RendererBounds_Max.xyz);
}
#endif
