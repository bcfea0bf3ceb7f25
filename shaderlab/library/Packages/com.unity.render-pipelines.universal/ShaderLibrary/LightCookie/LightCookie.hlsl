// Lights have no cookies: they shine white through.
#pragma once
#ifndef UNIVERSAL_LIGHT_COOKIE_INCLUDED
#define UNIVERSAL_LIGHT_COOKIE_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LightCookie/LightCookieInput.hlsl"

[limn_Lacks("light cookies", "lights shine white through them")]
float3 SampleMainLightCookie(float3 samplePositionWS) { return float3(1, 1, 1); }
[limn_Lacks("light cookies", "lights shine white through them")]
float3 SampleAdditionalLightCookie(int perObjectLightIndex, float3 samplePositionWS)
{
    return float3(1, 1, 1);
}
#endif
