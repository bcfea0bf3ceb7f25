// Sampling functions of the old shading language that HLSL has lost or never had in every form.
#pragma once
#include "limn/Platform.hlsl"

float4 tex2Dproj(sampler2D tex, float3 coord) { return tex2D(tex, coord.xy / coord.z); }
float4 tex2Dproj(sampler2D tex, float4 coord) { return tex2D(tex, coord.xy / coord.w); }
float4 texCUBEproj(samplerCUBE tex, float4 coord) { return texCUBE(tex, coord.xyz / coord.w); }

// Unity has no textures of one dimension: what shaders call so are rows of two-dimensional ones.
#define sampler1D sampler2D
float4 tex1D(sampler2D tex, float x) { return tex2D(tex, float2(x, 0.5)); }
float4 tex1D(sampler2D tex, float x, float dx, float dy)
{
    return tex2D(tex, float2(x, 0.5), float2(dx, 0.0), float2(dy, 0.0));
}
float4 tex1Dgrad(sampler2D tex, float x, float dx, float dy) { return tex1D(tex, x, dx, dy); }
float4 tex1Dlod(sampler2D tex, float4 coord)
{
    return tex2Dlod(tex, float4(coord.x, 0.5, 0.0, coord.w));
}
float4 tex1Dbias(sampler2D tex, float4 coord)
{
    return tex2Dbias(tex, float4(coord.x, 0.5, 0.0, coord.w));
}
float4 tex1Dproj(sampler2D tex, float2 coord) { return tex1D(tex, coord.x / coord.y); }
float4 tex1Dproj(sampler2D tex, float4 coord) { return tex1D(tex, coord.x / coord.w); }
