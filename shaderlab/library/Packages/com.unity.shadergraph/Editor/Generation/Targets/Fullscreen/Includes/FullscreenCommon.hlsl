// What full-screen passes of shader graphs share. The graph declares _FlipY itself: 0 where the first
// row is the uppermost.
#pragma once
#define FULLSCREEN_COMMON_INCLUDED

struct FragOutput
{
    float4 color : SV_TARGET;
#ifdef DEPTH_WRITE
    float depth : DEPTH_OFFSET_SEMANTIC;
#endif
};

float3 limn_Without(float4 row, int column)
{
    return column == 0 ? row.yzw : column == 1 ? row.xzw : column == 2 ? row.xyw : row.xyz;
}

// By cofactors; for the three vertices of a pass.
float4x4 inverse(float4x4 m)
{
    float4x4 adjugate;
    [unroll] for (int row = 0; row < 4; ++row)
    {
        float4 others[3] = {m[row == 0 ? 1 : 0], m[row <= 1 ? 2 : 1], m[row == 3 ? 2 : 3]};
        [unroll] for (int column = 0; column < 4; ++column)
        {
            float minor = dot(limn_Without(others[0], column),
                              cross(limn_Without(others[1], column),
                                    limn_Without(others[2], column)));
            adjugate[column][row] = ((row + column) & 1) == 0 ? minor : -minor;
        }
    }
    return adjugate / dot(m[0], mul(adjugate, float4(1, 0, 0, 0)));
}

float4 limn_FullscreenUV(float4 positionCS)
{
    float4 uv = positionCS * 0.5 + 0.5;
#if UNITY_UV_STARTS_AT_TOP
    uv.y = _FlipY < 0.5 ? 1.0 - uv.y : uv.y;
#endif
    return uv;
}

// texCoord1: a direction along the line of sight.
void BuildVaryings(Attributes input, inout Varyings output)
{
    output.texCoord0 = limn_FullscreenUV(output.positionCS);
    float3 positionWS = ComputeWorldSpacePosition(output.positionCS, UNITY_MATRIX_I_VP);
    output.texCoord1.xyz = GetWorldSpaceViewDir(positionWS);
}

// The same for pipelines that do not set the inverse matrices.
void BuildVaryingsWithoutInverseProjection(Attributes input, inout Varyings output)
{
    output.texCoord0 = limn_FullscreenUV(output.positionCS);
    float3 directionVS = mul(inverse(UNITY_MATRIX_P), float4(output.positionCS.xyz, 1.0)).xyz;
    output.texCoord1.xyz = mul((float3x3)inverse(UNITY_MATRIX_V), directionVS);
}

float4 GetDrawProceduralVertexPosition(uint vertexID)
{
    return GetFullScreenTriangleVertexPosition(vertexID, UNITY_NEAR_CLIP_VALUE);
}
float4 GetBlitVertexPositionFromPositionOS(float3 positionOS)
{
    return float4(2.0 * positionOS.xy - 1.0, UNITY_NEAR_CLIP_VALUE, 1.0);
}
float4 GetBlitVertexPosition(uint vertexID)
{
    return GetBlitVertexPositionFromPositionOS(GetQuadVertexPosition(vertexID).xyz);
}

#ifdef DEPTH_WRITE
// The depth that the graph names by its distance, or as it is stored.
float limn_FullscreenDepth(SurfaceDescription surface)
{
#if defined(DEPTH_WRITE_MODE_EYE)
    return (rcp(max(surface.FullscreenEyeDepth, 1e-9)) - _ZBufferParams.w) / _ZBufferParams.z;
#elif defined(DEPTH_WRITE_MODE_LINEAR01)
    return (rcp(max(surface.FullscreenLinear01Depth, 1e-9)) - _ZBufferParams.y) / _ZBufferParams.x;
#elif defined(DEPTH_WRITE_MODE_RAW)
    return surface.FullscreenRawDepth;
#else
    return 0.0;
#endif
}
#endif

FragOutput DefaultFullscreenFragmentShader(PackedVaryings packedInput)
{
    SurfaceDescription surface =
        SurfaceDescriptionFunction(BuildSurfaceDescriptionInputs(UnpackVaryings(packedInput)));
    FragOutput output;
    output.color = float4(surface.BaseColor, surface.Alpha);
#ifdef DEPTH_WRITE
    output.depth = limn_FullscreenDepth(surface);
#endif
    return output;
}
