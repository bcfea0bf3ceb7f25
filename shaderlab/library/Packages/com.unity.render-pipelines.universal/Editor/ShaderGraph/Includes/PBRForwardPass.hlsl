// Entry points of a generated lit pass.
#pragma once
#include "limn/GraphLit.hlsl"

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

void frag(PackedVaryings packedInput, out float4 outColor : SV_Target0)
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
    float alpha = limn_GraphAlpha(surface);
    InputData inputData = limn_GraphInputData(unpacked, surface);
    outColor = UniversalFragmentPBR(inputData, limn_GraphSurfaceData(surface, alpha));
    outColor.rgb = MixFog(outColor.rgb, inputData.fogCoord);
}
