// Depth buffer values and positions. zBufferParam is _ZBufferParams.
#pragma once

#include "limn/Screen.hlsl"

// 0 at the camera, 1 at the far plane; perspective.
float Linear01Depth(float depth, float4 zBufferParam)
{
    return limn_Linear01Depth(depth, zBufferParam);
}

// 0 at the near plane, 1 at the far plane; perspective.
float Linear01DepthFromNear(float depth, float4 zBufferParam)
{
    return (1.0 - limn_Nearness(depth)) / (zBufferParam.x * depth + zBufferParam.y);
}

// Distance along the view axis; perspective.
float LinearEyeDepth(float depth, float4 zBufferParam)
{
    return limn_LinearEyeDepth(depth, zBufferParam);
}

// Distance along the view axis; any projection.
float LinearEyeDepth(float3 positionWS, float4x4 viewMatrix)
{
    return abs(mul(viewMatrix, float4(positionWS, 1.0)).z);
}

// A texture coordinate of the screen, v = 0 at the top, and a depth buffer value.
float4 ComputeClipSpacePosition(float2 positionNDC, float deviceDepth)
{
    return float4(positionNDC.x * 2.0 - 1.0, 1.0 - positionNDC.y * 2.0, deviceDepth, 1.0);
}

// Without a transform the position is one of clip space, whose w is 1.
float4 ComputeClipSpacePosition(float3 position) { return float4(position, 1.0); }
float4 ComputeClipSpacePosition(float3 position, float4x4 clipSpaceTransform)
{
    return mul(clipSpaceTransform, float4(position, 1.0));
}

float3 ComputeNormalizedDeviceCoordinatesWithZ(float4 positionCS)
{
    float3 divided = positionCS.xyz / positionCS.w;
    return float3(divided.x * 0.5 + 0.5, 0.5 - divided.y * 0.5, divided.z);
}

float3 ComputeNormalizedDeviceCoordinatesWithZ(float3 position, float4x4 clipSpaceTransform)
{
    return ComputeNormalizedDeviceCoordinatesWithZ(
        ComputeClipSpacePosition(position, clipSpaceTransform));
}

float3 ComputeNormalizedDeviceCoordinatesWithZ(float3 position)
{
    return ComputeNormalizedDeviceCoordinatesWithZ(ComputeClipSpacePosition(position));
}

float2 ComputeNormalizedDeviceCoordinates(float3 position, float4x4 clipSpaceTransform)
{
    return ComputeNormalizedDeviceCoordinatesWithZ(position, clipSpaceTransform).xy;
}

float2 ComputeNormalizedDeviceCoordinates(float3 position)
{
    return ComputeNormalizedDeviceCoordinatesWithZ(position).xy;
}

float3 ComputeWorldSpacePosition(float4 positionCS, float4x4 invViewProjMatrix)
{
    float4 hpositionWS = mul(invViewProjMatrix, positionCS);
    return hpositionWS.xyz / hpositionWS.w;
}
float3 ComputeWorldSpacePosition(float2 positionNDC, float deviceDepth, float4x4 invViewProjMatrix)
{
    float4 hpositionWS =
        mul(invViewProjMatrix, ComputeClipSpacePosition(positionNDC, deviceDepth));
    return hpositionWS.xyz / hpositionWS.w;
}

// Positive forward, unlike the view matrix.
float3 ComputeViewSpacePosition(float2 positionNDC, float deviceDepth, float4x4 invProjMatrix)
{
    float4 positionVS = mul(invProjMatrix, ComputeClipSpacePosition(positionNDC, deviceDepth));
    return float3(positionVS.xy, -positionVS.z) / positionVS.w;
}
