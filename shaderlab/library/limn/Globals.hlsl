// Values that are the same for all draws of a camera. Two buffers, so that a pass that uses none of
// them has none.
#pragma once

cbuffer limn_PerCamera
{
    float4 _Time;          // t/20, t, 2t, 3t; seconds
    float4 _SinTime;       // sin of t/8, t/4, t/2, t
    float4 _CosTime;       // cos of the same
    float4 unity_DeltaTime; // dt, 1/dt, smoothed dt, 1/smoothed dt
    float4 _TimeParameters; // t, sin t, cos t, 0

    float3 _WorldSpaceCameraPos;
    float4 _ProjectionParams;   // -1 (1 into a back buffer), near, far, 1/far
    float4 _ScreenParams;       // camera width, height in pixels, 1 + 1/width, 1 + 1/height
    float4 _ScaledScreenParams; // the same of the target that is drawn to
    float4 _ScreenSize;         // target width, height, 1/width, 1/height
    float4 _ZBufferParams;      // far/near - 1, 1, 1/near - 1/far, 1/far
    float4 unity_OrthoParams;   // half width, half height, 0, 1 if orthographic
    float4 _ScaleBiasRt;        // -1, 1, -1, 1; into a back buffer 1, 0, 1, 1
    float2 _GlobalMipBias;      // bias, 2^bias

    float4x4 unity_MatrixV;
    float4x4 unity_MatrixInvV;
    float4x4 glstate_matrix_projection;
    float4x4 unity_MatrixInvP;
    float4x4 unity_MatrixVP;
    float4x4 unity_MatrixInvVP;
    float4x4 unity_WorldToCamera; // z forward, unlike unity_MatrixV
    float4x4 unity_CameraToWorld;
    float4x4 unity_CameraProjection;
    float4x4 unity_CameraInvProjection;

    float4 limn_Origin;   // what RelativeSpaces.hlsl is relative to; w: 1 if it is not 0
    float4 limn_OriginVS; // where that is in view space, w: 1
    float4 limn_OriginCS; // and in clip space
    float4 limn_CameraPos; // of the camera, relative to limn_Origin
};

cbuffer limn_PerFrameLighting
{
    float4 _MainLightPosition; // xyz: direction to the light, w: 0
    float4 _MainLightColor;
    float4 unity_AmbientSky;   // ambient light from above
    float4 unity_AmbientEquator;
    float4 unity_AmbientGround;
    float4 unity_SHAr; // ambient light by direction: spherical harmonics of order 1 of red
    float4 unity_SHAg;
    float4 unity_SHAb;
    float4 unity_SHBr; // order 2
    float4 unity_SHBg;
    float4 unity_SHBb;
    float4 unity_SHC; // the last of order 2 for red, green, blue
    float4 unity_FogParams;    // density/sqrt(ln 2), density/ln 2, -1/(end - start), end/(end - start)
    float4 unity_FogColor;
};

#define UNITY_LIGHTMODEL_AMBIENT unity_AmbientSky

#define UNITY_MATRIX_M unity_ObjectToWorld
#define UNITY_MATRIX_I_M unity_WorldToObject
#define UNITY_MATRIX_V unity_MatrixV
#define UNITY_MATRIX_I_V unity_MatrixInvV
#define UNITY_MATRIX_P glstate_matrix_projection
#define UNITY_MATRIX_I_P unity_MatrixInvP
#define UNITY_MATRIX_VP unity_MatrixVP
#define UNITY_MATRIX_I_VP unity_MatrixInvVP
#define UNITY_MATRIX_MV mul(limn_RelativeV(), limn_RelativeM())
#define UNITY_MATRIX_T_MV transpose(UNITY_MATRIX_MV)
#define UNITY_MATRIX_IT_MV transpose(mul(UNITY_MATRIX_I_M, UNITY_MATRIX_I_V))
#define UNITY_MATRIX_MVP mul(limn_RelativeVP(), limn_RelativeM())
