// Fog of the built-in pipeline: the vertex function hands clip space z on, the fragment function
// turns it into a factor (1: no fog). The keyword chooses the curve.
#pragma once
#include "limn/Screen.hlsl"

#define UNITY_Z_0_FAR_FROM_CLIPSPACE(coord) limn_DistanceFromClipZ(coord, _ProjectionParams)

float limn_FogLinear(float distance, float4 fogParams)
{
    return distance * fogParams.z + fogParams.w;
}
float limn_FogExp(float distance, float4 fogParams) { return exp2(-distance * fogParams.y); }
float limn_FogExp2(float distance, float4 fogParams)
{
    float f = distance * fogParams.x;
    return exp2(-f * f);
}

#if defined(FOG_LINEAR)
#define UNITY_CALC_FOG_FACTOR_RAW(coord) \
    float unityFogFactor = limn_FogLinear(coord, unity_FogParams)
#elif defined(FOG_EXP)
#define UNITY_CALC_FOG_FACTOR_RAW(coord) float unityFogFactor = limn_FogExp(coord, unity_FogParams)
#elif defined(FOG_EXP2)
#define UNITY_CALC_FOG_FACTOR_RAW(coord) float unityFogFactor = limn_FogExp2(coord, unity_FogParams)
#else
#define UNITY_CALC_FOG_FACTOR_RAW(coord) float unityFogFactor = 1.0
#endif
#define UNITY_CALC_FOG_FACTOR(coord) UNITY_CALC_FOG_FACTOR_RAW(UNITY_Z_0_FAR_FROM_CLIPSPACE(coord))
#define UNITY_FOG_LERP_COLOR(col, fogCol, fogFac) \
    col.rgb = lerp((fogCol).rgb, (col).rgb, saturate(fogFac))

#if defined(FOG_LINEAR) || defined(FOG_EXP) || defined(FOG_EXP2)
#define UNITY_FOG_COORDS(index) UNITY_FOG_COORDS_PACKED(index, float)
#define UNITY_FOG_COORDS_PACKED(index, type) type fogCoord : TEXCOORD##index;
#define UNITY_TRANSFER_FOG(o, outpos) o.fogCoord.x = (outpos).z
#define UNITY_TRANSFER_FOG_COMBINED_WITH_TSPACE(o, outpos) o.tSpace1.y = (outpos).z
#define UNITY_TRANSFER_FOG_COMBINED_WITH_WORLD_POS(o, outpos) o.worldPos.w = (outpos).z
#define UNITY_TRANSFER_FOG_COMBINED_WITH_EYE_VEC(o, outpos) o.eyeVec.w = (outpos).z
#define UNITY_EXTRACT_FOG(name) float _unity_fogCoord = name.fogCoord
#define UNITY_EXTRACT_FOG_FROM_TSPACE(name) float _unity_fogCoord = name.tSpace1.y
#define UNITY_EXTRACT_FOG_FROM_WORLD_POS(name) float _unity_fogCoord = name.worldPos.w
#define UNITY_EXTRACT_FOG_FROM_EYE_VEC(name) float _unity_fogCoord = name.eyeVec.w
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol) \
    { \
        UNITY_CALC_FOG_FACTOR((coord).x); \
        UNITY_FOG_LERP_COLOR(col, fogCol, unityFogFactor); \
    }
#else
#define UNITY_FOG_COORDS(index)
#define UNITY_FOG_COORDS_PACKED(index, type)
#define UNITY_TRANSFER_FOG(o, outpos)
#define UNITY_TRANSFER_FOG_COMBINED_WITH_TSPACE(o, outpos)
#define UNITY_TRANSFER_FOG_COMBINED_WITH_WORLD_POS(o, outpos)
#define UNITY_TRANSFER_FOG_COMBINED_WITH_EYE_VEC(o, outpos)
#define UNITY_EXTRACT_FOG(name)
#define UNITY_EXTRACT_FOG_FROM_TSPACE(name)
#define UNITY_EXTRACT_FOG_FROM_WORLD_POS(name)
#define UNITY_EXTRACT_FOG_FROM_EYE_VEC(name)
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol)
#endif

// A pass that adds a light must not add the fog once more.
#ifdef UNITY_PASS_FORWARDADD
#define UNITY_APPLY_FOG(coord, col) UNITY_APPLY_FOG_COLOR(coord, col, fixed4(0, 0, 0, 0))
#else
#define UNITY_APPLY_FOG(coord, col) UNITY_APPLY_FOG_COLOR(coord, col, unity_FogColor)
#endif
