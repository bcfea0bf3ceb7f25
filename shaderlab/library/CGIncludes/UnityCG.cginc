#pragma once
#ifndef UNITY_CG_INCLUDED
#define UNITY_CG_INCLUDED
#include "UnityShaderVariables.cginc"
#include "UnityShaderUtilities.cginc"
#include "UnityInstancing.cginc"

#define UNITY_PI 3.14159265359
#define UNITY_TWO_PI 6.28318530718
#define UNITY_FOUR_PI 12.56637061436
#define UNITY_INV_PI 0.31830988618
#define UNITY_INV_TWO_PI 0.15915494309
#define UNITY_INV_FOUR_PI 0.07957747155
#define UNITY_HALF_PI 1.57079632679
#define UNITY_INV_HALF_PI 0.636619772367
#define UNITY_HALF_MIN 6.103515625e-5

// Of fixed-function times, when textures and normals had a matrix of their own.
#define UNITY_MATRIX_TEXTURE0 float4x4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
#define UNITY_MATRIX_TEXTURE1 UNITY_MATRIX_TEXTURE0
#define UNITY_MATRIX_TEXTURE2 UNITY_MATRIX_TEXTURE0
#define UNITY_MATRIX_TEXTURE3 UNITY_MATRIX_TEXTURE0
#define SCALED_NORMAL (v.normal)

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

struct v2f_vertex_lit
{
    float2 uv : TEXCOORD0;
    fixed4 diff : COLOR0;
    fixed4 spec : COLOR1;
};

#include "limn/BuiltinColor.hlsl"
#include "limn/BuiltinSpaces.hlsl"
#include "limn/BuiltinEncoding.hlsl"
#include "limn/BuiltinAmbient.hlsl"
#include "limn/BuiltinFog.hlsl"
#include "limn/BuiltinShadowCaster.hlsl"

float2 MultiplyUV(float4x4 mat, float2 uv) { return mul(mat, float4(uv, 0, 0)).xy; }

v2f_img vert_img(appdata_img v)
{
    v2f_img o;
    UNITY_INITIALIZE_OUTPUT(v2f_img, o);
    o.uv = v.texcoord;
    o.pos = UnityObjectToClipPos(v.vertex);
    return o;
}

fixed4 VertexLight(v2f_vertex_lit i, sampler2D mainTex)
{
    fixed4 texel = tex2D(mainTex, i.uv);
    return fixed4(texel.rgb * i.diff.rgb + i.spec.rgb * texel.a, texel.a) * fixed4(2, 2, 2, 1);
}

// How far a texture coordinate moves for the height that a height map gives; viewDir is in tangent
// space. The constant keeps the shift bounded where the surface is seen from the side.
float2 ParallaxOffset(half h, half height, half3 viewDir)
{
    float3 v = normalize(viewDir);
    return (h * height - height / 2.0) * v.xy / (v.z + 0.42);
}

// Positions of pixels' centres, for text and images that must stay sharp.
float4 UnityPixelSnap(float4 pos)
{
    float2 halfSize = _ScreenParams.xy * 0.5;
    float2 pixel = round(pos.xy / pos.w * halfSize);
    return float4(pixel / halfSize * pos.w, pos.zw);
}

// There is no cross-fading between levels of detail.
#define UNITY_DITHER_CROSSFADE_COORDS
#define UNITY_DITHER_CROSSFADE_COORDS_IDX(index)
#define UNITY_TRANSFER_DITHER_CROSSFADE(o, v)
#define UNITY_TRANSFER_DITHER_CROSSFADE_HPOS(o, hpos)
#define UNITY_APPLY_DITHER_CROSSFADE(i)
#define UnityApplyDitherCrossFade(pos)
#endif
