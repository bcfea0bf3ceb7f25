// Entry points of a generated lit surface under the 2D renderer: its colour.
#pragma once
#include "limn/GraphSurface.hlsl"

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

half4 frag(PackedVaryings packedInput) : SV_TARGET
{
    SurfaceDescription surface = BuildSurfaceDescription(UnpackVaryings(packedInput));
    return half4(surface.BaseColor, limn_GraphAlpha(surface));
}
