// What the forward passes of particles have in common: all but the surface and its lighting.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Unlit.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl"

void InitializeInputData(VaryingsParticle input, half3 normalTS, out InputData inputData)
{
    float3 place = input.positionWS.xyz;
#ifdef _NORMALMAP
    float4 x = input.tangentWS, y = input.bitangentWS, z = input.normalWS;
    float3 viewDir = float3(z.w, x.w, y.w);
    float3x3 frame = float3x3(x.xyz, y.xyz, z.xyz);
    float3 normal = TransformTangentToWorld(normalTS, frame);
#else
    float3 viewDir = input.viewDirWS;
    float3 normal = input.normalWS;
#endif
    inputData = (InputData)0;
    inputData.shadowMask = 1.0;
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.clipPos);
    inputData.positionCS = input.clipPos;
    inputData.positionWS = place;
    inputData.fogCoord = InitializeInputDataFog(float4(place, 1.0), input.positionWS.w);
    inputData.viewDirectionWS = SafeNormalize(viewDir);
    inputData.normalWS = NormalizeNormalPerPixel(normal);
    inputData.bakedGI = SampleSHPixel(input.vertexSH, inputData.normalWS);
#ifdef _NORMALMAP
    inputData.tangentToWorld = frame;
#endif
#if defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    inputData.shadowCoord = input.shadowCoord;
#elif defined(MAIN_LIGHT_CALCULATE_SHADOWS)
    inputData.shadowCoord = TransformWorldToShadowCoord(place);
#endif
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
#if defined(_SOFTPARTICLES_ON) || defined(_FADING_ON) || defined(_DISTORTION_ON)
    output.projectedPosition = position.positionNDC;
#endif
#ifndef _FLIPBOOKBLENDING_ON
    GetParticleTexcoords(output.texcoord, input.texcoords.xy);
#else
    GetParticleTexcoords(output.texcoord, output.texcoord2AndBlend, input.texcoords,
                         input.texcoordBlend);
#endif
#ifdef REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR
    output.shadowCoord = GetShadowCoord(position);
#endif
    OUTPUT_SH(normal.normalWS, output.vertexSH);
    return output;
}

float4 limn_ParticleFogged(float4 color, InputData inputData)
{
    return float4(min(MixFog(color.rgb, inputData.fogCoord), HALF_MAX),
                  OutputAlpha(color.a, IsSurfaceTypeTransparent(_Surface)));
}
