// Full-screen passes over a source texture.
#pragma once
#ifndef UNITY_CORE_BLIT_INCLUDED
#define UNITY_CORE_BLIT_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/EntityLighting.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/TextureXR.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/GlobalSamplers.hlsl"

TEXTURE2D_X(_BlitTexture);
float4 _BlitTexture_TexelSize; // 1/width, 1/height, width, height
TEXTURECUBE(_BlitCubeTexture);

uniform float4 _BlitScaleBias;
uniform float4 _BlitScaleBiasRt;
uniform float _BlitMipLevel;
uniform float2 _BlitTextureSize;
uniform uint _BlitPaddingSize;
uniform int _BlitTexArraySlice;
uniform float4 _BlitDecodeInstructions;

struct Attributes
{
    uint vertexID : SV_VertexID;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings Vert(Attributes input)
{
    Varyings output;
    output.positionCS = GetFullScreenTriangleVertexPosition(input.vertexID);
    output.texcoord =
        GetFullScreenTriangleTexCoord(input.vertexID) * _BlitScaleBias.xy + _BlitScaleBias.zw;
    return output;
}

Varyings VertQuad(Attributes input)
{
    Varyings output;
    float4 corner = GetQuadVertexPosition(input.vertexID);
    float2 placed = corner.xy * _BlitScaleBiasRt.xy + _BlitScaleBiasRt.zw;
    output.positionCS = float4(placed.x * 2.0 - 1.0, 1.0 - placed.y * 2.0, corner.z, 1.0);
    output.texcoord = corner.xy * _BlitScaleBias.xy + _BlitScaleBias.zw;
    return output;
}

// With _BlitPaddingSize texels around the texture in all, half of them on each side.
Varyings VertQuadPadding(Attributes input)
{
    Varyings output = VertQuad(input);
    float2 padding = float(_BlitPaddingSize);
    float2 place = GetQuadTexCoord(input.vertexID) * (_BlitTextureSize + padding) - 0.5 * padding;
    output.texcoord = place / _BlitTextureSize * _BlitScaleBias.xy + _BlitScaleBias.zw;
    return output;
}

float4 FragBlit(Varyings input, SamplerState s)
{
    return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, s, input.texcoord, _BlitMipLevel);
}

float4 FragNearest(Varyings input) : SV_Target { return FragBlit(input, sampler_PointClamp); }
float4 FragBilinear(Varyings input) : SV_Target { return FragBlit(input, sampler_LinearClamp); }
float4 FragNearestRepeat(Varyings input) : SV_Target { return FragBlit(input, sampler_PointRepeat); }
float4 FragBilinearRepeat(Varyings input) : SV_Target { return FragBlit(input, sampler_LinearRepeat); }
#endif
