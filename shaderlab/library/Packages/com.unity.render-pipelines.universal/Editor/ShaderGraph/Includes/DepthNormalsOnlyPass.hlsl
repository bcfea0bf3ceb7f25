// Entry points of a generated pass of depth and world-space normals.
#pragma once
#include "limn/GraphSurface.hlsl"

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

void frag(PackedVaryings packedInput, out float4 outNormalWS : SV_Target0)
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
#if defined(_ALPHATEST_ON)
    clip(surface.Alpha - surface.AlphaClipThreshold);
#endif
    outNormalWS = float4(limn_GraphNormal(unpacked, surface), 0.0);
}
