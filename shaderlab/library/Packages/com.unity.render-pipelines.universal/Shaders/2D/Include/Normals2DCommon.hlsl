// Normals of sprites for 2D lights. The author has declared Attributes and Varyings by
// COMMON_2D_NORMALS_INPUTS and COMMON_2D_NORMALS_OUTPUTS.
#pragma once
#ifndef _NORMALS_2D_COMMON
#define _NORMALS_2D_COMMON
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/NormalsRenderingShared.hlsl"

TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);
TEXTURE2D(_NormalMap);
SAMPLER(sampler_NormalMap);

Varyings CommonNormalsVertex(Attributes input)
{
    Varyings result = (Varyings)0;
    result.uv = input.uv;
    result.positionCS = TransformObjectToHClip(input.positionOS);
    float3 normal = TransformObjectToWorldDir(input.normal);
    float3 tangent = TransformObjectToWorldDir(input.tangent.xyz);
    result.bitangentWS = (half3)(input.tangent.w * cross(normal, tangent));
    result.tangentWS = (half3)tangent;
    result.normalWS = (half3)normal;
    return result;
}

half4 CommonNormalsFragment(Varyings input, half4 color)
{
    half3 bent = (half3)UnpackNormal(SAMPLE_TEXTURE2D(_NormalMap, sampler_NormalMap, input.uv));
    half4 tinted = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv) * color;
    return NormalsRenderingShared(tinted, bent, input.tangentWS, input.bitangentWS, input.normalWS);
}
#endif
