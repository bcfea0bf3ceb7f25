// Levels of detail, cut-outs, directions of cube maps, texture coordinates.
#pragma once

// Which level of a texture of so many texels fits derivatives in texels.
float ComputeTextureLOD(float2 uvdx, float2 uvdy, float2 scale, float bias = 0.0)
{
    float2 dx = scale * uvdx;
    float2 dy = scale * uvdy;
    return max(0.5 * log2(max(dot(dx, dx), dot(dy, dy))) + bias, 0.0);
}
float ComputeTextureLOD(float2 uv, float bias = 0.0)
{
    return ComputeTextureLOD(ddx(uv), ddy(uv), float2(1, 1), bias);
}
float ComputeTextureLOD(float2 uv, float2 texelSize, float bias = 0.0)
{
    return ComputeTextureLOD(uv * texelSize, bias);
}

// How much of a pixel a cut-out covers, for alpha to coverage: alpha runs from 0 to 1 within the one
// pixel where it crosses the threshold.
float SharpenAlpha(float alpha, float alphaClipTreshold)
{
    float pixels = (alpha - alphaClipTreshold) / max(1e-4, fwidth(alpha));
    return saturate(0.5 + pixels);
}

uint GetMipCount(Texture2D tex, SamplerState smp)
{
    uint width, height, levels;
    tex.GetDimensions(0, width, height, levels);
    return levels;
}

// The face of a cube map that a direction meets: see CUBEMAPFACE_POSITIVE_X.
float CubeMapFaceID(float3 dir)
{
    float3 size = abs(dir);
    if (size.z >= size.x && size.z >= size.y)
    {
        return dir.z < 0.0 ? CUBEMAPFACE_NEGATIVE_Z : CUBEMAPFACE_POSITIVE_Z;
    }
    if (size.y >= size.x)
    {
        return dir.y < 0.0 ? CUBEMAPFACE_NEGATIVE_Y : CUBEMAPFACE_POSITIVE_Y;
    }
    return dir.x < 0.0 ? CUBEMAPFACE_NEGATIVE_X : CUBEMAPFACE_POSITIVE_X;
}

// Longitude and latitude in 0...1; y is up.
float2 DirectionToLatLongCoordinate(float3 dir)
{
    float3 d = normalize(dir);
    return float2(1.0 - 0.5 * INV_PI * atan2(d.x, -d.z), asin(d.y) * INV_PI + 0.5);
}
float3 LatlongToDirectionCoordinate(float2 coord)
{
    float theta = coord.y * PI;
    float phi = (coord.x * 2.0 - 0.5) * PI;
    return float3(sin(theta) * cos(phi), -cos(theta), sin(theta) * sin(phi));
}

// Keeps a part of the pixels that grows with the factor: what fades in takes the pixels that what
// fades out (a negative factor) leaves.
void LODDitheringTransition(uint2 fadeMaskSeed, float ditherFactor)
{
    float p = GenerateHashedRandomFloat(fadeMaskSeed);
    clip(ditherFactor - CopySign(p, ditherFactor));
}

// What a screen-space pass knows of the place it works on.
struct PositionInputs
{
    float3 positionWS;
    float2 positionNDC;
    uint2 positionSS;
    uint2 tileCoord;
    float deviceDepth;
    float linearDepth;
};

PositionInputs GetPositionInput(float2 positionSS, float2 invScreenSize, uint2 tileCoord)
{
    PositionInputs result = (PositionInputs)0;
    result.positionNDC = positionSS * invScreenSize;
    result.positionSS = (uint2)positionSS;
    result.tileCoord = tileCoord;
    return result;
}
PositionInputs GetPositionInput(float2 positionSS, float2 invScreenSize)
{
    return GetPositionInput(positionSS, invScreenSize, uint2(0, 0));
}
PositionInputs GetPositionInput(float2 positionSS, float2 invScreenSize, float3 positionWS)
{
    PositionInputs result = GetPositionInput(positionSS, invScreenSize, uint2(0, 0));
    result.positionWS = positionWS;
    return result;
}
PositionInputs GetPositionInput(float2 positionSS, float2 invScreenSize, float deviceDepth,
                                float linearDepth, float3 positionWS, uint2 tileCoord)
{
    PositionInputs result = GetPositionInput(positionSS, invScreenSize, tileCoord);
    result.positionWS = positionWS;
    result.deviceDepth = deviceDepth;
    result.linearDepth = linearDepth;
    return result;
}
PositionInputs GetPositionInput(float2 positionSS, float2 invScreenSize, float deviceDepth,
                                float linearDepth, float3 positionWS)
{
    return GetPositionInput(positionSS, invScreenSize, deviceDepth, linearDepth, positionWS,
                            uint2(0, 0));
}
PositionInputs GetPositionInput(float2 positionSS, float2 invScreenSize, float deviceDepth,
                                float4x4 invViewProjMatrix, float4x4 viewMatrix, uint2 tileCoord)
{
    PositionInputs result = GetPositionInput(positionSS, invScreenSize, tileCoord);
    result.positionWS =
        ComputeWorldSpacePosition(result.positionNDC, deviceDepth, invViewProjMatrix);
    result.deviceDepth = deviceDepth;
    result.linearDepth = LinearEyeDepth(result.positionWS, viewMatrix);
    return result;
}
PositionInputs GetPositionInput(float2 positionSS, float2 invScreenSize, float deviceDepth,
                                float4x4 invViewProjMatrix, float4x4 viewMatrix)
{
    return GetPositionInput(positionSS, invScreenSize, deviceDepth, invViewProjMatrix, viewMatrix,
                            uint2(0, 0));
}
