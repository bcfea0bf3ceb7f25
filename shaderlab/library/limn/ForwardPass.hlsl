// What the forward passes of Lit, Simple Lit and Baked Lit have in common: all but the surface and
// its lighting.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"

#define lightmapUV staticLightmapUV // the name until URP 11

struct Attributes
{
    float4 positionOS : POSITION;
    float3 normalOS : NORMAL;
    float4 tangentOS : TANGENT;
    float2 texcoord : TEXCOORD0;
    float2 staticLightmapUV : TEXCOORD1;
    float2 dynamicLightmapUV : TEXCOORD2;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float2 uv : TEXCOORD0;
    float3 positionWS : TEXCOORD1;
    float3 normalWS : TEXCOORD2;
    float4 tangentWS : TEXCOORD3; // w: sign of the bitangent
    // The two names of the fog factor: vertex functions of authors write one of them.
    float fogFactor : TEXCOORD4;
    float4 fogFactorAndVertexLight : TEXCOORD5;
    float4 shadowCoord : TEXCOORD6;
    float3 viewDirTS : TEXCOORD7;
    DECLARE_LIGHTMAP_OR_SH(staticLightmapUV, vertexSH, 8);
    float3 viewDirWS : TEXCOORD9;   // until URP 11
    float2 staticLightmapUV : TEXCOORD10;
    float4 positionCS : SV_POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

void InitializeInputData(Varyings input, float3 normalTS, out InputData inputData)
{
    inputData = (InputData)0;
    inputData.positionWS = input.positionWS;
    inputData.positionCS = input.positionCS;
    inputData.viewDirectionWS = GetWorldSpaceNormalizeViewDir(input.positionWS);
#if defined(_NORMALMAP) || defined(_DETAIL)
    float3 bitangent = cross(input.normalWS, input.tangentWS.xyz) * input.tangentWS.w;
    inputData.tangentToWorld = float3x3(input.tangentWS.xyz, bitangent, input.normalWS);
    inputData.normalWS = TransformTangentToWorld(normalTS, inputData.tangentToWorld);
#else
    inputData.normalWS = input.normalWS;
#endif
    inputData.normalWS = NormalizeNormalPerPixel(inputData.normalWS);
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    inputData.shadowCoord = input.shadowCoord;
#elif defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    inputData.shadowCoord = TransformWorldToShadowCoord(input.positionWS);
#endif
    float fogFactor = max(input.fogFactor, input.fogFactorAndVertexLight.x); // one may be 0
    inputData.fogCoord = InitializeInputDataFog(float4(input.positionWS, 1.0), fogFactor);
    inputData.vertexLighting = input.fogFactorAndVertexLight.yzw;
    inputData.bakedGI = SAMPLE_GI(input.staticLightmapUV, input.vertexSH, inputData.normalWS);
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.positionCS);
    inputData.shadowMask = SAMPLE_SHADOWMASK(input.staticLightmapUV);
}

Varyings ForwardPassVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    VertexPositionInputs position = GetVertexPositionInputs(input.positionOS.xyz);
    VertexNormalInputs normal = GetVertexNormalInputs(input.normalOS, input.tangentOS);
    output.uv = TRANSFORM_TEX(input.texcoord, _BaseMap);
    output.positionWS = position.positionWS;
    output.positionCS = position.positionCS;
    output.normalWS = NormalizeNormalPerVertex(normal.normalWS);
    output.tangentWS = float4(normal.tangentWS, input.tangentOS.w * GetOddNegativeScale());
    output.viewDirWS = GetWorldSpaceViewDir(position.positionWS);
    output.fogFactor = ComputeFogFactor(position.positionCS.z);
    output.fogFactorAndVertexLight =
        float4(output.fogFactor, VertexLighting(position.positionWS, normal.normalWS));
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    output.shadowCoord = GetShadowCoord(position);
#endif
#if defined(REQUIRES_TANGENT_SPACE_VIEW_DIR_INTERPOLATOR)
    output.viewDirTS = GetViewDirectionTangentSpace(
        output.tangentWS, output.normalWS, GetWorldSpaceNormalizeViewDir(position.positionWS));
#endif
    OUTPUT_SH(output.normalWS, output.vertexSH);
    return output;
}
