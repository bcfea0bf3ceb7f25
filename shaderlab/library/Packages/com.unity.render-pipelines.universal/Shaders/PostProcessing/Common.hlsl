// What the passes after the scene share: vertex functions of whole targets, and the steps of grading,
// each from the colour of one pixel. The keywords are those of URP's own passes.
#pragma once
#ifndef UNIVERSAL_POSTPROCESSING_COMMON_INCLUDED
#define UNIVERSAL_POSTPROCESSING_COMMON_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "limn/ProjectVersion.hlsl"
// URP 7 to 13. Where no project tells its version, the name of the vertex function does.
#if limn_UNIVERSAL_VERSION < 14 || defined(limn_Vertex_FullscreenVert)
#include "Packages/com.unity.render-pipelines.universal/Shaders/Utils/Fullscreen.hlsl"
#else
#include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
#endif

// By the weights of the space that tonemapping works in: ACEScg's, or Rec. 709's.
float GetLuminance(float3 colorLinear)
{
#ifdef _TONEMAP_ACES
    return AcesLuminance(colorLinear);
#else
    return Luminance(colorLinear);
#endif
}

// limn's fast curves are the exact ones, so that _USE_FAST_SRGB_LINEAR_CONVERSION chooses nothing.
float3 GetSRGBToLinear(float3 c) { return SRGBToLinear(c); }
float4 GetSRGBToLinear(float4 c) { return SRGBToLinear(c); }
float3 GetLinearToSRGB(float3 c) { return LinearToSRGB(c); }
float4 GetLinearToSRGB(float4 c) { return LinearToSRGB(c); }

// Fades to a colour away from the centre. roundness: how many times faster along u.
float3 ApplyVignette(float3 input, float2 uv, float2 center, float intensity, float roundness,
                     float smoothness, float3 color)
{
    float2 away = (uv - center) * intensity * float2(roundness, 1.0);
    float kept = pow(saturate(1.0 - dot(away, away)), smoothness);
    return input * lerp(color, float3(1, 1, 1), kept);
}

float3 ApplyTonemap(float3 input)
{
#if defined(_TONEMAP_ACES)
    input = AcesTonemap(unity_to_ACES(input));
#elif defined(_TONEMAP_NEUTRAL)
    input = NeutralTonemap(input);
#endif
    return saturate(input);
}

// A strip that the author painted over sRGB values, mixed in by `contribution`.
float3 limn_ApplyUserLut(float3 input, TEXTURE2D_PARAM(lut, lutSampler), float3 params,
                         float contribution)
{
    if (contribution <= 0.0)
    {
        return input;
    }
    float3 encoded = GetLinearToSRGB(saturate(input));
    float3 graded = ApplyLut2D(TEXTURE2D_ARGS(lut, lutSampler), encoded, params);
    return GetSRGBToLinear(lerp(encoded, graded, contribution));
}

// Exposure, then the strip of URP's grading and the author's. With _HDR_GRADING the strip is over
// LogC and tonemaps; else tonemapping comes first and the strip is over linear values.
float3 ApplyColorGrading(float3 input, float postExposure, TEXTURE2D_PARAM(lutTex, lutSampler),
                         float3 lutParams, TEXTURE2D_PARAM(userLutTex, userLutSampler),
                         float3 userLutParams, float userLutContrib)
{
    input *= postExposure;
#ifdef _HDR_GRADING
    float3 logC = saturate(LinearToLogC(input));
    input = ApplyLut2D(TEXTURE2D_ARGS(lutTex, lutSampler), logC, lutParams);
    return limn_ApplyUserLut(input, TEXTURE2D_ARGS(userLutTex, userLutSampler), userLutParams,
                             userLutContrib);
#else
    input = limn_ApplyUserLut(ApplyTonemap(input), TEXTURE2D_ARGS(userLutTex, userLutSampler),
                              userLutParams, userLutContrib);
    return ApplyLut2D(TEXTURE2D_ARGS(lutTex, lutSampler), input, lutParams);
#endif
}

