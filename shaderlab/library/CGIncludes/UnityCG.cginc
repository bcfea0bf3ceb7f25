#pragma once
#include "HLSLSupport.cginc"
#include "UnityShaderVariables.cginc"

#define UNITY_PI 3.14159265359
#define UNITY_TWO_PI 6.28318530718
#define UNITY_FOUR_PI 12.56637061436
#define UNITY_HALF_PI 1.57079632679
#define UNITY_INV_PI 0.31830988618
#define UNITY_INV_TWO_PI 0.15915494309

struct appdata_base
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_tan
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_full
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float4 texcoord3 : TEXCOORD3;
    fixed4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct appdata_img
{
    float4 vertex : POSITION;
    half2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct v2f_img
{
    float4 pos : SV_POSITION;
    half2 uv : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

float4 UnityWorldToClipPos(float3 pos) { return mul(UNITY_MATRIX_VP, float4(pos, 1.0)); }
float4 UnityViewToClipPos(float3 pos) { return mul(UNITY_MATRIX_P, float4(pos, 1.0)); }
float4 UnityObjectToClipPos(float3 pos)
{
    return UnityWorldToClipPos(mul(unity_ObjectToWorld, float4(pos, 1.0)).xyz);
}
float4 UnityObjectToClipPos(float4 pos) { return UnityObjectToClipPos(pos.xyz); }
float3 UnityWorldToViewPos(float3 pos) { return mul(UNITY_MATRIX_V, float4(pos, 1.0)).xyz; }
float3 UnityObjectToViewPos(float3 pos)
{
    return UnityWorldToViewPos(mul(unity_ObjectToWorld, float4(pos, 1.0)).xyz);
}
float3 UnityObjectToViewPos(float4 pos) { return UnityObjectToViewPos(pos.xyz); }

float3 UnityObjectToWorldDir(float3 dir) { return normalize(mul((float3x3)unity_ObjectToWorld, dir)); }
float3 UnityWorldToObjectDir(float3 dir) { return normalize(mul((float3x3)unity_WorldToObject, dir)); }
float3 UnityObjectToWorldNormal(float3 norm)
{
    return normalize(mul(norm, (float3x3)unity_WorldToObject));
}

// From a world position to the camera and to the light.
float3 UnityWorldSpaceViewDir(float3 worldPos) { return _WorldSpaceCameraPos - worldPos; }
float3 WorldSpaceViewDir(float4 localPos)
{
    return UnityWorldSpaceViewDir(mul(unity_ObjectToWorld, localPos).xyz);
}
float3 ObjSpaceViewDir(float4 localPos)
{
    return mul(unity_WorldToObject, float4(_WorldSpaceCameraPos, 1.0)).xyz - localPos.xyz;
}
float3 UnityWorldSpaceLightDir(float3 worldPos)
{
    return _WorldSpaceLightPos0.xyz - worldPos * _WorldSpaceLightPos0.w;
}
float3 WorldSpaceLightDir(float4 localPos)
{
    return UnityWorldSpaceLightDir(mul(unity_ObjectToWorld, localPos).xyz);
}
half3 ShadeSH9(half4 normal) { return unity_AmbientSky.rgb; }

// The x and y part of the projection: offsets in view space become offsets in clip space.
float2 TransformViewToProjection(float2 v) { return mul((float2x2)UNITY_MATRIX_P, v); }
float3 TransformViewToProjection(float3 v) { return mul((float3x3)UNITY_MATRIX_P, v); }

// Texture coordinate of the screen, times w; v runs down from the top, as rows of textures do.
float4 ComputeScreenPos(float4 pos)
{
    float4 result = pos;
    result.xy = float2(pos.x, -pos.y) * 0.5 + pos.w * 0.5;
    return result;
}
float4 ComputeNonStereoScreenPos(float4 pos) { return ComputeScreenPos(pos); }
float4 ComputeGrabScreenPos(float4 pos) { return ComputeScreenPos(pos); }

float Linear01Depth(float z) { return 1.0 / (_ZBufferParams.x * z + _ZBufferParams.y); }
float LinearEyeDepth(float z) { return 1.0 / (_ZBufferParams.z * z + _ZBufferParams.w); }
#define COMPUTE_EYEDEPTH(o) o = -UnityObjectToViewPos(v.vertex).z
#define COMPUTE_DEPTH_01 -(UnityObjectToViewPos(v.vertex).z * _ProjectionParams.w)
#define COMPUTE_VIEW_NORMAL normalize(mul((float3x3)UNITY_MATRIX_IT_MV, v.normal))
#define DECODE_EYEDEPTH(i) LinearEyeDepth(i)

half Luminance(half3 rgb) { return dot(rgb, half3(0.2126729, 0.7151522, 0.0721750)); }
half3 GammaToLinearSpace(half3 c)
{
    return lerp(c / 12.92, pow(abs((c + 0.055) / 1.055), 2.4), step(0.04045, c));
}
half3 LinearToGammaSpace(half3 c)
{
    return lerp(c * 12.92, 1.055 * pow(abs(c), 1.0 / 2.4) - 0.055, step(0.0031308, c));
}
half3 UnpackNormal(half4 packednormal)
{
    half2 xy = half2(packednormal.r * packednormal.a, packednormal.g) * 2.0 - 1.0;
    return half3(xy, sqrt(1.0 - saturate(dot(xy, xy))));
}

#define UNITY_FOG_COORDS(index)
#define UNITY_FOG_COORDS_PACKED(index, type)
#define UNITY_TRANSFER_FOG(o, outpos)
#define UNITY_APPLY_FOG(coord, col)
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol)

v2f_img vert_img(appdata_img v)
{
    v2f_img o;
    o.pos = UnityObjectToClipPos(v.vertex);
    o.uv = v.texcoord;
    return o;
}
