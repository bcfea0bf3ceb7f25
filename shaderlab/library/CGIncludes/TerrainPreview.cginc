// The grid that shows a brush over a terrain, built out of vertex numbers. Scripts set the globals.
#pragma once
#ifndef TERRAIN_PREVIEW_INCLUDED
#define TERRAIN_PREVIEW_INCLUDED

sampler2D _Heightmap;
float2 _HeightmapUV_PCPixelsX, _HeightmapUV_PCPixelsY, _HeightmapUV_Offset;
float3 _ObjectPos_PCPixelsX, _ObjectPos_PCPixelsY, _ObjectPos_HeightMapSample, _ObjectPos_Offset;
float2 _BrushUV_PCPixelsX, _BrushUV_PCPixelsY, _BrushUV_Offset;
float3 _TerrainObjectToWorldOffset;
float4 _QuadRez; // quads in x and y, vertices, pixels from vertex to vertex

float2 PaintContextPixelsToHeightmapUV(float2 pcPixels)
{
    return _HeightmapUV_Offset + pcPixels.x * _HeightmapUV_PCPixelsX +
           pcPixels.y * _HeightmapUV_PCPixelsY;
}
float3 PaintContextPixelsToObjectPosition(float2 pcPixels, float heightmapSample)
{
    return _ObjectPos_Offset + pcPixels.x * _ObjectPos_PCPixelsX +
           pcPixels.y * _ObjectPos_PCPixelsY + heightmapSample * _ObjectPos_HeightMapSample;
}
float2 PaintContextPixelsToBrushUV(float2 pcPixels)
{
    return _BrushUV_Offset + pcPixels.x * _BrushUV_PCPixelsX + pcPixels.y * _BrushUV_PCPixelsY;
}
// Terrains are neither turned nor scaled.
float3 TerrainObjectToWorldPosition(float3 objectPosition)
{
    return objectPosition + _TerrainObjectToWorldOffset;
}

// Six vertices a quad, row by row: corners (0,0) (0,1) (1,1) and (1,1) (1,0) (0,0).
float2 BuildProceduralQuadMeshVertex(uint vertexID)
{
    uint quadsAcross = uint(_QuadRez.x);
    uint quad = vertexID / 6u;
    uint corner = vertexID % 6u;
    float2 offset = float2(corner >= 2u && corner <= 4u, corner >= 1u && corner <= 3u);
    return (float2(quad % quadsAcross, quad / quadsAcross) + offset) * _QuadRez.w;
}

// 1 on a line of a width in pixels at x = stripeX, 0 beside it.
float Stripe(in float x, in float stripeX, in float pixelWidth)
{
    float perPixel = max(length(float2(ddx(x), ddy(x))), 0.00001);
    return saturate(0.5 + 0.5 * (0.5 * pixelWidth - abs(x - stripeX) / perPixel));
}
#endif
