// Light from all around in real spherical harmonics, as Unity lays out the nine coefficients of each
// channel: A = (x, y, z, constant), B = (xy, yz, zz, zx), C = (xx - yy for r, g, b).
#pragma once

float3 limn_ShLinear(float4 normal, float4 ar, float4 ag, float4 ab)
{
    return float3(dot(ar, normal), dot(ag, normal), dot(ab, normal));
}
float3 limn_ShQuadratic(float3 n, float4 br, float4 bg, float4 bb, float4 c)
{
    float4 products = float4(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x);
    float3 mixed = float3(dot(br, products), dot(bg, products), dot(bb, products));
    return mixed + c.rgb * (n.x * n.x - n.y * n.y);
}
