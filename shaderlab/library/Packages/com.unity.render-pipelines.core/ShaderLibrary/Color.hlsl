#pragma once
#ifndef UNITY_COLOR_INCLUDED
#define UNITY_COLOR_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/ACES.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

float SRGBToLinear(float c)
{
    return c <= 0.04045 ? c / 12.92 : pow(abs((c + 0.055) / 1.055), 2.4);
}
float3 SRGBToLinear(float3 c)
{
    return float3(SRGBToLinear(c.r), SRGBToLinear(c.g), SRGBToLinear(c.b));
}
float4 SRGBToLinear(float4 c) { return float4(SRGBToLinear(c.rgb), c.a); }

float LinearToSRGB(float c)
{
    return c <= 0.0031308 ? c * 12.92 : 1.055 * pow(abs(c), 1.0 / 2.4) - 0.055;
}
float3 LinearToSRGB(float3 c)
{
    return float3(LinearToSRGB(c.r), LinearToSRGB(c.g), LinearToSRGB(c.b));
}
float4 LinearToSRGB(float4 c) { return float4(LinearToSRGB(c.rgb), c.a); }

float Gamma22ToLinear(float c) { return pow(abs(c), 2.2); }
float3 Gamma22ToLinear(float3 c) { return pow(abs(c), 2.2); }
float LinearToGamma22(float c) { return pow(abs(c), 1.0 / 2.2); }
float3 LinearToGamma22(float3 c) { return pow(abs(c), 1.0 / 2.2); }

// Rec. 709 weights, linear colours
float Luminance(float3 linearRgb)
{
    return dot(linearRgb, float3(0.2126729, 0.7151522, 0.0721750));
}
float Luminance(float4 linearRgba) { return Luminance(linearRgba.rgb); }
// The weights of ACEScg
float AcesLuminance(float3 linearRgb) { return dot(linearRgb, AP1_RGB2Y); }
float AcesLuminance(float4 linearRgba) { return AcesLuminance(linearRgba.rgb); }

// What the three kinds of cones see of a linear colour, by CAT02; and back.
float3 LinearToLMS(float3 x)
{
    return mul(float3x3(0.390405, 0.549941, 0.00892632, 0.0708416, 0.963172, 0.00135775, 0.0231082,
                        0.128021, 0.936245), x);
}
float3 LMSToLinear(float3 x)
{
    return mul(float3x3(2.85847, -1.62879, -0.024891, -0.210182, 1.1582, 0.000324281, -0.041812,
                        -0.118169, 1.06867), x);
}

// Moves a colour towards the grey that is the mean of its channels: 1 leaves it as it is.
float3 Desaturate(float3 value, float saturation)
{
    return lerp(((value.r + value.g + value.b) / 3.0).xxx, value, saturation);
}

