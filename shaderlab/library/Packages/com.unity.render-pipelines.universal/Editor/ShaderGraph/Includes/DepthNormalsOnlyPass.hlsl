// Entry points of a generated pass of depth and world-space normals.
#pragma once

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

void frag(PackedVaryings packedInput, out float4 outNormalWS : SV_Target0)
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
#if defined(_ALPHATEST_ON)
    clip(surface.Alpha - surface.AlphaClipThreshold);
#endif
    float3 normalWS = unpacked.normalWS;
#if defined(_NORMALMAP) && _NORMAL_DROPOFF_TS
    float3 bitangent = cross(unpacked.normalWS, unpacked.tangentWS.xyz) * unpacked.tangentWS.w *
                       GetOddNegativeScale();
    normalWS = TransformTangentToWorld(
        surface.NormalTS, float3x3(unpacked.tangentWS.xyz, bitangent, unpacked.normalWS));
#elif defined(_NORMALMAP) && _NORMAL_DROPOFF_OS
    normalWS = TransformObjectToWorldNormal(surface.NormalOS);
#elif defined(_NORMALMAP) && _NORMAL_DROPOFF_WS
    normalWS = surface.NormalWS;
#endif
    outNormalWS = float4(NormalizeNormalPerPixel(normalWS), 0.0);
}
