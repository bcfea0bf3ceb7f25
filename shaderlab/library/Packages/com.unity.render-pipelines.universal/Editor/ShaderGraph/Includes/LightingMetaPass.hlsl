// Entry points of a generated pass that bakes light.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/MetaInput.hlsl"

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

float4 frag(PackedVaryings packedInput) : SV_TARGET
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
#if defined(_ALPHATEST_ON)
    clip(surface.Alpha - surface.AlphaClipThreshold);
#endif
    MetaInput metaInput = (MetaInput)0;
    metaInput.Albedo = surface.BaseColor;
    metaInput.Emission = surface.Emission;
    return UnityMetaFragment(metaInput);
}
