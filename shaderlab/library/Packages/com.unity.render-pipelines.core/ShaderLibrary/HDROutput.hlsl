// Pictures for displays that are brighter than 80 nits. limn writes no such pictures; scripts that do
// set the two uniforms.
#pragma once
#ifndef HDROUTPUT_INCLUDED
#define HDROUTPUT_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/ACES.hlsl"
#include "Packages/com.unity.render-pipelines.core/Runtime/PostProcessing/HDROutputDefines.cs.hlsl"

#ifdef HDR_COLORSPACE_CONVERSION_AND_ENCODING
#define HDR_COLORSPACE_CONVERSION
#define HDR_ENCODING
#endif

int _HDRColorspace;
int _HDREncoding;

// SMPTE ST 2084, the perceptual quantizer: up to 10 000 nits.
#define MAX_PQ_VALUE 10000
#define PQ_N (2610.0 / 16384.0)
#define PQ_M (2523.0 / 32.0)
#define PQ_C1 (3424.0 / 4096.0)
#define PQ_C2 (2413.0 / 128.0)
#define PQ_C3 (2392.0 / 128.0)

// Color.hlsl has functions of these names, as URP before 14 did; there 1 is white of 100 nits.
float3 limn_HDRToPQ(float3 value, float maxPQValue) { return LinearToPQ(value, maxPQValue); }
float3 limn_HDRFromPQ(float3 value, float maxPQValue) { return PQToLinear(value, maxPQValue); }
#define LinearToPQ limn_HDRToPQ
#define PQToLinear limn_HDRFromPQ
float LinearToPQ(float value, float maxPQValue) { return LinearToPQ(value.xxx, maxPQValue).x; }
float LinearToPQ(float value) { return LinearToPQ(value.xxx, MAX_PQ_VALUE).x; }
float3 LinearToPQ(float3 value) { return LinearToPQ(value, MAX_PQ_VALUE); }
float PQToLinear(float value, float maxPQValue) { return PQToLinear(value.xxx, maxPQValue).x; }
float PQToLinear(float value) { return PQToLinear(value, 1.0); }
float3 PQToLinear(float3 value) { return PQToLinear(value, 1.0); }

// Colour spaces
float3 RotateRec709ToRec2020(float3 Rec709Input)
{
    const float3x3 m = {0.627402, 0.329292, 0.043306, 0.069095, 0.919544,
                        0.011360, 0.016394, 0.088028, 0.895578};
    return mul(m, Rec709Input);
}
float3 RotateRec2020ToRec709(float3 Rec2020Input)
{
    const float3x3 m = {1.660496,  -0.587656, -0.072840, -0.124547, 1.132895,
                        -0.008348, -0.018154, -0.100597, 1.118751};
    return mul(m, Rec2020Input);
}
float3 RotateRec709ToXYZ(float3 rgb)
{
    const float3x3 m = {0.412391,  0.357584,  0.180481, 0.212639, 0.715169,
                        0.0721923, 0.0193308, 0.119195, 0.950532};
    return mul(m, rgb);
}
float3 RotateRec2020ToXYZ(float3 rgb)
{
    const float3x3 m = {0.638574,  0.144617, 0.167265,  0.263367, 0.677998,
                        0.0586353, 0.0,      0.0280727, 1.06099};
    return mul(m, rgb);
}
float3 RotateXYZToRec709(float3 XYZ) { return mul(XYZ_2_REC709_MAT, XYZ); }
float3 RotateXYZToRec2020(float3 XYZ)
{
    const float3x3 m = {1.71235168, -0.35487896, -0.25034135, -0.66728621, 1.61794055,
                        0.01495380, 0.01763985,  -0.04277060, 0.94210320};
    return mul(m, XYZ);
}
// What the display takes is Rec. 2020 or Rec. 709.
bool limn_IsRec2020() { return _HDRColorspace == HDRCOLORSPACE_REC2020; }
float3 RotateRec709ToOutputSpace(float3 Rec709Input)
{
    return limn_IsRec2020() ? RotateRec709ToRec2020(Rec709Input) : Rec709Input;
}
float3 RotateRec2020ToOutputSpace(float3 Rec2020Input)
{
    return limn_IsRec2020() ? Rec2020Input : RotateRec2020ToRec709(Rec2020Input);
}
float3 RotateXYZToOutputSpace(float3 xyz)
{
    return limn_IsRec2020() ? RotateXYZToRec2020(xyz) : RotateXYZToRec709(xyz);
}
float3 RotateOutputSpaceToXYZ(float3 rgb)
{
    return limn_IsRec2020() ? RotateRec2020ToXYZ(rgb) : RotateRec709ToXYZ(rgb);
}

