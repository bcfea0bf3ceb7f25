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
    float3 place = input.positionWS;
    float4 fogAndLight = input.fogFactorAndVertexLight;
    inputData = (InputData)0;
    inputData.positionCS = input.positionCS;
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.positionCS);
    inputData.positionWS = place;
    inputData.viewDirectionWS = GetWorldSpaceNormalizeViewDir(place);
    inputData.vertexLighting = fogAndLight.yzw;
    float fogFactor = max(input.fogFactor, fogAndLight.x); // authors fill one of them
    inputData.fogCoord = InitializeInputDataFog(float4(place, 1.0), fogFactor);
    float3 normal = input.normalWS;
#if defined(_NORMALMAP) || defined(_DETAIL)
    float3 tangent = input.tangentWS.xyz;
    float3x3 frame = float3x3(tangent, cross(normal, tangent) * input.tangentWS.w, normal);
    normal = TransformTangentToWorld(normalTS, frame);
    inputData.tangentToWorld = frame;
#endif
    inputData.normalWS = NormalizeNormalPerPixel(normal);
    inputData.shadowMask = SAMPLE_SHADOWMASK(input.staticLightmapUV);
    inputData.bakedGI = SAMPLE_GI(input.staticLightmapUV, input.vertexSH, inputData.normalWS);
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    inputData.shadowCoord = input.shadowCoord;
#elif defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    inputData.shadowCoord = TransformWorldToShadowCoord(place);
#endif
}

Varyings ForwardPassVertex(Attributes input)
{
    Varyings output = (Varyings)0;
    output.uv = TRANSFORM_TEX(input.texcoord, _BaseMap);
    VertexNormalInputs normal = GetVertexNormalInputs(input.normalOS, input.tangentOS);
    VertexPositionInputs position = GetVertexPositionInputs(input.positionOS.xyz);
    output.positionCS = position.positionCS;
    output.positionWS = position.positionWS;
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

// What is drawn; no brighter than a target of halves holds, since infinity times 0 is no number.
float4 limn_Output(float4 color, InputData inputData)
{
    return float4(min(MixFog(color.rgb, inputData.fogCoord), HALF_MAX),
                  OutputAlpha(color.a, IsSurfaceTypeTransparent(_Surface)));
}