// The texture's alpha is grain about 0.5; response: how much less of it there is where it is bright.
float3 ApplyGrain(float3 input, float2 uv, TEXTURE2D_PARAM(GrainTexture, GrainSampler),
                  float intensity, float response, float2 scale, float2 offset)
{
    float grain = SAMPLE_TEXTURE2D(GrainTexture, GrainSampler, uv * scale + offset).a * 2.0 - 1.0;
    float strength = 1.0 - response * sqrt(Luminance(input));
    return input * (1.0 + grain * intensity * strength);
}

float limn_LuminanceOfNeighbour(int2 pixel, int2 offset, float4 sourceSize, TEXTURE2D_X(source))
{
    int2 neighbour = clamp(pixel + offset, int2(0, 0), int2(sourceSize.xy) - 1);
    return Luminance(saturate(LOAD_TEXTURE2D_X(source, neighbour).rgb));
}

float3 limn_MeanOfTwo(float2 uv, float2 away, TEXTURE2D_X(source))
{
    float3 before = SAMPLE_TEXTURE2D_X_LOD(source, sampler_LinearClamp, uv - away, 0).rgb;
    float3 behind = SAMPLE_TEXTURE2D_X_LOD(source, sampler_LinearClamp, uv + away, 0).rgb;
    return 0.5 * (saturate(before) + saturate(behind));
}

// Fast approximate antialiasing (T. Lottes, NVIDIA 2011: the variant for consoles). Blurs along the
// edge that the luminances of the four diagonal neighbours show, over up to 8 pixels. Where the wide
// blur leaves their range, it has met something else, and the narrow one is taken. Colours are cut
// off at 1. positionNDC: the uv of the pixel positionSS; sourceSize: width, height, 1 / each.
half3 ApplyFXAA(half3 color, float2 positionNDC, int2 positionSS, float4 sourceSize,
                TEXTURE2D_X(inputTexture))
{
    float4 corners = float4( // upper left and right, lower left and right
        limn_LuminanceOfNeighbour(positionSS, int2(-1, -1), sourceSize, inputTexture),
        limn_LuminanceOfNeighbour(positionSS, int2(1, -1), sourceSize, inputTexture),
        limn_LuminanceOfNeighbour(positionSS, int2(-1, 1), sourceSize, inputTexture),
        limn_LuminanceOfNeighbour(positionSS, int2(1, 1), sourceSize, inputTexture));
    float2 along = float2(dot(corners, float4(-1, -1, 1, 1)), dot(corners, float4(1, -1, 1, -1)));
    float least = max(dot(corners, 0.25 / 8.0), 1.0 / 128.0); // keeps noise in the dark small
    along = clamp(along / (min(abs(along.x), abs(along.y)) + least), -8.0, 8.0) * sourceSize.zw;

    float3 narrow = limn_MeanOfTwo(positionNDC, along / 6.0, inputTexture);
    float3 wide = 0.5 * narrow + 0.5 * limn_MeanOfTwo(positionNDC, along / 2.0, inputTexture);
    float middle = Luminance(saturate(color));
    float darkest = min(middle, min(min(corners.x, corners.y), min(corners.z, corners.w)));
    float brightest = max(middle, max(max(corners.x, corners.y), max(corners.z, corners.w)));
    float blurred = Luminance(wide);
    return blurred < darkest || blurred > brightest ? narrow : wide;
}

// Noise of up to one step of 8 bits in sRGB. The texture's alpha is even noise; what is added falls
// off evenly from 0 to both sides.
float3 ApplyDithering(float3 input, float2 uv, TEXTURE2D_PARAM(BlueNoiseTexture, BlueNoiseSampler),
                      float2 scale, float2 offset)
{
    float even =
        SAMPLE_TEXTURE2D(BlueNoiseTexture, BlueNoiseSampler, uv * scale + offset).a * 2.0 - 1.0;
    float noise = FastSign(even) * (1.0 - sqrt(1.0 - abs(even)));
    return GetSRGBToLinear(GetLinearToSRGB(input) + noise / 255.0);
}
#endif
