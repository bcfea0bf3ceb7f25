// Entry points of a generated unlit pass of a sprite.
#pragma once
#include "limn/GraphSprite.hlsl"

half4 frag(PackedVaryings packedInput) : SV_TARGET
{
    Varyings unpacked = UnpackVaryings(packedInput);
    return limn_GraphSpriteColor(unpacked, BuildSurfaceDescription(unpacked));
}
