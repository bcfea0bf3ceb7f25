// What a surface of one colour gives to baked light.
#pragma once
#ifndef UNIVERSAL_UNLIT_META_PASS_INCLUDED
#define UNIVERSAL_UNLIT_META_PASS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UniversalMetaPass.hlsl"

float4 UniversalFragmentMetaUnlit(Varyings input) : SV_Target
{
    float3 texel = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv).rgb;
    MetaInput surface = (MetaInput)0; // it emits nothing
    surface.Albedo = texel * _BaseColor.rgb;
    return UniversalFragmentMeta(input, surface);
}
#endif
