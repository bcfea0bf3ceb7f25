// Numbers and normals in channels of 8 bits, as the built-in pipeline packs them.
#pragma once

// 0 <= v < 1 in 4 or 2 channels: each holds what the one before leaves over, 255 times finer.
float4 EncodeFloatRGBA(float v)
{
    float4 parts = frac(float4(1.0, 255.0, 65025.0, 16581375.0) * v);
    return parts - parts.yzww * (1.0 / 255.0);
}
float DecodeFloatRGBA(float4 enc)
{
    return dot(enc, float4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0));
}
float2 EncodeFloatRG(float v)
{
    float2 parts = frac(float2(1.0, 255.0) * v);
    return float2(parts.x - parts.y * (1.0 / 255.0), parts.y);
}
float DecodeFloatRG(float2 enc) { return dot(enc, float2(1.0, 1.0 / 255.0)); }

// A colour up to maxRGBM as a share of a common factor, which alpha holds in steps of 1/255.
half4 UnityEncodeRGBM(half3 color, float maxRGBM)
{
    float3 share = color / maxRGBM;
    float high = max(max(share.r, share.g), max(share.b, 2.0 / 255.0));
    float factor = ceil(high * 255.0) / 255.0;
    return half4(share / factor, factor);
}

// A normal in view space on the plane that stereographic projection maps it to.
#define limn_StereoScale 1.7777
float2 EncodeViewNormalStereo(float3 n)
{
    return n.xy / (n.z + 1.0) / limn_StereoScale * 0.5 + 0.5;
}
float3 DecodeViewNormalStereo(float4 enc4)
{
    float2 plane = (enc4.xy * 2.0 - 1.0) * limn_StereoScale;
    float g = 2.0 / (dot(plane, plane) + 1.0);
    return float3(plane * g, g - 1.0);
}
float4 EncodeDepthNormal(float depth, float3 normal)
{
    return float4(EncodeViewNormalStereo(normal), EncodeFloatRG(depth));
}
void DecodeDepthNormal(float4 enc, out float depth, out float3 normal)
{
    depth = DecodeFloatRG(enc.zw);
    normal = DecodeViewNormalStereo(enc);
}

// Normals in textures: x and y in 0...1, z follows.
half3 limn_NormalFromXY(half2 packedXY, half scale)
{
    half2 xy = packedXY * 2.0 - 1.0;
    return half3(xy * scale, sqrt(1.0 - saturate(dot(xy, xy))));
}
// x in alpha, y in green
fixed3 UnpackNormalDXT5nm(fixed4 packednormal) { return limn_NormalFromXY(packednormal.wy, 1.0); }
// x in red where alpha is 1, or in alpha where red is 1
fixed3 UnpackNormalmapRGorAG(fixed4 packednormal)
{
    return limn_NormalFromXY(half2(packednormal.x * packednormal.w, packednormal.y), 1.0);
}
fixed3 UnpackNormal(fixed4 packednormal) { return UnpackNormalmapRGorAG(packednormal); }
half3 UnpackNormalWithScale(half4 packednormal, half scale)
{
    half3 normal = UnpackNormalmapRGorAG(packednormal);
    return half3(normal.xy * scale, normal.z);
}

float4 PackHeightmap(float height) { return float4(height, 0, 0, 0); }
float UnpackHeightmap(float4 height) { return height.r; }