// ICtCp (ITU-R BT.2100): brightness and two differences of colour, from what the eye's cones see.
float3 RotateRec2020ToLMS(float3 Rec2020Input)
{
    const float3x3 m = {1688.0 / 4096.0, 2146.0 / 4096.0, 262.0 / 4096.0,
                        683.0 / 4096.0,  2951.0 / 4096.0, 462.0 / 4096.0,
                        99.0 / 4096.0,   309.0 / 4096.0,  3688.0 / 4096.0};
    return mul(m, Rec2020Input);
}
float3 Rotate709ToLMS(float3 Rec709Input) { return RotateRec2020ToLMS(Rec709Input); } // as Unity's
float3 RotatePQLMSToICtCp(float3 LMSInput)
{
    const float3x3 m = {0.5,      0.5,      0.0,       1.613769, -3.323486,
                        1.709716, 4.378174, -4.245605, -0.1325683};
    return mul(m, LMSInput);
}
float3 RotateLMSToICtCp(float3 lms) { return RotatePQLMSToICtCp(LinearToPQ(max(0.0, lms))); }
float3 RotateRec2020ToICtCp(float3 Rec2020)
{
    return RotateLMSToICtCp(RotateRec2020ToLMS(Rec2020));
}
float3 RotateOutputSpaceToICtCp(float3 inputColor)
{
    return RotateRec2020ToICtCp(_HDRColorspace == HDRCOLORSPACE_REC709
                                    ? RotateRec709ToRec2020(inputColor)
                                    : inputColor);
}
float3 RotateLMSToXYZ(float3 LMSInput)
{
    const float3x3 m = {2.0701800567,  -1.3264568761, 0.2066160068,
                        0.3649882500,  0.6804673629,  -0.0454217531,
                        -0.0495955422, -0.0494211612, 1.1879959417};
    return mul(m, LMSInput);
}
float3 RotateICtCpToPQLMS(float3 ICtCp)
{
    const float3x3 m = {1.0, 0.0086051457,  0.1110356045, 1.0,          -0.0086051457,
                        -0.1110356045, 1.0, 0.5600488596, -0.3206374702};
    return mul(m, ICtCp);
}
float3 RotateICtCpToXYZ(float3 ICtCp)
{
    return RotateLMSToXYZ(PQToLinear(RotateICtCpToPQLMS(ICtCp), MAX_PQ_VALUE));
}
float3 RotateICtCpToRec2020(float3 ICtCp) { return RotateXYZToRec2020(RotateICtCpToXYZ(ICtCp)); }
float3 RotateICtCpToRec709(float3 ICtCp) { return RotateXYZToRec709(RotateICtCpToXYZ(ICtCp)); }
float3 RotateICtCpToOutputSpace(float3 ICtCp)
{
    return RotateXYZToOutputSpace(RotateICtCpToXYZ(ICtCp));
}

// What the display is sent.
#define PRECISE_PQ 0
#define ISS_APPROX_PQ 1
#define GTS_APPROX_PQ 2
#ifndef OETF_CHOICE
#define OETF_CHOICE GTS_APPROX_PQ
#endif
#define SDR_REF_WHITE 80

// Patry 2017 and Uchimura and Suzuki 2018: rational functions near to the quantizer, of 100 nits.
float3 PatryApproxLinToPQ(float3 x)
{
    float3 above =
        0.000487781 +
        x * (383.09104 + x * (575216.76 + x * (29063622.1 + x * (47438306.2 + x * 533095.76))));
    return above / (1.0 + x * (10668.404 + x * (4182885.1 + x * (81884528.2 + x * 66391357.4))));
}
float3 GTSApproxLinToPQ(float3 inputCol)
{
    float3 k = PositivePow(inputCol * 0.01, float3(PQ_N, PQ_N, PQ_N));
    return (3.61972e-8 + k * (0.00102859 + k * (2.05784 * k - 0.101284))) /
           (0.0495245 + k * (0.135214 + k * (0.772669 + k)));
}
float3 LinearToPQForLUT(float3 inputCol) { return GTSApproxLinToPQ(inputCol * 0.01); }
float3 OETF(float3 inputCol)
{
    if (_HDREncoding == HDRENCODING_LINEAR)
    {
        return inputCol / SDR_REF_WHITE;
    }
    if (_HDREncoding == HDRENCODING_PQ)
    {
#if OETF_CHOICE == PRECISE_PQ
        return LinearToPQ(inputCol);
#elif OETF_CHOICE == ISS_APPROX_PQ
        return PatryApproxLinToPQ(inputCol * 0.01);
#else
        return GTSApproxLinToPQ(inputCol * 0.01);
#endif
    }
    return inputCol;
}

