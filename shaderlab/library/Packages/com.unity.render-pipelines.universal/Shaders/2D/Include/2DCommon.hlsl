// Sprites without lights. The author has declared Attributes and Varyings by COMMON_2D_INPUTS and
// COMMON_2D_OUTPUTS.
#pragma once
#ifndef _2D_COMMON
#define _2D_COMMON
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/Core2D.hlsl"

TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);

Varyings CommonUnlitVertex(Attributes input)
{
    Varyings result = (Varyings)0;
    result.uv = input.uv;
    result.positionCS = TransformObjectToHClip(input.positionOS);
    return result;
}

half4 CommonUnlitFragment(Varyings input, half4 color)
{
    return SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv) * color;
}
#endif
