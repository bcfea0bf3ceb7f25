// What a graph describes, as the lighting takes it.
#pragma once

// 1 where the surface is opaque; discards what the graph cuts out.
float limn_GraphAlpha(SurfaceDescription surface)
{
#if defined(_ALPHATEST_ON)
    return AlphaDiscard(surface.Alpha, surface.AlphaClipThreshold);
#elif defined(_SURFACE_TYPE_TRANSPARENT)
    return surface.Alpha;
#else
    return 1.0;
#endif
}

// The mesh's normal, bent by the graph's.
float3 limn_GraphNormal(Varyings input, SurfaceDescription surface)
{
#if defined(_NORMALMAP) && _NORMAL_DROPOFF_TS
    float3 bitangent = cross(input.normalWS, input.tangentWS.xyz) * input.tangentWS.w *
                       GetOddNegativeScale();
    float3 normal = TransformTangentToWorld(
        surface.NormalTS, float3x3(input.tangentWS.xyz, bitangent, input.normalWS));
#elif defined(_NORMALMAP) && _NORMAL_DROPOFF_OS
    float3 normal = TransformObjectToWorldNormal(surface.NormalOS);
#elif defined(_NORMALMAP) && _NORMAL_DROPOFF_WS
    float3 normal = surface.NormalWS;
#else
    float3 normal = input.normalWS;
#endif
    return NormalizeNormalPerPixel(normal);
}
