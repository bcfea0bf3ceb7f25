// Quads of six vertices without a mesh, in pixels of a target, y down.
#pragma once

float4 PixelToClip(float2 pixel, float2 size)
{
    return float4(pixel.x / size.x * 2.0 - 1.0, 1.0 - pixel.y / size.y * 2.0, 0.5, 1.0);
}

// Two triangles of six vertices; x, y: 0 or 1.
float2 QuadCorner(uint vertexID)
{
    uint corner = vertexID % 6u;
    return float2(corner == 1u || corner == 2u || corner == 4u ? 1.0 : 0.0,
                  corner == 2u || corner == 4u || corner == 5u ? 1.0 : 0.0);
}
