// What the passes and graphs of SpeedTree 8 and 9 share.
#pragma once
#ifndef SPEEDTREE_COMMON_INCLUDED
#define SPEEDTREE_COMMON_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

#define ST_GEOM_TYPE_BRANCH 0
#define ST_GEOM_TYPE_FROND 1
#define ST_GEOM_TYPE_LEAF 2
#define ST_GEOM_TYPE_FACINGLEAF 3

// uv3.w: the kind of geometry; leaves of the second wind group have 2 more.
int GetGeometryType(float4 uv3, out bool bLeafTwo)
{
    int kind = (int)(uv3.w + 0.25);
    bLeafTwo = kind > ST_GEOM_TYPE_FACINGLEAF;
    return bLeafTwo ? kind - 2 : kind;
}

// Turns a leaf about its anchor to the camera, as large as it was.
float3 DoLeafFacing(float3 vPos, float3 anchor)
{
    float3 arm = vPos - anchor;
    float3 upright = float3(arm.x, -arm.z, arm.y); // leaves lie flat as they are made
    float3x3 columns = transpose((float3x3)GetObjectToWorldMatrix());
    float3 scale = float3(length(columns[0]), length(columns[1]), length(columns[2]));
    float3 facing = mul((float3x3)GetWorldToObjectMatrix(),
                        mul((float3x3)GetViewToWorldMatrix(), upright));
    return anchor + normalize(facing * scale) * length(arm);
}

// A unit vector, but for one that is nearly 0.
float3 TransformWindVectorFromWorldToLocalSpace(float3 vWindDirection)
{
    float3 wind = mul((float3x3)GetWorldToObjectMatrix(), vWindDirection);
    float size = length(wind);
    return size > 1e-5 ? wind / size : wind;
}

void SpeedTree8LeafFacing_float(float3 vVertexLocalPosition, float4 UV1, float4 UV2, float4 UV3,
                                out float3 vVertexLocalPositionOut)
{
    bool isSecond;
    bool isFacing = GetGeometryType(UV3, isSecond) == ST_GEOM_TYPE_FACINGLEAF;
    float3 turned = DoLeafFacing(vVertexLocalPosition, float3(UV1.zw, UV2.w));
    vVertexLocalPositionOut = isFacing ? turned : vVertexLocalPosition;
}

// The anchor is in whichever of the two has a w above 0.
void SpeedTree9LeafFacing_float(float3 vVertexLocalPosition, float4 UV2, float4 UV3,
                                out float3 vVertexLocalPositionOut)
{
    float4 anchor = UV3.w > 0.0 ? UV3 : UV2;
    float3 turned = DoLeafFacing(vVertexLocalPosition, anchor.xyz);
    vVertexLocalPositionOut = anchor.w > 0.0 ? turned : vVertexLocalPosition;
}

void SpeedTreeLODTransition_float(float3 ObjectSpacePosition, float4 ObjectSpacePositionNextLOD,
                                  const bool bBillboard, out float3 OutObjectSpacePosition)
{
    float share = bBillboard ? 0.0 : unity_LODFade.x;
    OutObjectSpacePosition = lerp(ObjectSpacePosition, ObjectSpacePositionNextLOD.xyz, share);
}
#endif
