// Where the depth or the normals of the picture change around a point of the screen: a share of
// 0...1 that an object's material or a pass of its own blends an outline colour by. Two ways: with
// the article's arithmetic and parameters, and hardened, with thresholds in metres and degrees.
// Depths are 1 near ... 0 far here, whichever way round the device's are.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareNormalsTexture.hlsl"
#include "limn/BuiltinEncoding.hlsl"
#include "limn/Screen.hlsl"

TEXTURE2D_X(_CameraDepthNormalsTexture);
SAMPLER(sampler_CameraDepthNormalsTexture);

float3 limn_ViewNormal(float2 uv)
{
    return DecodeViewNormalStereo(SAMPLE_TEXTURE2D_X_LOD(
        _CameraDepthNormalsTexture, sampler_CameraDepthNormalsTexture, uv, 0));
}

float limn_Depth(float2 uv)
{
    return limn_Nearness(
        SAMPLE_TEXTURE2D_X_LOD(_CameraDepthTexture, sampler_CameraDepthTexture, uv, 0).r);
}

float limn_DepthOf(uint2 pixel) { return limn_Nearness(LoadSceneDepth(pixel)); }

// The article's: 1 where a difference across is above its threshold, else 0. A sensitivity that is
// not above 0 finds nothing.
// UV: of the screen; OutlineThickness: how far the taps lie apart, pixels
// DepthSensitivity: 0...1, 0.2 is a good one; NormalsSensitivity: 0...1
void OutlineObject_float(float2 UV, float OutlineThickness, float DepthSensitivity,
                         float NormalsSensitivity, out float Out)
{
    float2 low = -_CameraDepthTexture_TexelSize.xy * floor(OutlineThickness * 0.5);
    float2 high = _CameraDepthTexture_TexelSize.xy * ceil(OutlineThickness * 0.5);
    float2 first = UV + low;
    float2 last = UV + high;
    float2 rising = UV + float2(high.x, low.y);
    float2 falling = UV + float2(low.x, high.y);

    float depth = limn_Depth(first);
    float2 steps = float2(limn_Depth(last) - depth, limn_Depth(falling) - limn_Depth(rising));
    float3 along = limn_ViewNormal(last) - limn_ViewNormal(first);
    float3 across = limn_ViewNormal(falling) - limn_ViewNormal(rising);
    // The article divides by the sensitivities: this is the same, but where they are 0.
    bool isDepthEdge = DepthSensitivity > 0.0 && length(steps) * 100.0 * DepthSensitivity > depth;
    bool isNormalEdge = sqrt(dot(along, along) + dot(across, across)) * NormalsSensitivity > 1.0;
    Out = isDepthEdge || isNormalEdge ? 1.0 : 0.0;
}

// Distance along the view axis; any projection.
float limn_EyeDepth(float depth)
{
    return unity_OrthoParams.w == 0.0 ? LinearEyeDepth(limn_Nearness(depth), _ZBufferParams)
                                      : lerp(_ProjectionParams.z, _ProjectionParams.y, depth);
}

// Metres between a depth and the one that is expected, beyond what is not known of them.
// A difference of distances would lose what is far away to rounding; this is a product.
float limn_Gap(float depth, float expected, float unknown)
{
    float difference = max(abs(depth - expected) - unknown, 0.0);
    return unity_OrthoParams.w == 0.0
               ? difference * abs(_ZBufferParams.z) * limn_EyeDepth(depth) * limn_EyeDepth(expected)
               : difference * (_ProjectionParams.z - _ProjectionParams.y);
}

// How far the surface leaves the plane that it has at a pixel, metres: of three depths in a row the
// outer one that is farther off. Depth is affine in screen space on a plane, however it lies, so
// that this is 0 there. A plane that goes on behind the far plane is as the background.
float limn_Step(float before, float center, float behind, float unknown)
{
    float gapBefore = limn_Gap(before, saturate(2.0 * center - behind), unknown);
    float gapBehind = limn_Gap(behind, saturate(2.0 * center - before), unknown);
    bool isBehind = abs(behind - center) > abs(before - center);
    return min(gapBefore, gapBehind) > 0.0 ? (isBehind ? gapBehind : gapBefore) : 0.0;
}

// Depths left, right, up and down of a pixel.
float4 limn_DepthsAround(int2 pixel, int2 taps)
{
    uint2 low = uint2(pixel - taps);
    uint2 high = uint2(pixel + taps);
    return float4(limn_DepthOf(uint2(low.x, pixel.y)), limn_DepthOf(uint2(high.x, pixel.y)),
                  limn_DepthOf(uint2(pixel.x, low.y)), limn_DepthOf(uint2(pixel.x, high.y)));
}

