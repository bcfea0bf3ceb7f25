// Entry points of a generated unlit pass of a sprite: the graph's colour times the vertex's. limn has
// no sprite renderer, whose own colour Unity multiplies in as well.
#pragma once

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

float4 frag(PackedVaryings packedInput) : SV_Target
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
#ifdef UNIVERSAL_USELEGACYSPRITEBLOCKS
    float4 color = surface.SpriteColor;
#else
    float4 color = float4(surface.BaseColor, surface.Alpha);
#endif
    return color * unpacked.color;
}
