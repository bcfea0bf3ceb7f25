// What sprites' vertices go through. limn draws sprites as meshes: none is flipped, tinted by its
// renderer or bent by bones.
#pragma once
#define INPUT_CORE_2D_INCLUDED

#define unity_SpriteColor float4(1, 1, 1, 1)
#define unity_SpriteProps float4(1, 1, -1, -1) // xy: -1 where flipped
#define unity_SpriteFlip float2(1, 1)

#define UNITY_SKINNED_VERTEX_INPUTS
#define UNITY_SKINNED_VERTEX_COMPUTE(v)

float3 UnityFlipSprite(in float3 pos, in float2 flip) { return float3(pos.xy * flip, pos.z); }
void SetUpSpriteInstanceProperties() {}