float3 HsvToRgb(float3 c)
{
    float3 distance = abs(frac(c.xxx + float3(1.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0);
    return c.z * lerp(float3(1, 1, 1), saturate(distance - 1.0), c.y);
}

float3 RgbToHsv(float3 c)
{
    float high = max(c.r, max(c.g, c.b));
    float range = high - min(c.r, min(c.g, c.b));
    float safeRange = max(range, 1e-10);
    float hue = high == c.r   ? (c.g - c.b) / safeRange
                : high == c.g ? (c.b - c.r) / safeRange + 2.0
                              : (c.r - c.g) / safeRange + 4.0;
    return float3(frac(hue / 6.0), range / max(high, 1e-10), high);
}

float2 SRGBToLinear(float2 c) { return float2(SRGBToLinear(c.x), SRGBToLinear(c.y)); }
float2 LinearToSRGB(float2 c) { return float2(LinearToSRGB(c.x), LinearToSRGB(c.y)); }
float2 Gamma22ToLinear(float2 c) { return pow(abs(c), 2.2); }
float4 Gamma22ToLinear(float4 c) { return float4(Gamma22ToLinear(c.rgb), c.a); }
float2 LinearToGamma22(float2 c) { return pow(abs(c), 1.0 / 2.2); }
float4 LinearToGamma22(float4 c) { return float4(LinearToGamma22(c.rgb), c.a); }
float Gamma20ToLinear(float c) { return c * c; }
float3 Gamma20ToLinear(float3 c) { return c * c; }
float4 Gamma20ToLinear(float4 c) { return float4(c.rgb * c.rgb, c.a); }
float LinearToGamma20(float c) { return sqrt(c); }
float3 LinearToGamma20(float3 c) { return sqrt(c); }
float4 LinearToGamma20(float4 c) { return float4(sqrt(c.rgb), c.a); }

// The exact curves: these names promise speed, not an error.
float FastSRGBToLinear(float c) { return SRGBToLinear(c); }
float3 FastSRGBToLinear(float3 c) { return SRGBToLinear(c); }
float4 FastSRGBToLinear(float4 c) { return SRGBToLinear(c); }
float FastLinearToSRGB(float c) { return LinearToSRGB(c); }
float3 FastLinearToSRGB(float3 c) { return LinearToSRGB(c); }
float4 FastLinearToSRGB(float4 c) { return LinearToSRGB(c); }

// A colour into one luma and two differences, and back.
float3 RGBToYCoCg(float3 rgb)
{
    return float3(dot(rgb, float3(0.25, 0.5, 0.25)), 0.5 * (rgb.r - rgb.b) + 128.0 / 255.0,
                  dot(rgb, float3(-0.25, 0.5, -0.25)) + 128.0 / 255.0);
}
float3 YCoCgToRGB(float3 yCoCg)
{
    float co = yCoCg.y - 128.0 / 255.0;
    float cg = yCoCg.z - 128.0 / 255.0;
    return float3(yCoCg.x + co - cg, yCoCg.x + cg, yCoCg.x - co - cg);
}

// ALEXA LogC of exposure index 1000 (ARRI 2012): a logarithm with a straight foot.
#define limn_LogCCut 0.011361
#define limn_LogCA 5.555556
#define limn_LogCB 0.047996
#define limn_LogCC 0.244161
#define limn_LogCD 0.386036
float3 LinearToLogC(float3 x)
{
    return limn_LogCC * log10(max(limn_LogCA * x + limn_LogCB, 0.0)) + limn_LogCD;
}
float3 LogCToLinear(float3 x)
{
    return (pow(10.0, (x - limn_LogCD) / limn_LogCC) - limn_LogCB) / limn_LogCA;
}

// SMPTE ST 2084; 1 stands for maxPQValue candela per square metre.
float3 LinearToPQ(float3 x, float maxPQValue)
{
    float3 y = PositivePow(x / maxPQValue, 2610.0 / 16384.0);
    float3 ratio = (3424.0 / 4096.0 + 2413.0 / 128.0 * y) / (1.0 + 2392.0 / 128.0 * y);
    return PositivePow(ratio, 2523.0 / 32.0);
}
float3 LinearToPQ(float3 x) { return LinearToPQ(x, 100.0); }
float3 PQToLinear(float3 x, float maxPQValue)
{
    float3 y = PositivePow(x, 32.0 / 2523.0);
    float3 ratio = max(y - 3424.0 / 4096.0, 0.0) / (2413.0 / 128.0 - 2392.0 / 128.0 * y);
    return PositivePow(ratio, 16384.0 / 2610.0) * maxPQValue;
}
float3 PQToLinear(float3 x) { return PQToLinear(x, 100.0); }

// Brings a hue that was moved back into low...high.
float RotateHue(float value, float low, float hi)
{
    return value < low ? value + hi : value > hi ? value - hi : value;
}

float3 SoftLight(float3 base, float3 blend)
{
    float3 dark = 2.0 * base * blend + base * base * (1.0 - 2.0 * blend);
    float3 light = 2.0 * base * (1.0 - blend) + sqrt(base) * (2.0 * blend - 1.0);
    return lerp(dark, light, step(0.5, blend));
}

// Scales what the three kinds of cones receive (CAT02), from and to Rec. 709.
float3 WhiteBalance(float3 c, float3 balance)
{
    const float3x3 toCones = {0.390405,  0.549941, 0.00892632, 0.0708416, 0.963172,
                              0.00135775, 0.0231082, 0.128021,   0.936245};
    const float3x3 fromCones = {2.85847,     -1.62879,   -0.0248910, -0.210182, 1.15820,
                                0.000324281, -0.0418120, -0.118169,  1.06867};
    return mul(fromCones, mul(toCones, c) * balance);
}

// John Hable's filmic curve (2010) with its white point.
float3 NeutralCurve(float3 x, float a, float b, float c, float d, float e, float f)
{
    float3 bend = a * x;
    float3 above = x * (bend + b * c) + e * d;
    float3 below = x * (bend + b) + f * d;
    return above / below - e / f;
}
float3 NeutralTonemap(float3 x)
{
    float3 white = 1.0 / NeutralCurve(float3(5.3, 5.3, 5.3), 0.2, 0.29, 0.24, 0.272, 0.02, 0.3);
    return NeutralCurve(x * white, 0.2, 0.29, 0.24, 0.272, 0.02, 0.3) * white;
}

// The look of the reference rendering transform on a monitor of 100 nits in a dim room: ACES2065-1
// in, linear Rec. 709 out. A fraction of polynomials, fitted by colour-science to the Academy's tone
// scales, stands for both of them.
float3 AcesTonemap(float3 aces)
{
    float saturation = rgb_2_saturation(aces);
    float glow = RRT_GLOW_GAIN * sigmoid_shaper((saturation - 0.4) / 0.2);
    aces *= 1.0 + glow_fwd(rgb_2_yc(aces), glow, RRT_GLOW_MID);

    float fromRed = center_hue(rgb_2_hue(aces), RRT_RED_HUE);
    float redness = smoothstep(0.0, 1.0, 1.0 - abs(2.0 * fromRed / RRT_RED_WIDTH));
    aces.r += redness * redness * saturation * (RRT_RED_PIVOT - aces.r) * (1.0 - RRT_RED_SCALE);

    float3 x = max(ACES_to_ACEScg(aces), 0.0);
    x = lerp(dot(x, AP1_RGB2Y).xxx, x, RRT_SAT_FACTOR);
    x = x * (278.5085 * x + 10.7772) / (x * (293.6045 * x + 88.7122) + 80.6889);
    x = darkSurround_to_dimSurround(x);
    x = lerp(dot(x, AP1_RGB2Y).xxx, x, ODT_SAT_FACTOR);
    return mul(XYZ_2_REC709_MAT, mul(D60_2_D65_CAT, mul(AP1_2_XYZ_MAT, x)));
}

// Keeps the sum of many samples from being ruled by a bright one, and back.
float3 FastTonemap(float3 c) { return c / (Max3(c.r, c.g, c.b) + 1.0); }
float4 FastTonemap(float4 c) { return float4(FastTonemap(c.rgb), c.a); }
float3 FastTonemap(float3 c, float w) { return c * (w / (Max3(c.r, c.g, c.b) + 1.0)); }
float3 FastTonemapInvert(float3 c) { return c / (1.0 - Max3(c.r, c.g, c.b)); }
float4 FastTonemapInvert(float4 c) { return float4(FastTonemapInvert(c.rgb), c.a); }

// A cube of colours, cut in slices that lie side by side in a strip; scaleOffset: 1/width,
// 1/height, height - 1 of the strip.
float3 ApplyLut2D(Texture2D tex, SamplerState smp, float3 uvw, float3 scaleOffset)
{
    float slice = uvw.z * scaleOffset.z;
    float first = floor(slice);
    float2 uv = uvw.xy * scaleOffset.z * scaleOffset.xy + scaleOffset.xy * 0.5;
    uv.x += first * scaleOffset.y;
    float3 low = tex.SampleLevel(smp, uv, 0).rgb;
    float3 high = tex.SampleLevel(smp, uv + float2(scaleOffset.y, 0.0), 0).rgb;
    return lerp(low, high, slice - first);
}
float3 ApplyLut3D(Texture3D tex, SamplerState smp, float3 uvw, float2 scaleOffset)
{
    return tex.SampleLevel(smp, uvw * scaleOffset.y * scaleOffset.x + scaleOffset.x * 0.5, 0).rgb;
}
// What colour such a strip holds where nothing is graded; params: height, 0.5/width, 0.5/height,
// height/(height - 1).
float3 GetLutStripValue(float2 uv, float4 params)
{
    float2 corner = uv - params.yz;
    float slice = floor(corner.x * params.x);
    return float3(frac(corner.x * params.x), corner.y, slice / params.x) * params.w;
}
#endif
