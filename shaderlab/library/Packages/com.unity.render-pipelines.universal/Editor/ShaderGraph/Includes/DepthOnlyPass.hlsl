// Entry points of a generated pass of depth alone.
#pragma once

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

float4 frag(PackedVaryings packedInput) : SV_TARGET
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
#if defined(_ALPHATEST_ON)
    clip(surface.Alpha - surface.AlphaClipThreshold);
#endif
    return packedInput.positionCS.z;
}
