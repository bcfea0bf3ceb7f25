// Where the quad of a SpeedTree is that is far away, and the picture on it, by the side that it is seen
// from.
#pragma once

cbuffer UnityBillboardPerCamera
{
    float3 unity_BillboardNormal, unity_BillboardTangent;
    float4 unity_BillboardCameraParams; // place of the camera, its angle about the height
};
#define unity_BillboardCameraPosition (unity_BillboardCameraParams.xyz)
#define unity_BillboardCameraXZAngle (unity_BillboardCameraParams.w)

cbuffer UnityBillboardPerBatch
{
    float4 unity_BillboardInfo; // pictures, 1 / angle between two of them
    float4 unity_BillboardSize; // width, height, bottom
    float4 unity_BillboardImageTexCoords[16]; // of each: uv, size; w < 0: lies on its side
};

// Which way the quad faces, and the angle to it; the tangent is level.
float limn_FaceBillboard(float3 worldPos, out float3 tangent, out float3 normal)
{
#ifdef BILLBOARD_FACE_CAMERA_POS
    float3 eye = normalize(unity_BillboardCameraPosition - worldPos);
    tangent = normalize(float3(-eye.z, 0, eye.x));
    normal = float3(tangent.z, 0, -tangent.x);
    float angle = atan2(normal.z, normal.x);
    return angle + (angle < 0 ? 6.28318530718 : 0);
#else
    tangent = unity_BillboardTangent;
    normal = unity_BillboardNormal;
    return unity_BillboardCameraXZAngle;
#endif
}

// From the tree's place to the vertex. scales: of width and height; z: how far the tree is turned.
float3 limn_PlaceBillboard(float3 worldPos, float2 percent, float3 scales, out float3 tangent,
                           out float3 normal, out float2 uv)
{
    float angle = limn_FaceBillboard(worldPos, tangent, normal) + scales.z;
    uint image = (uint)fmod(floor(angle * unity_BillboardInfo.y + 0.5), unity_BillboardInfo.x);
    float4 part = unity_BillboardImageTexCoords[image];
    uv = part.w < 0 ? part.xy - part.zw * percent.yx : part.xy + part.zw * percent;

    float3 offset = (percent.x - 0.5) * unity_BillboardSize.x * scales.x * tangent;
    offset.y += (percent.y * unity_BillboardSize.y + unity_BillboardSize.z) * scales.y;
    return offset;
}
