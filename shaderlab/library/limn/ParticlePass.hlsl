// What the forward passes of particles have in common: all but the surface and its lighting.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Unlit.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl"

void InitializeInputData(VaryingsParticle input, half3 normalTS, out InputData inputData)
{
    inputData = (InputData)0;
    inputData.positionWS = input.positionWS.xyz;
    inputData.positionCS = input.clipPos;
#ifdef _NORMALMAP
    inputData.viewDirectionWS =
        SafeNormalize(float3(input.normalWS.w, input.tangentWS.w, input.bitangentWS.w));
    inputData.tangentToWorld =
        float3x3(input.tangentWS.xyz, input.bitangentWS.xyz, input.normalWS.xyz);
    inputData.normalWS = TransformTangentToWorld(normalTS, inputData.tangentToWorld);
#else
    inputData.viewDirectionWS = SafeNormalize(input.viewDirWS);
    inputData.normalWS = input.normalWS;
#endif
    inputData.normalWS = NormalizeNormalPerPixel(inputData.normalWS);
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    inputData.shadowCoord = input.shadowCoord;
#elif defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    inputData.shadowCoord = TransformWorldToShadowCoord(inputData.positionWS);
#endif
    inputData.fogCoord =
        InitializeInputDataFog(float4(input.positionWS.xyz, 1.0), input.positionWS.w);
    inputData.bakedGI = SampleSHPixel(input.vertexSH, inputData.normalWS);
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.clipPos);
    inputData.shadowMask = float4(1, 1, 1, 1);
}

VaryingsParticle limn_ParticleVertex(AttributesParticle input)
{
    VaryingsParticle output = (VaryingsParticle)0;
    VertexPositionInputs position = GetVertexPositionInputs(input.positionOS.xyz);
    VertexNormalInputs normal = GetVertexNormalInputs(input.normalOS, input.tangentOS);
    float3 viewDir = GetWorldSpaceNormalizeViewDir(position.positionWS);
    output.clipPos = position.positionCS;
    output.positionWS = float4(position.positionWS, ComputeFogFactor(position.positionCS.z));
    output.color = GetParticleColor(input.color);
#ifdef _NORMALMAP
    output.normalWS = float4(normal.normalWS, viewDir.x);
    output.tangentWS = float4(normal.tangentWS, viewDir.y);
    output.bitangentWS = float4(normal.bitangentWS, viewDir.z);
#else
    output.normalWS = normal.normalWS;
    output.viewDirWS = viewDir;
#endif
#ifdef _FLIPBOOKBLENDING_ON
    GetParticleTexcoords(output.texcoord, output.texcoord2AndBlend, input.texcoords,
                         input.texcoordBlend);
#else
    GetParticleTexcoords(output.texcoord, input.texcoords.xy);
#endif
#if defined(_SOFTPARTICLES_ON) || defined(_FADING_ON) || defined(_DISTORTION_ON)
    output.projectedPosition = position.positionNDC;
#endif
#ifdef REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR
    output.shadowCoord = GetShadowCoord(position);
#endif
    OUTPUT_SH(normal.normalWS, output.vertexSH);
    return output;
}

float4 limn_ParticleFogged(float4 color, InputData inputData)
{
    return float4(MixFog(color.rgb, inputData.fogCoord),
                  OutputAlpha(color.a, IsSurfaceTypeTransparent(_Surface)));
}
