// Properties of the grass of URP's terrain. Scripts set them: limn has no terrain of its own.
#pragma once
#ifndef UNIVERSAL_WAVING_GRASS_INPUT_INCLUDED
#define UNIVERSAL_WAVING_GRASS_INPUT_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceInput.hlsl"

#define _Surface 0.0 // opaque

CBUFFER_START(UnityPerMaterial)
float4 _MainTex_ST;
half4 _BaseColor;
half4 _SpecColor;
half4 _EmissionColor;
half _Cutoff;
half _Shininess;
CBUFFER_END

CBUFFER_START(TerrainGrass)
half4 _WavingTint;
float4 _WaveAndDistance; // time of the wind, size of its waves, bending, largest distance squared
float4 _CameraPosition;  // w: 1 / the largest distance squared
float3 _CameraRight, _CameraUp;
CBUFFER_END

TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);
float4 _MainTex_TexelSize;

#include "limn/WavingGrass.hlsl"

// Spreads a quad of grass to the camera's right and up; beyond the largest distance it stays a point.
void TerrainBillboardGrass(inout float4 pos, float2 offset)
{
    float3 away = pos.xyz - _CameraPosition.xyz;
    offset = dot(away, away) > _WaveAndDistance.w ? 0.0 : offset;
    pos.xyz += _CameraRight * offset.x + float3(0, offset.y, 0);
}
#endif
