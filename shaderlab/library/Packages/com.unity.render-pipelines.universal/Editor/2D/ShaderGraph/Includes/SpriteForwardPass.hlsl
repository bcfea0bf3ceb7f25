// Entry points of a generated lit sprite's pass in pipelines without 2D lights.
#pragma once
#include "limn/GraphSprite.hlsl"

half4 frag(PackedVaryings packedInput) : SV_TARGET
{
    Varyings unpacked = UnpackVaryings(packedInput);
    return limn_GraphSpriteColor(unpacked, BuildSurfaceDescription(unpacked));
}
