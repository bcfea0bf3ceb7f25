// Where a vertex is seen from a light.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

// Where the light is: _LightDirection for the sun, _LightPosition for one with a place.
float3 _LightDirection;
float3 _LightPosition;
float3 limn_LightPosition; // relative to limn_Origin

float4 limn_ShadowCasterClip(float3 positionOS, float3 normalOS)
{
    float3 normalWS = TransformObjectToWorldNormal(normalOS);
    float3 position = limn_ObjectToRelative(positionOS);
#ifdef _CASTING_PUNCTUAL_LIGHT_SHADOW
    float3 lightDirection = normalize(limn_LightPosition - position);
#else
    float3 lightDirection = _LightDirection;
#endif
    return ApplyShadowClamping(
        limn_RelativeToClip(ApplyShadowBias(position, normalWS, lightDirection)));
}
