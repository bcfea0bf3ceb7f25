// What generated shaders call in every pipeline.
#pragma once

struct Gradient
{
    int type; // 0: blended between the keys, otherwise fixed at the next key
    int colorsLength;
    int alphasLength;
    float4 colors[8]; // w: place of the key
    float2 alphas[8]; // y: place of the key
};

Gradient NewGradient(int type, int colorsLength, int alphasLength, float4 colors0, float4 colors1,
                     float4 colors2, float4 colors3, float4 colors4, float4 colors5,
                     float4 colors6, float4 colors7, float2 alphas0, float2 alphas1,
                     float2 alphas2, float2 alphas3, float2 alphas4, float2 alphas5,
                     float2 alphas6, float2 alphas7)
{
    float4 colors[8] = {colors0, colors1, colors2, colors3, colors4, colors5, colors6, colors7};
    float2 alphas[8] = {alphas0, alphas1, alphas2, alphas3, alphas4, alphas5, alphas6, alphas7};
    Gradient result;
    result.type = type;
    result.colorsLength = colorsLength;
    result.alphasLength = alphasLength;
    result.colors = colors;
    result.alphas = alphas;
    return result;
}

// limn computes colours linearly.
bool IsGammaSpace() { return false; }

// The sign is that of a projection turned upside down, which limn has none of.
float4 ComputeScreenPos(float4 pos, float projectionSign) { return ComputeScreenPos(pos); }
