// The deferred pass of UnlitInput.hlsl: a surface without light of its own.
#pragma once
#ifndef URP_UNLIT_GBUFFER_PASS_INCLUDED
#define URP_UNLIT_GBUFFER_PASS_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Unlit.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/AmbientOcclusion.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DBuffer.hlsl"

struct Attributes
{
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
    float3 normalOS : NORMAL;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};
struct Varyings
{
    float4 positionCS : SV_POSITION;
    float2 uv : TEXCOORD0;
    float3 normalWS : TEXCOORD1;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

void InitializeInputData(Varyings input, out InputData inputData)
{
    inputData = (InputData)0;
    inputData.positionCS = input.positionCS;
    inputData.normalWS = normalize(input.normalWS);
    inputData.viewDirectionWS = half3(0, 0, 1);
    inputData.shadowMask = half4(1, 1, 1, 1);
}

Varyings UnlitPassVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
    output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
    output.normalWS = GetVertexNormalInputs(input.normalOS).normalWS;
    return output;
}

FragmentOutput UnlitPassFragment(Varyings input)
{
    half4 color = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv) * _BaseColor;
    SurfaceData surface = (SurfaceData)0;
    surface.alpha = AlphaDiscard(color.a, _Cutoff);
    surface.albedo = AlphaModulate(color.rgb, surface.alpha);
    surface.occlusion = 1.0;
    LODFadeCrossFade(input.positionCS);
    InputData data;
    InitializeInputData(input, data);
#ifdef _DBUFFER
    ApplyDecalToBaseColor(input.positionCS, surface.albedo);
#endif
#ifdef _SCREEN_SPACE_OCCLUSION
    surface.occlusion =
        GetScreenSpaceAmbientOcclusion(GetNormalizedScreenSpaceUV(input.positionCS))
            .directAmbientOcclusion;
#endif
    return SurfaceDataToGbuffer(surface, data, half3(0, 0, 0), kLightingInvalid);
}
#endif
