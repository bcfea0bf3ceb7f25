// What the skybox shaders share. The mesh is the sky around the camera: object space has the axes
// of the world.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"

// Around y, clockwise as seen from above; negative turns back.
float3 limn_TurnSky(float3 direction, float degrees)
{
    float s, c;
    sincos(DegToRad(degrees), s, c);
    return float3(c * direction.x - s * direction.z, direction.y,
                  s * direction.x + c * direction.z);
}

// Unity declares the exposure of pictures [Gamma]: a number as a screen would show it.
float limn_SkyExposure(float exposure)
{
#ifdef UNITY_COLORSPACE_GAMMA
    return exposure;
#else
    return exposure <= 1.0 ? SRGBToLinear(exposure) : Gamma22ToLinear(exposure);
#endif
}

// A picture's texel; the grey of _Tint's default, doubled, leaves it as it is.
float3 limn_SkyColor(float3 texel, float3 tint, float exposure)
{
    return texel * tint * unity_ColorSpaceDouble.rgb * limn_SkyExposure(exposure);
}
