// The Academy Color Encoding System: its colour spaces, and the parts of its reference rendering
// transform (version 1.0.3) that AcesTonemap in Color.hlsl is made of. Names are the Academy's.
// "unity" is linear Rec. 709, ACES is ACES2065-1 with primaries AP0, ACEScg has primaries AP1.
#pragma once
#ifndef __ACES__
#define __ACES__

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

static const float3x3 sRGB_2_AP0 = {0.4397010, 0.3829780, 0.1773350, 0.0897923, 0.8134230,
                                    0.0967616, 0.0175440, 0.1115440, 0.8707040};
static const float3x3 sRGB_2_AP1 = {0.61319, 0.33951, 0.04737, 0.07021, 0.91634,
                                    0.01345, 0.02062, 0.10957, 0.86961};
static const float3x3 AP0_2_sRGB = {2.52169,  -1.13413, -0.38756, -0.27648, 1.37272,
                                    -0.09624, -0.01538, -0.15298, 1.16835};
static const float3x3 AP1_2_sRGB = {1.70505,  -0.62179, -0.08326, -0.13026, 1.14080,
                                    -0.01055, -0.02400, -0.12897, 1.15297};
static const float3x3 AP0_2_AP1_MAT = {1.4514393161, -0.2365107469, -0.2149285693,
                                       -0.0765537734, 1.1762296998, -0.0996759264,
                                       0.0083161484,  -0.0060324498, 0.9977163014};
static const float3x3 AP1_2_AP0_MAT = {0.6954522414, 0.1406786965, 0.1638690622,
                                       0.0447945634, 0.8596711185, 0.0955343182,
                                       -0.0055258826, 0.0040252103, 1.0015006723};
static const float3x3 AP1_2_XYZ_MAT = {0.6624541811, 0.1340042065, 0.1561876870,
                                       0.2722287168, 0.6740817658, 0.0536895174,
                                       -0.0055746495, 0.0040607335, 1.0103391003};
static const float3x3 XYZ_2_AP1_MAT = {1.6410233797,  -0.3248032942, -0.2364246952,
                                       -0.6636628587, 1.6153315917,  0.0167563477,
                                       0.0117218943,  -0.0082844420, 0.9883948585};
static const float3x3 XYZ_2_REC709_MAT = {3.2409699419,  -1.5373831776, -0.4986107603,
                                          -0.9692436363, 1.8759675015,  0.0415550574,
                                          0.0556300797,  -0.2039769589, 1.0569715142};
// Bradford's adaptation between the white points of ACES and of Rec. 709
static const float3x3 D60_2_D65_CAT = {0.98722400, -0.00611327, 0.0159533,
                                       -0.00759836, 1.00186000, 0.0053302,
                                       0.00307257, -0.00509595, 1.0816800};
static const float3 AP1_RGB2Y = float3(0.272229, 0.674082, 0.0536895);

static const float RRT_GLOW_GAIN = 0.05;
static const float RRT_GLOW_MID = 0.08;
static const float RRT_RED_SCALE = 0.82;
static const float RRT_RED_PIVOT = 0.03;
static const float RRT_RED_HUE = 0.0;
static const float RRT_RED_WIDTH = 135.0;
static const float RRT_SAT_FACTOR = 0.96;
static const float ODT_SAT_FACTOR = 0.93;
static const float DIM_SURROUND_GAMMA = 0.9811;

float3 unity_to_ACES(float3 x) { return mul(sRGB_2_AP0, x); }
float3 ACES_to_unity(float3 x) { return mul(AP0_2_sRGB, x); }
float3 unity_to_ACEScg(float3 x) { return mul(sRGB_2_AP1, x); }
float3 ACEScg_to_unity(float3 x) { return mul(AP1_2_sRGB, x); }
float3 ACES_to_ACEScg(float3 x) { return mul(AP0_2_AP1_MAT, x); }
float3 ACEScg_to_ACES(float3 x) { return mul(AP1_2_AP0_MAT, x); }

