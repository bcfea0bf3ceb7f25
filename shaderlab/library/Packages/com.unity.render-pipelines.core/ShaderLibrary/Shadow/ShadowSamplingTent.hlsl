// Weights of shadow maps' texels under a tent of 3, 5 or 7 texels, and the bilinear fetches that
// stand for them two by two. A tent of half width h has height h; offset: of its middle from the
// edge between the two middle texels, -0.5...0.5.
#pragma once
#ifndef SHADOW_SAMPLING_TENT_INCLUDED
#define SHADOW_SAMPLING_TENT_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// Area of the tent left of x, over all of it.
float limn_TentUpTo(float x, float h)
{
    float side = h - min(abs(x), h);
    float outside = 0.5 * side * side / (h * h);
    return x < 0.0 ? outside : 1.0 - outside;
}
float limn_TentTexel(int texel, float offset, float h)
{
    float left = texel - h - 0.5 - offset;
    return limn_TentUpTo(left + 1.0, h) - limn_TentUpTo(left, h);
}
// Weight of fetch i, and where it lies from the middle edge.
float2 limn_TentFetch(int i, float offset, float h)
{
    float first = limn_TentTexel(2 * i, offset, h);
    float second = limn_TentTexel(2 * i + 1, offset, h);
    return float2(first + second, second / (first + second) + 2 * i - h);
}

float SampleShadow_GetTriangleTexelArea(float triangleHeight) { return triangleHeight - 0.5; }
// computedAreaUncut: as if the tent's slopes went on over the two middle texels.
void SampleShadow_GetTexelAreas_Tent_3x3(float offset, out float4 computedArea,
                                         out float4 computedAreaUncut)
{
    computedArea = 2.25 * float4(limn_TentTexel(0, offset, 1.5), limn_TentTexel(1, offset, 1.5),
                                 limn_TentTexel(2, offset, 1.5), limn_TentTexel(3, offset, 1.5));
    computedAreaUncut = float4(computedArea.x, 1.0 - offset, 1.0 + offset, computedArea.w);
}
void SampleShadow_GetTexelWeights_Tent_3x3(float offset, out float4 computedWeight)
{
    computedWeight = float4(limn_TentTexel(0, offset, 1.5), limn_TentTexel(1, offset, 1.5),
                            limn_TentTexel(2, offset, 1.5), limn_TentTexel(3, offset, 1.5));
}
void SampleShadow_GetTexelWeights_Tent_5x5(float offset, out float3 texelsWeightsA,
                                           out float3 texelsWeightsB)
{
    texelsWeightsA = float3(limn_TentTexel(0, offset, 2.5), limn_TentTexel(1, offset, 2.5),
                            limn_TentTexel(2, offset, 2.5));
    texelsWeightsB = float3(limn_TentTexel(3, offset, 2.5), limn_TentTexel(4, offset, 2.5),
                            limn_TentTexel(5, offset, 2.5));
}
void SampleShadow_GetTexelWeights_Tent_7x7(float offset, out float4 texelsWeightsA,
                                           out float4 texelsWeightsB)
{
    texelsWeightsA = float4(limn_TentTexel(0, offset, 3.5), limn_TentTexel(1, offset, 3.5),
                            limn_TentTexel(2, offset, 3.5), limn_TentTexel(3, offset, 3.5));
    texelsWeightsB = float4(limn_TentTexel(4, offset, 3.5), limn_TentTexel(5, offset, 3.5),
                            limn_TentTexel(6, offset, 3.5), limn_TentTexel(7, offset, 3.5));
}

// A row of `across` fetches after the other.
#define limn_TENT_SAMPLES(across, h) \
    float2 middle = coord * shadowMapTexture_TexelSize.zw; \
    float2 edge = floor(middle + 0.5); \
    float2 offset = middle - edge; \
    for (int i = 0; i < across * across; ++i) \
    { \
        float2 u = limn_TentFetch(i % across, offset.x, h); \
        float2 v = limn_TentFetch(i / across, offset.y, h); \
        fetchesWeights[i] = u.x * v.x; \
        fetchesUV[i] = (edge + float2(u.y, v.y)) * shadowMapTexture_TexelSize.xy; \
    }
void SampleShadow_ComputeSamples_Tent_3x3(float4 shadowMapTexture_TexelSize, float2 coord,
                                          out float fetchesWeights[4], out float2 fetchesUV[4])
{
    limn_TENT_SAMPLES(2, 1.5)
}
void SampleShadow_ComputeSamples_Tent_5x5(float4 shadowMapTexture_TexelSize, float2 coord,
                                          out float fetchesWeights[9], out float2 fetchesUV[9])
{
    limn_TENT_SAMPLES(3, 2.5)
}
void SampleShadow_ComputeSamples_Tent_7x7(float4 shadowMapTexture_TexelSize, float2 coord,
                                          out float fetchesWeights[16], out float2 fetchesUV[16])
{
    limn_TENT_SAMPLES(4, 3.5)
}
#endif
