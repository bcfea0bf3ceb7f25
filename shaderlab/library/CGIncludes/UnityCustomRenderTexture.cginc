// Shaders that draw a custom render texture: a texture that is worked out again from itself, zone
// by zone. limn has no such texture, so that nothing sets these values; a caller that sets them and
// draws 6 vertices per zone gets what Unity draws.
#pragma once
#ifndef UNITY_CUSTOM_TEXTURE_INCLUDED
#define UNITY_CUSTOM_TEXTURE_INCLUDED
#include "UnityCG.cginc"
#include "UnityStandardConfig.cginc"

#define kCustomTextureBatchSize 16

struct appdata_customrendertexture
{
    uint vertexID : SV_VertexID;
};

struct v2f_customrendertexture
{
    float4 vertex : SV_POSITION;
    float3 localTexcoord : TEXCOORD0;  // 0...1 over the zone; z: of the slice of a 3D texture
    float3 globalTexcoord : TEXCOORD1; // 0...1 over the texture
    uint primitiveID : TEXCOORD2;      // which zone
    float3 direction : TEXCOORD3;      // from the middle of a cube texture
};

float4 CustomRenderTextureCenters[kCustomTextureBatchSize];
float4 CustomRenderTextureSizesAndRotations[kCustomTextureBatchSize]; // w: degrees
float CustomRenderTexturePrimitiveIDs[kCustomTextureBatchSize];       // bits of a number
float4 CustomRenderTextureParameters;
#define CustomRenderTextureUpdateSpace CustomRenderTextureParameters.x // 1: zones in pixels
#define CustomRenderTexture3DTexcoordW CustomRenderTextureParameters.y
#define CustomRenderTextureIs3D CustomRenderTextureParameters.z

float4 _CustomRenderTextureInfo; // width, height, depth, face or slice
#define _CustomRenderTextureWidth _CustomRenderTextureInfo.x
#define _CustomRenderTextureHeight _CustomRenderTextureInfo.y
#define _CustomRenderTextureDepth _CustomRenderTextureInfo.z
#define _CustomRenderTextureCubeFace _CustomRenderTextureInfo.w
#define _CustomRenderTexture3DSlice _CustomRenderTextureInfo.w

// The texture as it was before.
sampler2D _SelfTexture2D;
samplerCUBE _SelfTextureCube;
sampler3D _SelfTexture3D;

// The angle in radians.
float2 CustomRenderTextureRotate2D(float2 pos, float angle)
{
    float s = sin(angle);
    float c = cos(angle);
    return float2(c * pos.x - s * pos.y, s * pos.x + c * pos.y);
}

// Through a place on the face _CustomRenderTextureCubeFace.
float3 CustomRenderTextureComputeCubeDirection(float2 globalTexcoord)
{
    float right = globalTexcoord.x * 2.0 - 1.0;
    float up = 1.0 - globalTexcoord.y * 2.0;
    int face = (int)_CustomRenderTextureCubeFace;
    float side = face % 2 == 0 ? 1.0 : -1.0;
    float3 direction = face < 2   ? float3(side, up, -right * side)
                       : face < 4 ? float3(right, side, -up * side)
                                  : float3(right * side, up, side);
    return normalize(direction);
}

// Is the slice that is drawn one of the zone's? Always, where the texture is no 3D texture.
bool limn_ZoneHasSlice(float3 center, float3 size)
{
    int first = (int)(center.z - size.z * 0.5);
    int slice = (int)_CustomRenderTexture3DSlice;
    return CustomRenderTextureIs3D <= 0.0 || slice >= first && slice < first + (int)size.z;
}

v2f_customrendertexture CustomRenderTextureVertexShader(appdata_customrendertexture IN)
{
    uint zone = IN.vertexID / 6;
    uint corner = IN.vertexID % 6;
    bool right = corner == 2 || corner == 3 || corner == 5;
    bool bottom = corner == 1 || corner == 2 || corner == 5;
    float3 center = CustomRenderTextureCenters[zone].xyz;
    float3 size = CustomRenderTextureSizesAndRotations[zone].xyz;
    bool pixels = CustomRenderTextureUpdateSpace > 0.0;
    float3 unit = pixels ? float3(1.0 / _CustomRenderTextureInfo.xy, 1.0)
                         : float3(1.0, 1.0, _CustomRenderTextureInfo.z);
    center *= unit;
    size *= unit;

    float2 pos = float2(right ? size.x : -size.x, bottom ? -size.y : size.y);
    pos = CustomRenderTextureRotate2D(pos, radians(CustomRenderTextureSizesAndRotations[zone].w));
    pos += center.xy * 2.0 - 1.0;
    if (!limn_ZoneHasSlice(center, size))
    {
        pos = float2(1000.0, 1000.0); // out of sight
    }

    v2f_customrendertexture OUT;
    OUT.vertex = float4(pos, 0.0, 1.0);
    OUT.primitiveID = asuint(CustomRenderTexturePrimitiveIDs[zone]);
    OUT.localTexcoord = float3(right, bottom, CustomRenderTexture3DTexcoordW);
    OUT.globalTexcoord =
        float3(pos.x * 0.5 + 0.5, 0.5 - pos.y * 0.5, CustomRenderTexture3DTexcoordW);
    OUT.direction = CustomRenderTextureComputeCubeDirection(OUT.globalTexcoord.xy);
    return OUT;
}

// For shaders that fill the texture once, by a mesh that covers it.
struct appdata_init_customrendertexture
{
    float4 vertex : POSITION;
    float2 texcoord : TEXCOORD0;
};

struct v2f_init_customrendertexture
{
    float4 vertex : SV_POSITION;
    float2 texcoord : TEXCOORD0;
    float3 direction : TEXCOORD1;
};

v2f_init_customrendertexture InitCustomRenderTextureVertexShader(
    appdata_init_customrendertexture v)
{
    v2f_init_customrendertexture o;
    o.vertex = UnityObjectToClipPos(v.vertex);
    o.texcoord = v.texcoord;
    o.direction = CustomRenderTextureComputeCubeDirection(v.texcoord);
    return o;
}
#endif
