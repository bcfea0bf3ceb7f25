// Normals out of the depth texture, for passes without a texture of normals. They are in world
// space; "ViewSpacePos" is the way from the camera to the surface, along the axes of the world.
// Unity's own text has a matrix for this that a C# class must set; here the camera's matrices do.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"

float GetRawDepth(float2 uv)
{
    return SAMPLE_TEXTURE2D_X_LOD(_CameraDepthTexture, sampler_PointClamp, uv, 0).r;
}

float3 ViewSpacePosAtScreenUV(float2 uv)
{
    return ComputeWorldSpacePosition(uv, GetRawDepth(uv), UNITY_MATRIX_I_VP) - _WorldSpaceCameraPos;
}

// positionSS: as SV_Position has it, in pixels.
float3 ViewSpacePosAtPixelPosition(float2 positionSS)
{
    return ViewSpacePosAtScreenUV(positionSS * _ScreenSize.zw);
}

// Across to the right and down the screen in this order, so that the normal looks at the camera.
float3 limn_NormalOf(float3 right, float3 down) { return SafeNormalize(cross(right, down)); }

// Flat over blocks of 2x2 pixels.
float3 ReconstructNormalDerivative(float2 positionSS)
{
    float3 position = ViewSpacePosAtPixelPosition(positionSS);
    return limn_NormalOf(ddx(position), ddy(position));
}

// To the next pixel; edges bleed into the pixel before them.
float3 ReconstructNormalTap3(float2 positionSS)
{
    float3 centre = ViewSpacePosAtPixelPosition(positionSS);
    return limn_NormalOf(ViewSpacePosAtPixelPosition(positionSS + float2(1, 0)) - centre,
                         ViewSpacePosAtPixelPosition(positionSS + float2(0, 1)) - centre);
}

// Between both neighbours: smooth, and wrong on both sides of an edge.
float3 ReconstructNormalTap4(float2 positionSS)
{
    return limn_NormalOf(ViewSpacePosAtPixelPosition(positionSS + float2(1, 0)) -
                             ViewSpacePosAtPixelPosition(positionSS - float2(1, 0)),
                         ViewSpacePosAtPixelPosition(positionSS + float2(0, 1)) -
                             ViewSpacePosAtPixelPosition(positionSS - float2(0, 1)));
}

// To the neighbour whose z is closer, on each axis.
float3 limn_CloserStep(float2 positionSS, float2 pixel)
{
    float3 centre = ViewSpacePosAtPixelPosition(positionSS);
    float3 back = centre - ViewSpacePosAtPixelPosition(positionSS - pixel);
    float3 ahead = ViewSpacePosAtPixelPosition(positionSS + pixel) - centre;
    return abs(back.z) < abs(ahead.z) ? back : ahead;
}
float3 ReconstructNormalTap5(float2 positionSS)
{
    return limn_NormalOf(limn_CloserStep(positionSS, float2(1, 0)),
                         limn_CloserStep(positionSS, float2(0, 1)));
}

// To the neighbour on whose side two pixels foretell the depth of this one better: sharp at edges.
float3 limn_StraighterStep(float2 positionSS, float2 pixel)
{
    float2 uv = positionSS * _ScreenSize.zw;
    float2 stepUV = pixel * _ScreenSize.zw;
    float depth = GetRawDepth(uv);
    float behind = 2.0 * GetRawDepth(uv - stepUV) - GetRawDepth(uv - 2.0 * stepUV);
    float beyond = 2.0 * GetRawDepth(uv + stepUV) - GetRawDepth(uv + 2.0 * stepUV);
    float3 centre = ViewSpacePosAtScreenUV(uv);
    return abs(behind - depth) < abs(beyond - depth)
               ? centre - ViewSpacePosAtScreenUV(uv - stepUV)
               : ViewSpacePosAtScreenUV(uv + stepUV) - centre;
}
float3 ReconstructNormalTap9(float2 positionSS)
{
    return limn_NormalOf(limn_StraighterStep(positionSS, float2(1, 0)),
                         limn_StraighterStep(positionSS, float2(0, 1)));
}
