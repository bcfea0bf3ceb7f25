// Where the screen and the depth buffer are met: one home for both pipelines. The core package
// brings this in; it must declare no uniform, as authors who have that package alone declare theirs.
#pragma once

#include "limn/Platform.hlsl"

// Texture coordinate of the screen, times w; v = 0 is the bottom of the picture. projectionSign is
// _ProjectionParams.x, of the target that is drawn into.
float4 limn_ScreenPos(float4 positionCS, float projectionSign)
{
    float2 ndc = float2(positionCS.x, positionCS.y * projectionSign);
    return float4(ndc * 0.5 + positionCS.w * 0.5, positionCS.zw);
}

// What the depth buffer holds as 1 near ... 0 far, whichever way round it is; leads back as well.
float limn_Nearness(float depth)
{
#if defined(UNITY_REVERSED_Z)
    return depth;
#else
    return 1.0 - depth;
#endif
}

// What the rounding of a depth is proportional to: floats are finest around 0, which is far where z
// is reversed and near where it is not.
float limn_DepthMagnitude(float nearness)
{
#if defined(UNITY_REVERSED_Z)
    return nearness;
#else
    return 1.0;
#endif
}

// 0 at the camera, 1 at the far plane; perspective. zBufferParams is _ZBufferParams.
float limn_Linear01Depth(float depth, float4 zBufferParams)
{
    return 1.0 / (zBufferParams.x * depth + zBufferParams.y);
}

// Distance along the view axis; perspective.
float limn_LinearEyeDepth(float depth, float4 zBufferParams)
{
    return 1.0 / (zBufferParams.z * depth + zBufferParams.w);
}

// Distance along the view axis from what clip space has in z; any distance behind the near plane
// is 0. projectionParams is _ProjectionParams.
float limn_DistanceFromClipZ(float clipZ, float4 projectionParams)
{
#if defined(UNITY_REVERSED_Z)
    return max((1.0 - clipZ / projectionParams.y) * projectionParams.z, 0.0);
#else
    return max(clipZ, 0.0);
#endif
}
