// A pass over the whole target without a vertex buffer.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

struct Attributes
{
    uint vertexID : SV_VertexID;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 positionCS : SV_POSITION;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings FullscreenVert(Attributes input)
{
    float4 corner = GetQuadVertexPosition(input.vertexID); // x and y of 0 or 1
    Varyings output = (Varyings)0;
    output.uv = GetQuadTexCoord(input.vertexID);
    output.positionCS = float4(2.0 * corner.xy - 1.0, corner.zw);
    return output;
}
Varyings Vert(Attributes input) { return FullscreenVert(input); }
