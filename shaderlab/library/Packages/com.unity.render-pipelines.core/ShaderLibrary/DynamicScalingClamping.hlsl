// Keeps texture coordinates within the used part of a texture that may be larger than the picture.
// Textures are as large as the picture here, so every scale is 1; what remains is that a filter
// does not reach across the right and the upper edge.
#pragma once
#ifndef DYNAMIC_SCALING_CLAMPING_HLSL
#define DYNAMIC_SCALING_CLAMPING_HLSL

float2 ClampAndScaleUV(float2 UV, float2 texelSize, float numberOfTexels, float2 scale)
{
    return scale * min(UV, 1.0 - texelSize * numberOfTexels);
}
float2 ClampAndScaleUV(float2 UV, float2 texelSize, float numberOfTexels)
{
    return ClampAndScaleUV(UV, texelSize, numberOfTexels, 1.0);
}
float2 ClampUV(float2 UV, float2 texelSize, float numberOfTexels)
{
    return ClampAndScaleUV(UV, texelSize, numberOfTexels);
}
float2 ClampAndScaleUVPostProcessTexture(float2 UV, float2 texelSize, float numberOfTexels)
{
    return ClampAndScaleUV(UV, texelSize, numberOfTexels);
}

// A bilinear filter reaches half a texel; those without a size take the screen's.
float2 ClampUVForBilinear(float2 UV, float2 texelSize) { return ClampUV(UV, texelSize, 0.5); }
float2 ClampUVForBilinear(float2 UV) { return ClampUVForBilinear(UV, _ScreenSize.zw); }
float2 ClampAndScaleUVForBilinear(float2 UV, float2 texelSize)
{
    return ClampUVForBilinear(UV, texelSize);
}
float2 ClampAndScaleUVForBilinear(float2 UV) { return ClampUVForBilinear(UV); }
float2 ClampAndScaleUVForBilinearPostProcessTexture(float2 UV, float2 texelSize)
{
    return ClampUVForBilinear(UV, texelSize);
}
float2 ClampAndScaleUVForBilinearPostProcessTexture(float2 UV) { return ClampUVForBilinear(UV); }
float2 ClampAndScaleUVForPoint(float2 UV) { return min(UV, 1.0); }
float2 ClampAndScaleUVPostProcessTextureForPoint(float2 UV) { return min(UV, 1.0); }

#endif
