// Vertices of SpeedTree 6 and 7: levels of detail that blend, leaves that face the camera.
#pragma once
#define SPEEDTREE_VERTEX_INCLUDED
#include "UnityCG.cginc"

// texcoord: diffuse uv, wind of the branch. texcoord1: the place at the next level of detail or, of
// leaves, their anchor and scale there. texcoord2: detail uv, or the wind's. color.a of leaves: 0 where
// they face the camera.
struct SpeedTreeVB
{
    float4 vertex : POSITION;
    float4 tangent : TANGENT;
    float3 normal : NORMAL;
    float4 texcoord : TEXCOORD0;
    float4 texcoord1 : TEXCOORD1;
    float4 texcoord2 : TEXCOORD2;
    float2 texcoord3 : TEXCOORD3;
    half4 color : COLOR;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

#ifdef ENABLE_WIND
#define WIND_QUALITY_NONE 0
#define WIND_QUALITY_FASTEST 1
#define WIND_QUALITY_FAST 2
#define WIND_QUALITY_BETTER 3
#define WIND_QUALITY_BEST 4
#define WIND_QUALITY_PALM 5
half _WindQuality, _WindEnabled;
#include "SpeedTreeWind.cginc"
#endif

#ifdef LOD_FADE_PERCENTAGE
#define limn_LOD_BLEND(now, next, value) lerp(now, next, value)
#else
#define limn_LOD_BLEND(now, next, value) (now)
#endif

// A leaf's vertex, from its anchor.
float3 limn_SpeedTreeLeaf(float3 offset, SpeedTreeVB data, float lodValue)
{
    if (data.color.a == 0)
    {
        offset = limn_LOD_BLEND(offset, offset * data.texcoord1.w, lodValue);
        return normalize(mul(offset, (float3x3)UNITY_MATRIX_IT_MV)) * length(offset);
    }
    return limn_LOD_BLEND(offset, float3(data.texcoord1.w, data.texcoord3), lodValue);
}

void OffsetSpeedTreeVertex(inout SpeedTreeVB data, float lodValue)
{
    float3 position = data.vertex.xyz;
#if defined(GEOM_TYPE_BRANCH) || defined(GEOM_TYPE_FROND)
    position = limn_LOD_BLEND(position, data.texcoord1.xyz, lodValue);
#elif defined(GEOM_TYPE_LEAF)
    float3 anchor = data.texcoord1.xyz;
    position = limn_SpeedTreeLeaf(position - anchor, data, lodValue) + anchor;
#endif
#ifdef ENABLE_WIND
    position = GlobalWind(position, unity_ObjectToWorld._14_24_34, true, _ST_WindVector.xyz,
                          _ST_WindGlobal.x);
#endif
    data.vertex.xyz = position;
}
