// What LitInput.hlsl gives to baked light.
#pragma once
#ifndef UNIVERSAL_LIT_META_PASS_INCLUDED
#define UNIVERSAL_LIT_META_PASS_INCLUDED

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UniversalMetaPass.hlsl"

float4 UniversalFragmentMetaLit(Varyings input) : SV_Target
{
    SurfaceData surfaceData;
    InitializeStandardLitSurfaceData(input.uv, surfaceData);
    BRDFData brdfData;
    InitializeBRDFData(surfaceData, brdfData);
    MetaInput given;
    given.Emission = surfaceData.emission;
    given.Albedo = brdfData.diffuse + 0.5 * brdfData.roughness * brdfData.specular;
    return UniversalFragmentMeta(input, given);
}
#endif
