// Entry points of a generated pass that stores a sprite's normals for 2D lights.
#pragma once
#include "limn/GraphSprite.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/NormalsRenderingShared.hlsl"

half4 frag(PackedVaryings packedInput) : SV_TARGET
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
    half4 color = limn_GraphSpriteColor(unpacked, surface);
    half3 bitangent = cross(unpacked.normalWS, unpacked.tangentWS.xyz) *
                      (unpacked.tangentWS.w * GetOddNegativeScale());
    return NormalsRenderingShared(color, surface.NormalTS, unpacked.tangentWS.xyz, bitangent,
                                  unpacked.normalWS);
}