// The largest step from a pixel of the background, where only samples of it see an object: what is
// around ends here, unless it is a plane that goes on behind the far plane.
float limn_StepFromBackground(int2 pixel, int2 taps)
{
    float4 around = limn_DepthsAround(pixel, taps);
    float4 slope = around - limn_DepthsAround(pixel, taps * 2);
    float4 expected = saturate(around + slope);
    float4 unknown = abs(slope) / 64.0;
    return max(max(limn_Gap(0.0, expected.x, unknown.x), limn_Gap(0.0, expected.y, unknown.y)),
               max(limn_Gap(0.0, expected.z, unknown.z), limn_Gap(0.0, expected.w, unknown.w)));
}

// The cosine between two normals of any length; 1 where there is none.
float limn_CosineBetween(float3 a, float3 b)
{
    float lengths = dot(a, a) * dot(b, b);
    return lengths > 0.25 ? dot(a, b) * rsqrt(lengths) : 1.0;
}

// The largest step (metres) and angle (degrees) between a pixel and those `reach` pixels from it,
// fewer where the picture ends before that.
float2 limn_StepAndAngle(float2 uv, float reach)
{
    float2 size = _CameraDepthTexture_TexelSize.zw;
    int2 pixel = clamp(int2(uv * size), int2(0, 0), int2(size) - 1);
    int2 room = min(pixel, int2(size) - 1 - pixel);
    int2 taps = min(int2(reach, reach), room);
    float center = limn_DepthOf(uint2(pixel));
    if (center == 0.0)
    {
        return float2(limn_StepFromBackground(pixel, min(taps, room / 2)), 0.0);
    }
    float4 around = limn_DepthsAround(pixel, taps);
    float4 differences = abs(around - center);
    // The smaller difference is the slope of the surface itself. It is not known better than
    // vertices are placed, which devices do to 1/256 pixel, nor depth better than a float is
    // rounded that was computed from the picture's corner.
    float2 slope = min(differences.xz, differences.yw);
    float most = max(center, max(max(around.x, around.y), max(around.z, around.w)));
    float corner = most + dot(slope / max(float2(taps), 1.0), size);
    float unknown = (slope.x + slope.y) / 64.0 + limn_DepthMagnitude(corner) * 4.8e-7; // 8 / 2^24
    float step = max(limn_Step(around.x, center, around.y, unknown),
                     limn_Step(around.z, center, around.w, unknown));

    float3 normal = LoadSceneNormals(uint2(pixel));
    uint2 low = uint2(pixel - taps);
    uint2 high = uint2(pixel + taps);
    float least =
        min(min(limn_CosineBetween(normal, LoadSceneNormals(uint2(low.x, pixel.y))),
                limn_CosineBetween(normal, LoadSceneNormals(uint2(high.x, pixel.y)))),
            min(limn_CosineBetween(normal, LoadSceneNormals(uint2(pixel.x, low.y))),
                limn_CosineBetween(normal, LoadSceneNormals(uint2(pixel.x, high.y)))));
    return float2(step, degrees(acos(clamp(least, -1.0, 1.0))));
}

// 0 up to a threshold, 1 from so much above it on. No threshold, or one below 0: nothing.
float limn_Above(float value, float threshold, float softness)
{
    float from = threshold >= 0.0 ? threshold : 1e30;
    return saturate((value - from) / max(softness > 0.0 ? from * softness : 0.0, 1e-6));
}

float limn_EdgeAt(float2 uv, float reach, float depthThreshold, float angleThreshold,
                  float softness)
{
    float2 found = limn_StepAndAngle(uv, reach);
    return max(limn_Above(found.x, depthThreshold, softness),
               limn_Above(found.y, angleThreshold, softness));
}

// Hardened: nothing on planes at whatever angle, creases and steps by what they are in the world.
// OutlineWidth: of a line along a crease, pixels, half of it on each side
// DepthThreshold: metres that a surface has to leave its plane by; AngleThreshold: degrees
// Softness: how far above its threshold, as a share of it, something counts in full
void OutlineObjectHardened_float(float2 UV, float OutlineWidth, float DepthThreshold,
                                 float AngleThreshold, float Softness, out float Out)
{
    float halfWidth = OutlineWidth > 0.0 ? min(OutlineWidth, 16384.0) * 0.5 : 0.0;
    float reach = max(floor(halfWidth), 1.0);
    float part = saturate(halfWidth - reach);
    float edge = limn_EdgeAt(UV, reach, DepthThreshold, AngleThreshold, Softness);
    if (part > 0.0)
    {
        edge = lerp(edge, limn_EdgeAt(UV, reach + 1.0, DepthThreshold, AngleThreshold, Softness),
                    part);
    }
    // Nearer as well: taps may lie behind what ends in between.
    [loop] for (reach = floor(reach * 0.5); reach >= 1.0 && edge < 1.0; reach = floor(reach * 0.5))
    {
        edge = max(edge, limn_EdgeAt(UV, reach, DepthThreshold, AngleThreshold, Softness));
    }
    Out = edge * min(halfWidth, 1.0);
}
