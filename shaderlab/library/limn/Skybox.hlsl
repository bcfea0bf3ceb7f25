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

// A picture's texel; the grey of _Tint's default, doubled, leaves it as it is.
float3 limn_SkyColor(float3 texel, float3 tint, float exposure)
{
    return texel * tint * unity_ColorSpaceDouble.rgb * exposure;
}
