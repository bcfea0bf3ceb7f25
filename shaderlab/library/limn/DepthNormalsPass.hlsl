// Depth, and world-space normals in a colour target. LIMN_NORMAL_SCALE: how strongly the normal map
// bends them; not at all where it is not defined.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"

#if defined(LIMN_NORMAL_SCALE) && (defined(_NORMALMAP) || defined(_DETAIL))
#define limn_BendsNormals
#endif

struct Attributes
{
    float4 positionOS : POSITION;
    float4 tangentOS : TANGENT;
    float2 texcoord : TEXCOORD0;
    float3 normal : NORMAL;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    float2 uv : TEXCOORD1;
    float3 normalWS : TEXCOORD2;
    float4 tangentWS : TEXCOORD4;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings DepthNormalsVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    VertexNormalInputs frame = GetVertexNormalInputs(input.normal, input.tangentOS);
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
#if defined(_ALPHATEST_ON) || defined(limn_BendsNormals)
    output.uv = TRANSFORM_TEX(input.texcoord, _BaseMap);
#endif
    output.normalWS = frame.normalWS;
    output.tangentWS = float4(frame.tangentWS, input.tangentOS.w * GetOddNegativeScale());
    return output;
}

void DepthNormalsFragment(Varyings input, out float4 outNormalWS : SV_Target0)
{
#ifdef _ALPHATEST_ON
    Alpha(SampleAlbedoAlpha(input.uv, TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap)).a, _BaseColor,
          _Cutoff);
#endif
    LODFadeCrossFade(input.positionCS);
#ifdef limn_BendsNormals
    float3 bitangent = cross(input.normalWS, input.tangentWS.xyz) * input.tangentWS.w;
    float3 normalTS = SampleNormal(input.uv, TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap), LIMN_NORMAL_SCALE);
    float3 normalWS = TransformTangentToWorld(
        normalTS, float3x3(input.tangentWS.xyz, bitangent, input.normalWS));
#else
    float3 normalWS = input.normalWS;
#endif
    outNormalWS = float4(NormalizeNormalPerPixel(normalWS), 0.0);
}
