// What URP's passes of SpeedTree 7 and 8 have in common. A file that includes it has described the
// vertices (SpeedTreeVertexInput) and what is handed on of them besides limn_TREE_LIT, -_DEPTH and
// -_DEPTH_NORMAL (SpeedTreeVertexOutput, SpeedTreeVertexDepthOutput, SpeedTreeVertexDepthNormalOutput).
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LODCrossFade.hlsl"
#include "limn/SpeedTreeHue.hlsl"

#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
#define limn_TREE_SHADOW float4 shadowCoord : TEXCOORD6;
#else
#define limn_TREE_SHADOW
#endif
// tangentWS.w: sign of the bitangent
#define limn_TREE_LIT                                                                              \
    half4 fogFactorAndVertexLight : TEXCOORD2;                                                     \
    half3 normalWS : TEXCOORD3;                                                                    \
    half4 tangentWS : TEXCOORD4;                                                                   \
    limn_TREE_SHADOW float3 positionWS : TEXCOORD7;                                                \
    DECLARE_LIGHTMAP_OR_SH(lightmapUV, vertexSH, 8);                                               \
    float4 clipPos : SV_POSITION;                                                                  \
    UNITY_VERTEX_INPUT_INSTANCE_ID                                                                 \
    UNITY_VERTEX_OUTPUT_STEREO
#define limn_TREE_DEPTH                                                                            \
    half3 viewDirWS : TEXCOORD2;                                                                   \
    float4 clipPos : SV_POSITION;                                                                  \
    UNITY_VERTEX_INPUT_INSTANCE_ID                                                                 \
    UNITY_VERTEX_OUTPUT_STEREO
#define limn_TREE_DEPTH_NORMAL                                                                     \
    half3 normalWS : TEXCOORD2;                                                                    \
    half4 tangentWS : TEXCOORD3;                                                                   \
    float4 clipPos : SV_POSITION;                                                                  \
    UNITY_VERTEX_INPUT_INSTANCE_ID                                                                 \
    UNITY_VERTEX_OUTPUT_STEREO

// The rest of the three vertex functions, for what moved vertices are handed on as.
#define limn_TREE_TRANSFER_FRAME(input, output)                                                    \
    output.normalWS = TransformObjectToWorldNormal(input.normal);                                  \
    output.tangentWS = half4(TransformObjectToWorldDir(input.tangent.xyz),                         \
                             input.tangent.w * GetOddNegativeScale());
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
#define limn_TREE_TRANSFER_SHADOW(output, place) output.shadowCoord = GetShadowCoord(place);
#else
#define limn_TREE_TRANSFER_SHADOW(output, place)
#endif
#define limn_TREE_TRANSFER_LIT(input, output)                                                      \
    VertexPositionInputs limn_place = GetVertexPositionInputs(input.vertex.xyz);                   \
    limn_TREE_TRANSFER_FRAME(input, output)                                                        \
    limn_TREE_TRANSFER_SHADOW(output, limn_place)                                                  \
    output.fogFactorAndVertexLight =                                                               \
        half4(ComputeFogFactor(limn_place.positionCS.z),                                           \
              VertexLighting(limn_place.positionWS, output.normalWS));                             \
    output.positionWS = limn_place.positionWS;                                                     \
    output.clipPos = limn_place.positionCS;                                                        \
    OUTPUT_SH(output.normalWS, output.vertexSH);
#ifdef SHADOW_CASTER
#define limn_TREE_CLIP(input) limn_ShadowCasterClip(input.vertex.xyz, input.normal)
#else
#define limn_TREE_CLIP(input) TransformObjectToHClip(input.vertex.xyz)
#endif
#define limn_TREE_TRANSFER_DEPTH(input, output)                                                    \
    output.viewDirWS =                                                                             \
        GetWorldSpaceNormalizeViewDir(TransformObjectToWorld(input.vertex.xyz));                   \
    output.clipPos = limn_TREE_CLIP(input);
#define limn_TREE_TRANSFER_DEPTH_NORMAL(input, output)                                             \
    limn_TREE_TRANSFER_FRAME(input, output)                                                        \
    output.clipPos = TransformObjectToHClip(input.vertex.xyz);

half3 limn_TreeNormal(half3 normalTS, half3 normalWS, half4 tangentWS)
{
#ifdef EFFECT_BUMP
    half3 bitangent = cross(normalWS, tangentWS.xyz) * tangentWS.w;
    normalWS = TransformTangentToWorld(normalTS, half3x3(tangentWS.xyz, bitangent, normalWS));
#endif
    return NormalizeNormalPerPixel(normalWS);
}

// Everything but the shadow's place, which limn_TREE_INPUT adds.
InputData limn_TreeInput(float3 positionWS, float4 clipPos, half3 normalTS, half3 normalWS,
                         half4 tangentWS, half4 fogFactorAndVertexLight, half3 vertexSH)
{
    InputData data = (InputData)0;
    data.positionWS = positionWS;
    data.positionCS = clipPos;
    data.normalWS = limn_TreeNormal(normalTS, normalWS, tangentWS);
    data.viewDirectionWS = GetWorldSpaceNormalizeViewDir(positionWS);
    data.tangentToWorld = half3x3(
        tangentWS.xyz, cross(normalWS, tangentWS.xyz) * tangentWS.w, normalWS);
    data.fogCoord =
        InitializeInputDataFog(float4(positionWS, 1.0), fogFactorAndVertexLight.x);
    data.vertexLighting = fogFactorAndVertexLight.yzw;
    data.bakedGI = SAMPLE_GI(0, vertexSH, data.normalWS);
    data.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(clipPos);
    data.shadowMask = half4(1, 1, 1, 1);
    return data;
}
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
#define limn_TREE_SHADOW_COORD(v) v.shadowCoord
#elif defined(MAIN_LIGHT_CALCULATE_SHADOWS)
#define limn_TREE_SHADOW_COORD(v) TransformWorldToShadowCoord(v.positionWS)
#else
#define limn_TREE_SHADOW_COORD(v) float4(0, 0, 0, 0)
#endif
#define limn_TREE_INPUT(v, normalTS, data)                                                         \
    data = limn_TreeInput(v.positionWS, v.clipPos, normalTS, v.normalWS, v.tangentWS,              \
                          v.fogFactorAndVertexLight, v.vertexSH);                                  \
    data.shadowCoord = limn_TREE_SHADOW_COORD(v);

half4 limn_TreeDepth(float4 clipPos)
{
    LODFadeCrossFade(clipPos);
#ifdef SCENESELECTIONPASS
    return half4(_ObjectId, _PassValue, 1.0, 1.0);
#else
    return half4(clipPos.z, 0, 0, 0);
#endif
}
