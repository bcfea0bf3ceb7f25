#pragma once
#ifndef SURFACE_DATA_2D_INCLUDED
#define SURFACE_DATA_2D_INCLUDED

struct SurfaceData2D
{
    half3 albedo;
    half alpha;
    half4 mask; // which lights reach it, by channel
    half3 normalTS;
};

void InitializeSurfaceData(half3 albedo, half alpha, half4 mask, half3 normalTS,
                           out SurfaceData2D surfaceData)
{
    surfaceData.normalTS = normalTS;
    surfaceData.mask = mask;
    surfaceData.alpha = alpha;
    surfaceData.albedo = albedo;
}
void InitializeSurfaceData(half3 albedo, half alpha, half4 mask, out SurfaceData2D surfaceData)
{
    InitializeSurfaceData(albedo, alpha, mask, half3(0, 0, 1), surfaceData);
}
void InitializeSurfaceData(half3 albedo, half alpha, out SurfaceData2D surfaceData)
{
    InitializeSurfaceData(albedo, alpha, half4(1, 1, 1, 1), surfaceData);
}
#endif
