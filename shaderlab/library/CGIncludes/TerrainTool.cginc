// Brushes of the terrain's tools: where a texel of what is painted on lies in the brush.
#pragma once
#ifndef TERRAIN_TOOL_INCLUDED
#define TERRAIN_TOOL_INCLUDED

float4 _PCUVToBrushUVScales; // xy: of u, zw: of v
float2 _PCUVToBrushUVOffset;

float2 PaintContextUVToBrushUV(float2 pcUV)
{
    return pcUV.x * _PCUVToBrushUVScales.xy + pcUV.y * _PCUVToBrushUVScales.zw +
           _PCUVToBrushUVOffset;
}
float2 PaintContextUVToHeightmapUV(float2 pcUV) { return pcUV; }
#endif
