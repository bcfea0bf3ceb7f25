// Light that was computed beforehand: harmonics, light maps, reflection probes.
#pragma once
#ifndef UNITY_ENTITY_LIGHTING_INCLUDED
#define UNITY_ENTITY_LIGHTING_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/SphericalHarmonics.hlsl"

#define LIGHTMAP_RGBM_MAX_GAMMA 5.0
#define LIGHTMAP_RGBM_MAX_LINEAR 34.493242
#define LIGHTMAP_HDR_MULTIPLIER 1.0
#define LIGHTMAP_HDR_EXPONENT 1.0
#define EMISSIVE_RGBM_SCALE 97.0

// Light maps are stored as they are.
float3 UnpackLightmapRGBM(float4 rgbmInput, float4 decodeInstructions)
{
    return rgbmInput.rgb * (pow(abs(rgbmInput.a), decodeInstructions.y) * decodeInstructions.x);
}
float3 UnpackLightmapDoubleLDR(float4 encodedColor, float4 decodeInstructions)
{
    return encodedColor.rgb * decodeInstructions.x;
}
float3 DecodeLightmap(float4 encodedIlluminance, float4 decodeInstructions)
{
    return encodedIlluminance.rgb;
}

// instructions: scale, exponent of alpha, -, how much alpha counts
float3 DecodeHDREnvironment(float4 encodedIrradiance, float4 decodeInstructions)
{
    float alpha = max(decodeInstructions.w * (encodedIrradiance.a - 1.0) + 1.0, 0.0);
    float scale = decodeInstructions.x * PositivePow(alpha, decodeInstructions.y);
    return encodedIrradiance.rgb * scale;
}

// The second also brightens normals that lean towards where most of the light comes from.
float3 SampleSingleLightmap(Texture2D lightmapTex, SamplerState lightmapSampler, float2 uv,
                            float4 transform, bool encodedLightmap, float4 decodeInstructions)
{
    float4 encoded = lightmapTex.Sample(lightmapSampler, uv * transform.xy + transform.zw);
    return DecodeLightmap(encoded, decodeInstructions);
}
float3 SampleDirectionalLightmap(Texture2D lightmapTex, SamplerState lightmapSampler,
                                 Texture2D lightmapDirTex, SamplerState lightmapDirSampler,
                                 float2 uv, float4 transform, float3 normalWS, bool encodedLightmap,
                                 float4 decodeInstructions)
{
    uv = uv * transform.xy + transform.zw;
    float4 direction = lightmapDirTex.Sample(lightmapDirSampler, uv);
    float3 light = DecodeLightmap(lightmapTex.Sample(lightmapSampler, uv), decodeInstructions);
    float halfLambert = dot(normalWS, direction.xyz - 0.5) + 0.5;
    return light * halfLambert / max(1e-4, direction.w);
}

// A light probe proxy volume: four boxes beside each other along x, of which three hold the
// harmonics of red, green and blue and the last how much of each light gets there.
float3 limn_InProbeVolume(float3 positionWS, float4x4 worldToTexture, float isLocal, float3 least,
                          float3 inverseSize)
{
    float3 position = isLocal == 1.0 ? mul(worldToTexture, float4(positionWS, 1.0)).xyz : positionWS;
    return (position - least) * inverseSize;
}
// Half a texel is kept from the neighbour.
float3 limn_InProbeBox(float3 place, float box, float texel)
{
    place.x = clamp(place.x * 0.25, texel * 0.5, 0.25 - texel * 0.5) + box * 0.25;
    return place;
}
float3 SampleProbeVolumeSH4(Texture3D SHVolumeTexture, SamplerState SHVolumeSampler,
                            float3 positionWS, float3 normalWS, float4x4 WorldToTexture,
                            float transformToLocal, float texelSizeX, float3 probeVolumeMin,
                            float3 probeVolumeSizeInv)
{
    float3 place = limn_InProbeVolume(positionWS, WorldToTexture, transformToLocal, probeVolumeMin,
                                      probeVolumeSizeInv);
    float4 sh[3];
    for (int i = 0; i < 3; i++)
    {
        float3 uvw = limn_InProbeBox(place, i, texelSizeX);
        sh[i] = SHVolumeTexture.SampleLevel(SHVolumeSampler, uvw, 0);
    }
    return SHEvalLinearL0L1(normalWS, sh[0], sh[1], sh[2]);
}
float4 SampleProbeOcclusion(Texture3D SHVolumeTexture, SamplerState SHVolumeSampler,
                            float3 positionWS, float4x4 WorldToTexture, float transformToLocal,
                            float texelSizeX, float3 probeVolumeMin, float3 probeVolumeSizeInv)
{
    float3 place = limn_InProbeVolume(positionWS, WorldToTexture, transformToLocal, probeVolumeMin,
                                      probeVolumeSizeInv);
    return SHVolumeTexture.SampleLevel(SHVolumeSampler, limn_InProbeBox(place, 3, texelSizeX), 0);
}

// Emission in four bytes: a colour and its scale.
float4 PackEmissiveRGBM(float3 rgb)
{
    float3 scaled = rgb / EMISSIVE_RGBM_SCALE;
    float alpha = ceil(max(max(scaled.r, max(scaled.g, scaled.b)), 1e-3) * 255.0) / 255.0;
    return float4(scaled / alpha, alpha);
}
float3 UnpackEmissiveRGBM(float4 rgbm) { return rgbm.rgb * rgbm.a * EMISSIVE_RGBM_SCALE; }
#endif
