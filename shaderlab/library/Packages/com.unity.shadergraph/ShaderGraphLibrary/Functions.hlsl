// What generated shaders call in every pipeline.
#pragma once
#ifndef UNITY_GRAPHFUNCTIONS_INCLUDED
#define UNITY_GRAPHFUNCTIONS_INCLUDED
#include "limn/GammaSpace.hlsl"

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

float4 ComputeScreenPos(float4 pos, float projectionSign)
{
    return limn_ScreenPos(pos, projectionSign);
}

// The blending of gradients that are even to the eye (Ottosson's Oklab).
float3 LinearToOklab(float3 rgb)
{
    const float3x3 cones = {0.4122214708, 0.5363325363, 0.0514459929,
                            0.2119034982, 0.6806995451, 0.1073969566,
                            0.0883024619, 0.2817188376, 0.6299787005};
    const float3x3 lab = {0.2104542553, 0.7936177850, -0.0040720468,
                          1.9779984951, -2.4285922050, 0.4505937099,
                          0.0259040371, 0.7827717662, -0.8086757660};
    return mul(lab, pow(max(mul(cones, rgb), 0.0), 1.0 / 3.0));
}
float3 OklabToLinear(float3 lab)
{
    const float3x3 roots = {1.0, 0.3963377774, 0.2158037573,
                            1.0, -0.1055613458, -0.0638541728,
                            1.0, -0.0894841775, -1.2914855480};
    const float3x3 rgb = {4.0767416621, -3.3077115913, 0.2309699292,
                          -1.2684380046, 2.6097574011, -0.3413193965,
                          -0.0041960863, -0.7034186147, 1.7076147010};
    float3 root = mul(roots, lab);
    return mul(rgb, root * root * root);
}

// What a pipeline that does not say otherwise knows of its scene: nothing.
float shadergraph_SampleSceneDepth(float2 uv) { return 1.0; }
float3 shadergraph_SampleSceneColor(float2 uv) { return float3(0, 0, 0); }
float3 shadergraph_SampleSceneNormal(float2 uv) { return float3(0, 0, 0); }
float3 shadergraph_ReflectionProbe(float3 viewDir, float3 normalOS, float lod)
{
    return float3(0, 0, 0);
}
void shadergraph_Fog(float3 position, out float4 color, out float density)
{
    color = float4(0, 0, 0, 0);
    density = 0.0;
}
// Since Unity 6 with the pixel's place.
float3 shadergraph_BakedGI(float3 positionWS, float3 normalWS, float2 uvStaticLightmap,
                           float2 uvDynamicLightmap, bool applyScaling)
{
    return float3(0, 0, 0);
}
float3 shadergraph_BakedGI(float3 positionWS, float3 normalWS, uint2 positionSS,
                           float2 uvStaticLightmap, float2 uvDynamicLightmap, bool applyScaling)
{
    return float3(0, 0, 0);
}

#ifndef SHADERGRAPH_SAMPLE_SCENE_DEPTH
#define SHADERGRAPH_SAMPLE_SCENE_DEPTH(uv) shadergraph_SampleSceneDepth(uv)
#endif
#ifndef SHADERGRAPH_SAMPLE_SCENE_COLOR
#define SHADERGRAPH_SAMPLE_SCENE_COLOR(uv) shadergraph_SampleSceneColor(uv)
#endif
#ifndef SHADERGRAPH_SAMPLE_SCENE_NORMAL
#define SHADERGRAPH_SAMPLE_SCENE_NORMAL(uv) shadergraph_SampleSceneNormal(uv)
#endif
#ifndef SHADERGRAPH_BAKED_GI
#define SHADERGRAPH_BAKED_GI shadergraph_BakedGI
#endif
#ifndef SHADERGRAPH_REFLECTION_PROBE
#define SHADERGRAPH_REFLECTION_PROBE(viewDir, normalOS, lod) \
    shadergraph_ReflectionProbe(viewDir, normalOS, lod)
#endif
#ifndef SHADERGRAPH_FOG
#define SHADERGRAPH_FOG(position, color, density) shadergraph_Fog(position, color, density)
#endif
#ifndef SHADERGRAPH_AMBIENT_SKY
#define SHADERGRAPH_AMBIENT_SKY float3(0, 0, 0)
#endif
#ifndef SHADERGRAPH_AMBIENT_EQUATOR
#define SHADERGRAPH_AMBIENT_EQUATOR float3(0, 0, 0)
#endif
#ifndef SHADERGRAPH_AMBIENT_GROUND
#define SHADERGRAPH_AMBIENT_GROUND float3(0, 0, 0)
#endif
#ifndef SHADERGRAPH_OBJECT_POSITION
#define SHADERGRAPH_OBJECT_POSITION GetAbsolutePositionWS(UNITY_MATRIX_M._m03_m13_m23)
#endif
#ifndef SHADERGRAPH_RENDERER_BOUNDS_MIN
#define SHADERGRAPH_RENDERER_BOUNDS_MIN float3(0, 0, 0)
#endif
#ifndef SHADERGRAPH_RENDERER_BOUNDS_MAX
#define SHADERGRAPH_RENDERER_BOUNDS_MAX float3(0, 0, 0)
#endif
#endif