// Into the display's range
float ReinhardTonemap(float x, float peakValue)
{
    float white = MAX_PQ_VALUE * peakValue / (MAX_PQ_VALUE - peakValue);
    return x * white / (x + white);
}
// ITU-R BT.2390: as it is up to the knee Ks, then a Hermite spline to the brightest.
float T(float A, float Ks) { return (A - Ks) / (1.0 - Ks); }
float P(float B, float Ks, float L_max)
{
    float t = T(B, Ks);
    float rise = t * t * (3.0 - 2.0 * t);
    return Ks * (1.0 - rise) + (1.0 - Ks) * t * (1.0 - t) * (1.0 - t) + L_max * rise;
}
float BT2390EETF(float x, float minLimit, float maxLimit)
{
    float lowest = LinearToPQ(minLimit);
    float highest = LinearToPQ(maxLimit);
    float knee = 1.5 * highest - 0.5;
    float value = LinearToPQ(x);
    value = value < knee ? value : P(value, knee, highest);
    return PQToLinear(value + lowest * pow(abs(1.0 - value), 4.0), MAX_PQ_VALUE);
}
float LumaRangeReduction(float input, float minNits, float maxNits, int mode)
{
    return mode == HDRRANGEREDUCTION_REINHARD ? ReinhardTonemap(input, maxNits)
           : mode == HDRRANGEREDUCTION_BT2390 ? BT2390EETF(input, minNits, maxNits)
                                              : input;
}
float3 DesaturateReducedICtCp(float3 ICtCp, float lumaPre, float maxNits)
{
    float kept = min(1.0, ICtCp.x / max(lumaPre, 1e-6));
    return ICtCp * float3(1.0, kept * kept, kept * kept);
}
float3 HuePreservingRangeReduction(float3 input, float minNits, float maxNits, int mode)
{
    float3 before = RotateOutputSpaceToICtCp(input);
    float luma = PQToLinear(before.x, MAX_PQ_VALUE);
    float3 after =
        float3(LinearToPQ(LumaRangeReduction(luma, minNits, maxNits, mode)), before.yz);
    return RotateICtCpToOutputSpace(DesaturateReducedICtCp(after, before.x, maxNits));
}
float3 HueShiftingRangeReduction(float3 input, float minNits, float maxNits, int mode)
{
    return float3(LumaRangeReduction(input.x, minNits, maxNits, mode),
                  LumaRangeReduction(input.y, minNits, maxNits, mode),
                  LumaRangeReduction(input.z, minNits, maxNits, mode));
}
float3 PerformRangeReduction(float3 input, float minNits, float maxNits, int mode, float hueShift)
{
    if (mode == HDRRANGEREDUCTION_NONE)
    {
        return input;
    }
    return lerp(HuePreservingRangeReduction(input, minNits, maxNits, mode),
                HueShiftingRangeReduction(input, minNits, maxNits, mode), saturate(hueShift));
}
// By brightness alone, without taking colour away.
float3 PerformRangeReduction(float3 input, float minNits, float maxNits)
{
    float3 colour = RotateOutputSpaceToICtCp(input);
    float luma = PQToLinear(colour.x, MAX_PQ_VALUE);
    colour.x = LinearToPQ(BT2390EETF(luma, minNits, maxNits));
    return RotateICtCpToOutputSpace(colour);
}

float3 limn_HDRMapped(float3 color, float paperWhite, float minNits, float maxNits,
                      int reductionMode, float hueShift, bool skipOETF)
{
    float3 reduced =
        PerformRangeReduction(color * paperWhite, minNits, maxNits, reductionMode, hueShift);
    return skipOETF ? reduced : OETF(reduced);
}
float3 HDRMappingFromRec2020(float3 Rec2020Input, float paperWhite, float minNits, float maxNits,
                             int reductionMode, float hueShift, bool skipOETF = false)
{
    return limn_HDRMapped(RotateRec2020ToOutputSpace(Rec2020Input), paperWhite, minNits, maxNits,
                          reductionMode, hueShift, skipOETF);
}
float3 HDRMappingFromRec709(float3 Rec709Input, float paperWhite, float minNits, float maxNits,
                            int reductionMode, float hueShift, bool skipOETF = false)
{
    return limn_HDRMapped(RotateRec709ToOutputSpace(Rec709Input), paperWhite, minNits, maxNits,
                          reductionMode, hueShift, skipOETF);
}
[limn_Lacks("the Academy's transforms for bright displays", "the range is reduced as BT.2390 has it")]
float3 HDRMappingACES(float3 aces, float hdrBoost, int reductionMode, bool skipOETF = false)
{
    float peak = reductionMode == HDRRANGEREDUCTION_ACES1000NITS   ? 1000.0
                 : reductionMode == HDRRANGEREDUCTION_ACES2000NITS ? 2000.0
                                                                   : 4000.0;
    return HDRMappingFromRec709(max(ACES_to_unity(aces), 0.0), hdrBoost, 0.0, peak,
                                HDRRANGEREDUCTION_BT2390, 0.0, skipOETF);
}

float3 ProcessUIForHDR(float3 uiSample, float paperWhite, float maxNits)
{
    return RotateRec709ToOutputSpace(uiSample) * paperWhite;
}
// The interface's colour is premultiplied.
float3 SceneUIComposition(float4 uiSample, float3 sceneColor, float paperWhite, float maxNits)
{
    float3 color = uiSample.rgb / (uiSample.a == 0.0 ? 1.0 : uiSample.a);
    return lerp(sceneColor, ProcessUIForHDR(color, paperWhite, maxNits), uiSample.a);
}
#endif
