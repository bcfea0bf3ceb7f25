// Vertices of SpeedTree 8, for both pipelines: one mesh for all kinds of geometry. texcoord.zw: wind of
// the branch; texcoord1.zw, texcoord2.w: anchor of a leaf; texcoord2.xyz: the place at the next level
// of detail; texcoord3: wind of leaf or frond, kind of geometry.
#pragma once

#define GEOM_TYPE_BRANCH 0
#define GEOM_TYPE_FROND 1
#define GEOM_TYPE_LEAF 2
#define GEOM_TYPE_FACINGLEAF 3

#if defined(ENABLE_WIND) && !defined(_WINDQUALITY_NONE)
#define limn_SPEEDTREE8_WIND 1
float _WindEnabled;
float _GlobalWindTime; // of an instance, where billboards are drawn as such
#include "limn/SpeedTreeWindOfTree.hlsl"
#if defined(_WINDQUALITY_PALM)
#define limn_SPEEDTREE8_QUALITY WIND_QUALITY_PALM
#elif defined(_WINDQUALITY_BEST)
#define limn_SPEEDTREE8_QUALITY WIND_QUALITY_BEST
#elif defined(_WINDQUALITY_BETTER)
#define limn_SPEEDTREE8_QUALITY WIND_QUALITY_BETTER
#elif defined(_WINDQUALITY_FAST)
#define limn_SPEEDTREE8_QUALITY WIND_QUALITY_FAST
#else
#define limn_SPEEDTREE8_QUALITY WIND_QUALITY_FASTEST
#endif

float3 limn_BlowGeometry8(limn_TreeWind wind, float4 uv, float4 uv1, float4 uv2, float4 uv3,
                          float3 position, inout float3 normal)
{
    int kind = (int)(uv3.w + 0.25);
    bool isSecond = kind > GEOM_TYPE_FACINGLEAF;
    kind -= isSecond ? 2 : 0;
    if (kind >= GEOM_TYPE_LEAF)
    {
        float3 anchor = float3(uv1.zw, uv2.w);
        float3 offset = position - anchor;
        if (kind == GEOM_TYPE_FACINGLEAF)
        {
            offset = limn_FaceCamera(offset);
        }
        limn_BlowLeaf(wind, isSecond, anchor, uv3.xyz, offset, normal);
        position = anchor + offset;
    }
    else if (kind == GEOM_TYPE_FROND)
    {
        limn_BlowFrond(wind, uv.xy, uv3.xyz, position, normal);
    }
    return limn_BlowBranch(wind, uv.zw, position);
}

float3 limn_BlowSpeedTree8(float4 uv, float4 uv1, float4 uv2, float4 uv3, float3 position,
                           inout float3 normal)
{
    limn_TreeWind wind = limn_WindOfTree(_WindEnabled > 0 ? limn_SPEEDTREE8_QUALITY : 0);
    if (wind.quality <= WIND_QUALITY_NONE)
    {
        return position;
    }
#ifndef EFFECT_BILLBOARD
    position = limn_BlowGeometry8(wind, uv, uv1, uv2, uv3, position, normal);
#endif
    return limn_BlowTree(wind, position);
}
#endif

// A billboard is made of planes around the tree and one from above; those seen from the side fade, and
// their normals turn to the camera so that no seams show. cameraDir: from the tree, of length 1.
void limn_FadeBillboard8(float3 cameraDir, bool isFromAbove, float4 tangent, inout float3 position,
                         inout float3 normal, out float4 color)
{
    float facing = max(dot(UNITY_MATRIX_IT_MV[2].xyz, normal), dot(cameraDir, normal));
    float seen = pow(abs(facing), 4.0) + (isFromAbove ? 0.38 : 0.18);
    color = float4(1, 1, 1, saturate(seen));
    position *= seen < 0.3333 ? 0.0 : 1.0; // nothing is drawn of it
    if (isFromAbove)
    {
        normal = normalize(normal + cameraDir);
    }
    else
    {
        float3 up = cross(normal, tangent.xyz) * tangent.w;
        normal = normalize(cross(up, cross(cameraDir, up)));
    }
}

// How far the hue of the tree at a place varies, of 1.
float limn_HueOfTree() { return frac(dot(UNITY_MATRIX_M._14_24_34, 1.0)); }
