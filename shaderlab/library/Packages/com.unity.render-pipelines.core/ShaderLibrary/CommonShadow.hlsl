#pragma once
#ifndef UNITY_COMMON_SHADOW_INCLUDED
#define UNITY_COMMON_SHADOW_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

// Along the normal, two texels of the shadow map where the light only grazes the surface.
float3 GetShadowPosOffset(float NdotL, float3 normalWS, float2 invShadowMapSize)
{
    return normalWS * (saturate(1.0 - NdotL) * 2.0 * invShadowMapSize.x);
}
#endif
