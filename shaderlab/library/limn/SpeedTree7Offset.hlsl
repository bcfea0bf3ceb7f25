// Where the vertices of SpeedTree 6 and 7 are: levels of detail that blend, leaves that face the
// camera, and the wind.
#pragma once

#ifdef LOD_FADE_PERCENTAGE
#define limn_LOD_BLEND(now, next, value) lerp(now, next, value)
#else
#define limn_LOD_BLEND(now, next, value) (now)
#endif

// From a leaf's anchor; alpha is 0 of those that face the camera.
float3 limn_LeafOfTree7(float3 offset, float4 uv1, float2 uv3, float alpha, float lodValue)
{
    if (alpha == 0)
    {
        return limn_FaceCamera(limn_LOD_BLEND(offset, offset * uv1.w, lodValue));
    }
    return limn_LOD_BLEND(offset, float3(uv1.w, uv3), lodValue);
}

float3 limn_OffsetTree7(limn_TreeWind wind, float3 position, float4 uv, float4 uv1, float4 uv2,
                        float2 uv3, float alpha, float lodValue, inout float3 normal)
{
#if defined(GEOM_TYPE_BRANCH) || defined(GEOM_TYPE_FROND)
    position = limn_LOD_BLEND(position, uv1.xyz, lodValue);
#ifdef GEOM_TYPE_FROND
    limn_BlowFrond(wind, uv.xy, uv2.xyz, position, normal);
#endif
#elif defined(GEOM_TYPE_LEAF)
    float3 offset = limn_LeafOfTree7(position - uv1.xyz, uv1, uv3, alpha, lodValue);
    limn_BlowLeaf(wind, uv2.w > 0.0, uv1.xyz, uv2.xyz, offset, normal);
    position = uv1.xyz + offset;
#endif
#ifndef GEOM_TYPE_MESH
    position = limn_BlowBranch(wind, uv.zw, position);
#endif
    return limn_BlowTree(wind, position);
}
