#pragma once

// Normals in textures: x and y in 0...1, z follows. Works for x in red and for x in alpha, where red
// is 1.
float3 UnpackNormalScale(float4 packedNormal, float scale)
{
    float2 xy = float2(packedNormal.r * packedNormal.a, packedNormal.g) * 2.0 - 1.0;
    float z = sqrt(max(1e-16, 1.0 - saturate(dot(xy, xy))));
    return float3(xy * scale, z);
}
float3 UnpackNormal(float4 packedNormal) { return UnpackNormalScale(packedNormal, 1.0); }
float3 UnpackNormalmapRGorAG(float4 packedNormal, float scale = 1.0)
{
    return UnpackNormalScale(packedNormal, scale);
}

// Unit vectors on an octahedron, unfolded to -1...1.
float2 PackNormalOctQuadEncode(float3 n)
{
    n /= max(dot(abs(n), float3(1, 1, 1)), 1e-6);
    float fold = saturate(-n.z);
    return n.xy + float2(n.x >= 0.0 ? fold : -fold, n.y >= 0.0 ? fold : -fold);
}
float3 UnpackNormalOctQuadEncode(float2 f)
{
    float3 n = float3(f, 1.0 - abs(f.x) - abs(f.y));
    float fold = max(-n.z, 0.0);
    n.xy += float2(n.x >= 0.0 ? -fold : fold, n.y >= 0.0 ? -fold : fold);
    return normalize(n);
}
