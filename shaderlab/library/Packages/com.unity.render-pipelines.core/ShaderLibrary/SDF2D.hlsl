// Distances to shapes around the origin, negative inside.
#pragma once

float CircleSDF(float2 position, float radius) { return length(position) - radius; }
// bound: half the size
float RectangleSDF(float2 position, float2 bound)
{
    float2 beyond = abs(position) - bound;
    return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0);
}
// About: the gradient's length is taken for 1. r: half the axes
float EllipseSDF(float2 position, float2 r)
{
    float size = length(position / r);
    return size * (size - 1.0) / length(position / (r * r));
}
