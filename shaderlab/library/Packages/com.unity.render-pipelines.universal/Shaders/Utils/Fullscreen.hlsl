// A pass over the whole target, from a mesh, or with _USE_DRAW_PROCEDURAL from four vertex numbers.
// URP 7 to 13.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

struct Attributes
{
#if _USE_DRAW_PROCEDURAL
    uint vertexID : SV_VertexID;
#else
    float4 positionOS : POSITION;
    float2 uv : TEXCOORD0;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

#if _USE_DRAW_PROCEDURAL
void GetProceduralQuad(in uint vertexID, out float4 positionCS, out float2 uv)
{
    float4 corner = GetQuadVertexPosition(vertexID); // x and y of 0 to 1, y downwards
    positionCS = float4(2.0 * corner.x - 1.0, 1.0 - 2.0 * corner.y, corner.zw);
    uv = GetQuadTexCoord(vertexID) * _ScaleBias.xy + _ScaleBias.zw;
}
#endif

Varyings FullscreenVert(Attributes input)
{
    Varyings output = (Varyings)0;
#if _USE_DRAW_PROCEDURAL
    GetProceduralQuad(input.vertexID, output.positionCS, output.uv);
#else
    output.uv = input.uv;
    output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
#endif
    return output;
}
Varyings Vert(Attributes input) { return FullscreenVert(input); }
