// How the grass and the trees of a terrain move. Scripts set the globals that the editor's terrain
// sets: limn has no terrain of its own.
#pragma once
#ifndef TERRAIN_ENGINE_INCLUDED
#define TERRAIN_ENGINE_INCLUDED
#include "UnityCG.cginc"

fixed4 _WavingTint;
float4 _WaveAndDistance; // time of the wind, size of its waves, bending, largest distance squared
float4 _CameraPosition;  // w: 1 / the largest distance squared
float3 _CameraRight, _CameraUp;
float4 _TreeInstanceColor, _TreeInstanceScale, _SquashPlaneNormal;
float4x4 _TerrainEngineBendTree;
float _SquashAmount; // 1 = not at all
float3 _TreeBillboardCameraRight;
float4 _TreeBillboardCameraUp;    // w: how far billboards come forwards, in halves of their width
float4 _TreeBillboardCameraFront;
float4 _TreeBillboardCameraPos;   // w: 0 as seen from the side, 1 from above
float4 _TreeBillboardDistances;   // x: largest distance squared
float4 _Wind; // of a tree; w: how much its leaves flutter

#include "limn/WavingGrass.hlsl"

// Spreads a quad of grass towards the camera; beyond the largest distance it stays a point.
void TerrainBillboardGrass(inout float4 pos, float2 offset)
{
    float3 away = pos.xyz - _CameraPosition.xyz;
    offset = dot(away, away) > _WaveAndDistance.w ? 0.0 : offset;
    pos.xyz += offset.x * _CameraRight + offset.y * _CameraUp;
}

// color.a: how much the vertex waves
void WavingGrassVert(inout appdata_full v)
{
    v.color = TerrainWaveGrass(v.vertex, v.color.a * _WaveAndDistance.z, v.color);
}

// tangent.xy: from the root of the grass to the corner of its quad
void WavingGrassBillboardVert(inout appdata_full v)
{
    TerrainBillboardGrass(v.vertex, v.tangent.xy);
    v.color = TerrainWaveGrass(v.vertex, v.tangent.y, v.color);
}

struct appdata_tree
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    fixed4 color : COLOR;
    float4 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_tree_billboard
{
    float4 vertex : POSITION;
    fixed4 color : COLOR;
    float4 texcoord : TEXCOORD0;
    float2 texcoord1 : TEXCOORD1; // from the root of the tree to the corner of its quad
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

// Far trees are pressed flat towards a plane before a billboard takes their place.
float4 Squash(in float4 pos)
{
    float height = dot(_SquashPlaneNormal.xyz, pos.xyz) + _SquashPlaneNormal.w;
    return float4(pos.xyz - (1.0 - _SquashAmount) * height * _SquashPlaneNormal.xyz, 1.0);
}

// A vertex of a tree that bends as a whole. alpha: how much the vertex follows.
void TerrainAnimateTree(inout float4 pos, float alpha)
{
    float3 upright = _TreeInstanceScale.xyz * pos.xyz;
    float3 bent = mul((float3x3)_TerrainEngineBendTree, upright);
    pos.xyz = lerp(upright, bent, alpha);
    pos = Squash(pos);
}

// Spreads a quad towards the camera; beyond the largest distance it stays a point. offsetz: its
// height as seen from above. Forwards, so that the ground does not hide it.
void TerrainBillboardTree(inout float4 pos, float2 offset, float offsetz)
{
    float3 away = pos.xyz - _TreeBillboardCameraPos.xyz;
    float isNear = dot(away, away) > _TreeBillboardDistances.x ? 0.0 : 1.0;
    float width = offset.x * isNear;
    float height = lerp(offset.y, offsetz, _TreeBillboardCameraPos.w) * isNear;
    pos.xyz += _TreeBillboardCameraRight * width + _TreeBillboardCameraUp.xyz * height;
    pos.xyz += _TreeBillboardCameraFront.xyz * (abs(width) * _TreeBillboardCameraUp.w);
}

// Where a mesh has leaves as quads (tangent.w = 0), their corners lie at the normal's x and y from
// the vertex, as the camera sees them. mat: UNITY_MATRIX_IT_MV, so that its rows multiply.
void ExpandBillboard(in float4x4 mat, inout float4 pos, inout float3 normal, inout float4 tangent)
{
    float isBillboard = 1.0 - abs(tangent.w);
    float3 seenNormal = normalize(mul(float4(normal, 0.0), mat)).xyz;
    float3 seenTangent = normalize(mul(float4(tangent.xyz, 0.0), mat)).xyz;
    pos += mul(float4(normal.xy, 0.0, 0.0), mat) * isBillboard;
    normal = lerp(normal, seenNormal, isBillboard);
    tangent = lerp(tangent, float4(seenTangent, -1.0), isBillboard);
}

float4 SmoothCurve(float4 x) { return x * x * (3.0 - 2.0 * x); }
float4 TriangleWave(float4 x) { return abs(frac(x + 0.5) * 2.0 - 1.0); }
float4 SmoothTriangleWave(float4 x) { return SmoothCurve(TriangleWave(x)); }

// A vertex of a tree in _Wind. animParams: phase of the branch, flutter of the edges, bending of the
// tree, bending of the branch.
float4 AnimateVertex(float4 pos, float3 normal, float4 animParams)
{
    float branch = dot(unity_ObjectToWorld._14_24_34, 1.0) + animParams.x;
    float2 phase = _Time.y + float2(dot(pos.xyz, animParams.y + branch), branch);
    float4 waves = SmoothTriangleWave(
        frac(phase.xxyy * float4(1.975, 0.793, 0.375, 0.193)) * 2.0 - 1.0);
    float2 sum = waves.xz + waves.yw;
    float3 bend = animParams.y * 0.1 * normal;
    bend.y = animParams.w * 0.3;
    pos.xyz += (sum.xyx * bend + _Wind.xyz * sum.y * animParams.w) * _Wind.w;
    pos.xyz += animParams.z * _Wind.xyz;
    return pos;
}
#endif
