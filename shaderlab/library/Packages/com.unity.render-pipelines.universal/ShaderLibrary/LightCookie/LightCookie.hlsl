// Lights have no cookies: they shine white through.
#pragma once

float3 SampleMainLightCookie(float3 samplePositionWS) { return float3(1, 1, 1); }
float3 SampleAdditionalLightCookie(int perObjectLightIndex, float3 samplePositionWS)
{
    return float3(1, 1, 1);
}
