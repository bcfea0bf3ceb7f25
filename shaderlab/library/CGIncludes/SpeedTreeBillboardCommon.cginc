// Far SpeedTrees: a quad that turns about its height, with the picture from the side it is seen from.
// Scripts set its globals: limn has no billboard renderer.
#pragma once
#define SPEEDTREE_BILLBOARD_COMMON_INCLUDED
#include "UnityCG.cginc"
#define SPEEDTREE_ALPHATEST
fixed _Cutoff;
#include "SpeedTreeCommon.cginc"

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

struct SpeedTreeBillboardData
{
    float4 vertex : POSITION;
    float2 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1; // scale of width and height, rotation
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

// Which way the quad faces, and the angle to it; the tangent is level.
float limn_FaceBillboard(float3 worldPos, out float3 tangent, out float3 normal)
{
#ifdef BILLBOARD_FACE_CAMERA_POS
    float3 eye = normalize(unity_BillboardCameraPosition - worldPos);
    tangent = normalize(float3(-eye.z, 0, eye.x));
    normal = float3(tangent.z, 0, -tangent.x);
    float angle = atan2(normal.z, normal.x);
    return angle + (angle < 0 ? 2 * UNITY_PI : 0);
#else
    tangent = unity_BillboardTangent;
    normal = unity_BillboardNormal;
    return unity_BillboardCameraXZAngle;
#endif
}

void SpeedTreeBillboardVert(inout SpeedTreeBillboardData IN, out Input OUT)
{
    UNITY_INITIALIZE_OUTPUT(Input, OUT);
    float3 worldPos = IN.vertex.xyz + unity_ObjectToWorld._14_24_34;
    float3 tangent, normal;
    float angle = limn_FaceBillboard(worldPos, tangent, normal) + IN.texcoord1.z;

    float2 percent = IN.texcoord;
    float3 offset = (percent.x - 0.5) * unity_BillboardSize.x * IN.texcoord1.x * tangent;
    offset.y += (percent.y * unity_BillboardSize.y + unity_BillboardSize.z) * IN.texcoord1.y;
#ifdef ENABLE_WIND
    offset = GlobalWind(offset, worldPos, true, _ST_WindVector.xyz, IN.texcoord1.w);
#endif
    IN.vertex = float4(IN.vertex.xyz + offset, 1);
    IN.normal = normal;
    IN.tangent = float4(tangent, -1);

    uint image = (uint)fmod(floor(angle * unity_BillboardInfo.y + 0.5), unity_BillboardInfo.x);
    float4 part = unity_BillboardImageTexCoords[image];
    OUT.mainTexUV = part.w < 0 ? part.xy - part.zw * percent.yx : part.xy + part.zw * percent;
    OUT.color = _Color;
#ifdef EFFECT_HUE_VARIATION
    OUT.HueVariationAmount = saturate(frac(dot(worldPos, 1.0)) * _HueVariation.a);
#endif
}
