// What displays are sent in the built-in pipeline: from linear Rec. 709 and back.
#pragma once
#ifndef UNITY_COLOR_GAMUT_INCLUDED
#define UNITY_COLOR_GAMUT_INCLUDED
#include "UnityCG.cginc"

#define kColorGamutSRGB 0
#define kColorGamutRec709 1
#define kColorGamutRec2020 2
#define kColorGamutDisplayP3 3
#define kColorGamutHDR10 4
#define kColorGamutDolbyHDR 5
#define kColorGamutP3D65G22 6
#define kReferenceLuminanceWhiteForRec709 80

float3 LinearToSRGB(float3 color)
{
    float3 curve = 1.055 * pow(abs(color), 1.0 / 2.4) - 0.055;
    return color < (float3)0.0031308 ? 12.92 * color : curve;
}
float3 SRGBToLinear(float3 color)
{
    float3 curve = pow(abs(color + 0.055) / 1.055, 2.4);
    return color < (float3)0.04045 ? color / 12.92 : curve;
}
float3 LinearToGamma22(float3 color) { return pow(abs(color), 1.0 / 2.2); }
float3 Gamma22ToLinear(float3 color) { return pow(abs(color), 2.2); }

static const float3x3 Rec709ToRec2020 = {0.627402, 0.329292, 0.043306, 0.069095, 0.919544,
                                         0.011360, 0.016394, 0.088028, 0.895578};
static const float3x3 Rec2020ToRec709 = {1.660496,  -0.587656, -0.072840, -0.124547, 1.132895,
                                         -0.008348, -0.018154, -0.100597, 1.118751};
static const float3x3 Rec709ToP3D65Mat = {0.822462, 0.177538, 0.000000, 0.033194, 0.966806,
                                          0.000000, 0.017083, 0.072397, 0.910520};
static const float3x3 P3D65MatToRec709 = {1.224940, -0.224940, 0.000000,  -0.042056, 1.042056,
                                          0.000000, -0.019637, -0.078636, 1.098273};

// SMPTE ST 2084, of 10 000 nits
#define PQ_M1 (2610.0 / 16384.0)
#define PQ_M2 (2523.0 / 32.0)
#define PQ_C1 (3424.0 / 4096.0)
#define PQ_C2 (2413.0 / 128.0)
#define PQ_C3 (2392.0 / 128.0)
float3 LinearToST2084(float3 color)
{
    float3 power = pow(abs(color), PQ_M1);
    return pow((PQ_C1 + PQ_C2 * power) / (1.0 + PQ_C3 * power), PQ_M2);
}
float3 ST2084ToLinear(float3 color)
{
    float3 power = pow(abs(color), 1.0 / PQ_M2);
    return pow(max(power - PQ_C1, 0.0) / (PQ_C2 - PQ_C3 * power), 1.0 / PQ_M1);
}

float3 SimpleHDRDisplayToneMapAndOETF(float3 scene, int colorGamut, bool forceGammaToLinear,
                                      float nitsForPaperWhite, float maxDisplayNits)
{
    float3 color = forceGammaToLinear ? SRGBToLinear(scene) : scene;
    switch (colorGamut)
    {
    case kColorGamutSRGB: return LinearToSRGB(color);
    case kColorGamutHDR10:
        return LinearToST2084(mul(Rec709ToRec2020, color) * (nitsForPaperWhite / 10000.0));
    case kColorGamutP3D65G22:
        return LinearToGamma22(mul(Rec709ToP3D65Mat, color) *
                               (nitsForPaperWhite / maxDisplayNits));
    default: return color * (nitsForPaperWhite / kReferenceLuminanceWhiteForRec709);
    }
}
float3 limn_LinearFromDisplay(float3 result, int colorGamut, float nitsForPaperWhite,
                              float maxDisplayNits)
{
    switch (colorGamut)
    {
    case kColorGamutSRGB: return SRGBToLinear(result);
    case kColorGamutHDR10:
        return mul(Rec2020ToRec709, ST2084ToLinear(result) * (10000.0 / nitsForPaperWhite));
    case kColorGamutP3D65G22:
        return mul(P3D65MatToRec709,
                   Gamma22ToLinear(result) * (maxDisplayNits / nitsForPaperWhite));
    default: return result * (kReferenceLuminanceWhiteForRec709 / nitsForPaperWhite);
    }
}
float3 InverseSimpleHDRDisplayToneMapAndOETF(float3 result, int colorGamut, bool forceGammaToLinear,
                                             float nitsForPaperWhite, float maxDisplayNits)
{
    float3 color = limn_LinearFromDisplay(result, colorGamut, nitsForPaperWhite, maxDisplayNits);
    return forceGammaToLinear ? LinearToSRGB(color) : color;
}
#endif