// Of ACEScc: where half precision ends, and a grey that reflects 18 %
#define ACEScc_MAX 1.4679964
#define ACEScc_MIDGRAY 0.4135884

// S-2014-003: a logarithm with a parabola's foot below 2^-15.
float ACES_to_ACEScc(float x)
{
    float foot = log2(exp2(-16.0) + max(x, 0.0) * 0.5);
    return ((x < exp2(-15.0) ? foot : log2(max(x, exp2(-15.0)))) + 9.72) / 17.52;
}
float3 ACES_to_ACEScc(float3 x)
{
    x = clamp(x, 0.0, HALF_MAX);
    return float3(ACES_to_ACEScc(x.r), ACES_to_ACEScc(x.g), ACES_to_ACEScc(x.b));
}
float ACEScc_to_ACES(float x)
{
    float power = exp2(x * 17.52 - 9.72);
    return x < (9.72 - 15.0) / 17.52 ? (power - exp2(-16.0)) * 2.0 : min(power, HALF_MAX);
}
float3 ACEScc_to_ACES(float3 x)
{
    return float3(ACEScc_to_ACES(x.r), ACEScc_to_ACES(x.g), ACEScc_to_ACES(x.b));
}

float rgb_2_saturation(float3 rgb)
{
    float low = max(min(rgb.r, min(rgb.g, rgb.b)), 1e-4);
    float high = max(rgb.r, max(rgb.g, rgb.b));
    return (max(high, 1e-4) - low) / max(high, 1e-2);
}

// A stand-in for luminance that weighs colourfulness in.
float rgb_2_yc(float3 rgb)
{
    float3 steps = rgb.bgr * (rgb.bgr - rgb.grb);
    float chroma = sqrt(max(steps.x + steps.y + steps.z, 0.0));
    return (rgb.r + rgb.g + rgb.b + 1.75 * chroma) / 3.0;
}

// In degrees, 0 to 360; 0 for greys.
float rgb_2_hue(float3 rgb)
{
    bool isGrey = rgb.r == rgb.g && rgb.g == rgb.b;
    float hue = isGrey ? 0.0
                       : degrees(atan2(sqrt(3.0) * (rgb.g - rgb.b), 2.0 * rgb.r - rgb.g - rgb.b));
    return hue < 0.0 ? hue + 360.0 : hue;
}

// From the centre the short way round, -180 to 180.
float center_hue(float hue, float centerH)
{
    float away = hue - centerH;
    return away < -180.0 ? away + 360.0 : away > 180.0 ? away - 360.0 : away;
}

// From 0 at -2 to 1 at 2.
float sigmoid_shaper(float x)
{
    float rest = max(1.0 - abs(x * 0.5), 0.0);
    return 0.5 + 0.5 * sign(x) * (1.0 - rest * rest);
}

// By how much more what is darker than twice the middle glows.
float glow_fwd(float ycIn, float glowGainIn, float glowMid)
{
    float between = glowGainIn * (glowMid / max(ycIn, 1e-6) - 0.5);
    return ycIn <= glowMid * 2.0 / 3.0 ? glowGainIn : ycIn >= glowMid * 2.0 ? 0.0 : between;
}

float3 XYZ_2_xyY(float3 XYZ)
{
    return float3(XYZ.xy / max(XYZ.x + XYZ.y + XYZ.z, 1e-4), XYZ.y);
}
float3 xyY_2_XYZ(float3 xyY)
{
    float scale = xyY.z / max(xyY.y, 1e-4);
    return float3(xyY.x * scale, xyY.z, (1.0 - xyY.x - xyY.y) * scale);
}

// Adapts luminance, seen in the dark, to a dimly lit room; ACEScg.
float3 darkSurround_to_dimSurround(float3 linearCV)
{
    float3 xyY = XYZ_2_xyY(mul(AP1_2_XYZ_MAT, linearCV));
    xyY.z = pow(clamp(xyY.z, 0.0, HALF_MAX), DIM_SURROUND_GAMMA);
    return mul(XYZ_2_AP1_MAT, xyY_2_XYZ(xyY));
}
#endif
