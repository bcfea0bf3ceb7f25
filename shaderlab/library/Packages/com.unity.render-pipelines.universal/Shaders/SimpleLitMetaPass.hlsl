// What SimpleLitInput.hlsl gives to baked light.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UniversalMetaPass.hlsl"

float4 UniversalFragmentMetaSimple(Varyings input) : SV_Target
{
    MetaInput metaInput;
    metaInput.Albedo =
        _BaseColor.rgb * SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv).rgb;
    metaInput.Emission = SampleEmission(input.uv, _EmissionColor.rgb,
                                        TEXTURE2D_ARGS(_EmissionMap, sampler_EmissionMap));
    return UniversalFragmentMeta(input, metaInput);
}
