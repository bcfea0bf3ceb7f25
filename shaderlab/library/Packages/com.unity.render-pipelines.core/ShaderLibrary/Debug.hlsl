// Colours that tell numbers apart.
#pragma once
#ifndef UNITY_DEBUG_INCLUDED
#define UNITY_DEBUG_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"

#define DEBUG_COLORS_COUNT 12
#define kDebugColorBlack (float4(0, 0, 0, 255) / 255.0)
#define kDebugColorLightPurple (float4(166, 70, 242, 255) / 255.0)
#define kDebugColorDeepBlue (float4(0, 26, 221, 255) / 255.0)
#define kDebugColorSkyBlue (float4(65, 152, 224, 255) / 255.0)
#define kDebugColorLightBlue (float4(158, 228, 251, 255) / 255.0)
#define kDebugColorTeal (float4(56, 243, 176, 255) / 255.0)
#define kDebugColorBrightGreen (float4(168, 238, 46, 255) / 255.0)
#define kDebugColorBrightYellow (float4(255, 253, 76, 255) / 255.0)
#define kDebugColorDarkYellow (float4(255, 214, 0, 255) / 255.0)
#define kDebugColorOrange (float4(253, 152, 0, 255) / 255.0)
#define kDebugColorBrightRed (float4(255, 67, 51, 255) / 255.0)
#define kDebugColorDarkRed (float4(132, 10, 54, 255) / 255.0)
#define kDebugColorShadowCascade0 float4(0.4, 0.4, 0.9, 1.0)
#define kDebugColorShadowCascade1 float4(0.4, 0.9, 0.4, 1.0)
#define kDebugColorShadowCascade2 float4(0.9, 0.9, 0.4, 1.0)
#define kDebugColorShadowCascade3 float4(0.9, 0.4, 0.4, 1.0)
static const float4 kDebugColorGradient[DEBUG_COLORS_COUNT] = {
    kDebugColorBlack,        kDebugColorLightPurple, kDebugColorDeepBlue,
    kDebugColorSkyBlue,      kDebugColorLightBlue,   kDebugColorTeal,
    kDebugColorBrightGreen,  kDebugColorBrightYellow, kDebugColorDarkYellow,
    kDebugColorOrange,       kDebugColorBrightRed,   kDebugColorDarkRed};

// 16 colours; red for what is none of them
float3 GetIndexColor(int index)
{
    const float3 colors[16] = {
        float3(1.0, 0.5, 0.5),   float3(0.5, 1.0, 0.5),   float3(0.5, 0.5, 1.0),
        float3(1.0, 1.0, 0.5),   float3(1.0, 0.5, 1.0),   float3(0.5, 1.0, 1.0),
        float3(0.25, 0.75, 1.0), float3(1.0, 0.75, 0.25), float3(0.75, 1.0, 0.25),
        float3(0.75, 0.25, 1.0), float3(0.25, 1.0, 0.75), float3(0.75, 0.75, 0.25),
        float3(0.75, 0.25, 0.75), float3(0.25, 0.75, 0.75), float3(0.25, 0.25, 0.75),
        float3(0.75, 0.25, 0.25)};
    return index >= 0 && index < 16 ? colors[clamp(index, 0, 15)] : float3(1.0, 0.0, 0.0);
}
#endif
